# Figure S3: the prestress of prepared interfaces. The chain of commands is in README.md.
figure("figS3", tables=["profiles"], reads=["figS3/profiles.csv"])
