"""What is measured: fronts and ways to measure them, events, slip, maps; tables, rank tests."""
