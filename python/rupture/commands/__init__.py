"""What `rupture.once` is made of: what a command is (identity, code), where its results are
(store), who runs it (processes, pool), and how these do it once (making)."""
