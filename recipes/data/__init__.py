# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

"""Reading records, reports and tables; fits and tests."""
