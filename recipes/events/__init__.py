# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

"""Rupture events: which are shown, kinds of fronts, claims about an event and its continuations."""
