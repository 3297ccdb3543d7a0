figure(
    "figS4",
    tables=["phi"],
    events=["second-slow"],
    reads=[
        *(f"second-slow{state}{of}" for state in ("", "/wider-start") for of in (".h5", "-phi.json")),
        *(f"second-slow{run}-{of}" for run in ("", "/wider") for of in ("front.json", "record.h5")),
    ],
)
