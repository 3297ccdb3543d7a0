"""Sweeps: their files, points and batches; a user's own sweep from the file to its table and picture."""
