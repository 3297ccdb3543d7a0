"""Users' sweeps (docs/sweeps.md): files that say which points there are and which commands each of
them runs, and nothing else. `rupture.once` runs them."""
