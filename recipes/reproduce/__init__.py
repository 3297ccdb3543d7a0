# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

"""The commands of ./reproduce.sh."""
