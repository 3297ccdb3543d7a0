figure("figS3", tables=["profiles"], reads=["figS3/profiles.csv"])
