"""Users' sweeps: files with commands as one types them, their points, and the plan by which Ninja
runs them. docs/sweeps.md says how a file is written, docs/decisions/0025-ninja.md why Ninja."""
