# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

"""The style of the pictures, and the panels that several share."""
