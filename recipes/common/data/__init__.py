"""Reading records, reports and tables; fits and tests."""
