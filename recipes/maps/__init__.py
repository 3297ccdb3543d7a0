# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

"""Maps of front types against prestress and width of phi."""
