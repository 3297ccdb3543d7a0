# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

"""The paper's claims beside what was measured."""
