# Figure S5: effective static friction for two shapes of phi. See README.md.
figure("figS5", tables=["strength", "displacement"], reads=["figS5/strength.csv"])
