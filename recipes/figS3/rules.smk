# Figure S3: the prestress of prepared interfaces. The chain of commands is in README.md.
use rule figure as figS3 with:
    input:
        profiles=f"{DATA}/figS3/profiles.csv",
        **scripts_of("figS3"),
    output: results_of("figS3", pictures=["figS3"], tables=["profiles"])
    log: f"{LOGS}/figS3.log"
