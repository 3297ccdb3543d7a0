"""The checkpoints of events I, II and III made from t = 0: each must be the one that is shipped
(./reproduce.sh NAME --from-scratch)."""

from rupture.errors import Failure
from rupture.once import measured, run
from rupture.programs import output_of

from claims.samples import every
from events import CHECKPOINTS, shown_events
from measure.ways import PRIMARY
from measure.fronts import is_fast_only


def choose(events):
    """{name: event}. Event I is the first that is fast-slow-fast in words, event II the second;
    event III is the first after event I that spans the interface and is fast everywhere."""
    slow = [event for event in events if event["fast_slow_fast"]] + [None, None]
    later = (event for event in events if slow[0] and event["t_start"] > slow[0]["t_start"])
    chosen = {
        "fast-slow-fast": slow[0],
        "fast-only": next(filter(is_fast_only, later), None),
        "second-slow": slow[1],
    }
    if missing := [name for name, event in chosen.items() if event is None]:
        raise Failure(f"this load has no event {' and no '.join(missing)}: load for longer")
    return chosen


def same_content(made, shipped):
    sums = [output_of("analyze", "checksum", path).strip() for path in (made, shipped)]
    if sums[0] != sums[1]:
        raise Failure(
            f"the content of {shipped.name} is not what a load gives now: {sums[0]}"
            " (see checkpoints/README.md)"
        )
    return {"sha256": sums[0]}


def made_anew(name, t_start):
    until = round(t_start - 0.5e-3, 7)
    made = run(f"load -o {name}.h5 --until {until}")[f"{name}.h5"]
    return measured(same_content, made, CHECKPOINTS / f"{name}.h5")


def check():
    """Raises Failure if one of them is not."""
    chosen = choose(shown_events("reference")[PRIMARY])
    points = [(name, event["t_start"]) for name, event in chosen.items()]
    every(made_anew, points, "checkpoints from t = 0")
