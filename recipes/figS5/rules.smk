figure("figS5", tables=["strength", "displacement"], reads=["figS5/strength.csv"])
