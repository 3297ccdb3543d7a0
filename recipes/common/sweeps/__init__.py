"""Sweeps: files, points and batches; a user's own sweep from its file to its table and picture."""
