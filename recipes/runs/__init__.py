# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

"""Runs that several recipes share, and what rules have in common."""
