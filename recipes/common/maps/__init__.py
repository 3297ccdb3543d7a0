"""Maps of front types against prestress and width of phi."""
