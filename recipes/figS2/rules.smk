from events.continuations import WITHOUT_SLOW_SLIP

EVENTS_OF["figS2"] = ("simplified-01", "fast-slow")
FIGS2_RUNS = {"event": "--for 0.015", "no-slow-slip": WITHOUT_SLOW_SLIP}
RUNS |= {f"figS2/{name}": run("figS2/before", options) for name, options in FIGS2_RUNS.items()}


# The other fast-slow events of the load are run without slow slip by ensemble/without_slow_slip.py.
figure(
    "figS2",
    tables=["front-speed", "events"],
    reads=[
        *(f"figS2/{run}-{of}" for run in FIGS2_RUNS for of in ("front.json", "record.h5")),
        "ensemble/simplified-01-continued.json",
    ],
)
