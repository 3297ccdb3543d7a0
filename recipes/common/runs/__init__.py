"""Runs that several recipes share, and what rules have in common."""
