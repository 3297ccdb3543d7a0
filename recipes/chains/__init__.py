"""Chains: files with commands as one types them, their points, and the plan by which Ninja runs
them. recipes/README.md says how a file is written, docs/decisions/0025-ninja.md why it is Ninja."""
