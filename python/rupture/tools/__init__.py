# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

"""The programs that are written in Python."""
