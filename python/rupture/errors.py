# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

"""What goes wrong."""


class Failure(Exception):
    """One sentence: what was given, what was expected, what to do."""
