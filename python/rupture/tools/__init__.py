"""The programs that are written in Python."""
