"""Fronts under choices that the paper leaves open, a result of our own."""

from itertools import chain

import numpy as np

from claims import paper
from claims.claim import number
from claims.own_result import OwnResult, write_own
from data.tables import read_rows, write_table
from events.choose_events import read_events
from events.event_claims import case_of_event
from events.units import name_of, of_ensemble
from maps.front_map import IMPOSSIBLE, band, place_of, type_on_map
from pictures.plotting import BLACK, BLUE, DOUBLE, SKY, VERMILION, figure, letter, save

LABELS = {  # name: for readers; the first is what the others are compared with
    "reference": "as settled",
    "damping-half": r"$\eta \times 0.5$",
    "damping-twice": r"$\eta \times 2$",
    "stiffness-initial": "$k_{ij}$ from initial $p$",
    "springs-linear": "linearised springs",
    "foundation-damped": "damped foundation",
    "contact-lost": "break without contact",
    "K-tenth": r"$K \times 0.1$, prepared",
    "decaying": "decaying law",
    "decaying-exact": "repinned at $f_{new}$",
}
OF_LOADS = {"load": "reference"}  # in the ensemble: here
SPEEDS = {  # quantity: of case_of_event()
    "fast before [c_s]": "fast before/c_s",
    "slowest [c_s]": "slowest/c_s",
    "mean slow [c_s]": "mean slow speed/c_s",
    "transition [L]": "from [L]",
}
SPAN, FOUND = "spanning events", "fast-slow-fast events"  # in words
SHARE, SLOW = "share fast-slow-fast", "fast-slow-fast below c_s/20"
COUNTS = (SPAN, FOUND, SHARE, SLOW)
SEEDS = 5  # of each choice
SIGMAS = (0.0, 0.285)  # sigma_bar of the prepared interfaces
PAPER = {
    "fast before [c_s]": paper.FAST,
    "slowest [c_s]": paper.SLOW,
    "transition [L]": paper.TRANSITIONS[0],
}
RANGE = (5, 95)  # [%]


# --- measuring -----------------------------------------------------------------------------


def by_choice(paths):
    """{choice: the spanning events of all its loads}"""
    found: dict[str, list] = {}
    for path in paths:
        name = name_of(path).rpartition("-")[0]
        events = [event for event in read_events(path) if event["spanning"]]
        found.setdefault(OF_LOADS.get(name, name), []).extend(events)
    return found


def measured_events(events):
    """COUNTS, and per quantity of SPEEDS its median and RANGE over the fast-slow-fast events. An
    event that is slow in words but nowhere below c_s/20 has no slow stretch to be measured."""
    cases = [case_of_event(event) for event in events if event["fast_slow_fast"]]
    values = {
        name: [case[key] for case in cases if case[key] is not None] for name, key in SPEEDS.items()
    }
    share = len(cases) / len(events) if events else None
    counts = len(events), len(cases), share, len(values["transition [L]"])
    return dict(zip(COUNTS, counts)) | {
        name: [np.median(found), *np.percentile(found, RANGE)] if found else [None] * 3
        for name, found in values.items()
    }


def slow_bands(rows, choice):
    """Lowest and highest tau_bar_0 of slow fronts per sigma_bar; None if there is no such front."""
    types = {
        place_of(row): type_on_map(row["type"]) or IMPOSSIBLE
        for row in rows
        if row["variant"] == choice
    }
    return {sigma: band(types, sigma) for sigma in SIGMAS} if types else {}


# --- results -------------------------------------------------------------------------------


def band_text(bands, sigma):
    if sigma not in bands:
        return "not varied"
    limits = bands[sigma]
    return f"{limits[0]:g} to {limits[1]:g}" if limits else "none"


def medians(found):
    """Counts and medians by name; none of a choice without loads."""
    counts = {name: found[name] for name in COUNTS if found}
    return counts | {name: found[name][0] for name in SPEEDS if found}


def own_result(events, bands):
    measured: dict = {}
    for choice in LABELS:
        slow = {f"slow tau_bar_0 at sigma_bar {s:g}": band_text(bands[choice], s) for s in SIGMAS}
        numbers = medians(events.get(choice)) | slow
        measured |= {f"{choice}: {name}": value for name, value in numbers.items()}
    question = "which choices that the paper leaves open move the fronts?"
    return OwnResult(id="choices", question=question, measured=measured)


def row_of(choice, found, bands):
    counts = [found[name] for name in COUNTS] if found else [None] * len(COUNTS)
    speeds = [found[name] if found else [None] * 3 for name in SPEEDS]
    return [choice, *counts, *chain(*speeds, *(bands.get(s) or (None, None) for s in SIGMAS))]


def write_choices(path, events, bands):
    speeds = [
        f"{name.replace(' [', f', {what} [')}"
        for name in SPEEDS
        for what in ("median", *(f"{part} %" for part in RANGE))
    ]
    slow = [f"{end} slow tau_bar_0 at sigma_bar {s:g}" for s in SIGMAS for end in ("least", "most")]
    rows = (row_of(choice, events.get(choice), bands[choice]) for choice in LABELS)
    write_table(path, ["choice", *COUNTS, *speeds, *slow], rows)


def summary(events, bands):
    """Text for the terminal: medians."""
    heads = ("", "span", "share", "fast/c_s", "slowest", "mean", "from/L", "slow at 0", "at 0.285")
    lines: list[tuple] = [heads]
    for choice in LABELS:
        found = medians(events.get(choice))
        numbers = [found.get(name, "") for name in (SPAN, SHARE, *SPEEDS)]
        cells = [f"{value:.3g}" if isinstance(value, float) else number(value) for value in numbers]
        lines.append((choice, *cells, *(band_text(bands[choice], sigma) for sigma in SIGMAS)))
    form = "{:18}{:>5}{:>7}{:>10}{:>9}{:>9}{:>8}  {:14}{}"
    return "\n".join(form.format(*line).rstrip() for line in lines) + "\n"


# --- picture -------------------------------------------------------------------------------


def draw_medians(axes, events, name, colour, shift=0.0):
    """A dot per choice, with a line over the range of its events. Grey: as settled."""
    for place, choice in enumerate(LABELS):
        median, *ends = events[choice][name] if choice in events else [None]
        if median is None:
            continue
        if choice == "reference":
            axes.axvline(median, color="0.85", linewidth=0.8, zorder=0)
        axes.plot(ends, [place + shift] * 2, color=colour, linewidth=0.8)
        axes.plot(median, place + shift, "o", color=colour)


def draw_paper(axes, value, text):
    axes.axvline(value, color=BLACK, linestyle="--", linewidth=0.8)
    axes.annotate(text, (value, -0.7), xytext=(2, 0), textcoords="offset points", va="center")


def draw_share(axes, events):
    for place, choice in enumerate(LABELS):
        if choice in events and events[choice][SHARE] is not None:
            axes.plot(events[choice][SHARE], place, "o", color=BLUE)
    axes.set(xlabel="share", xlim=(0, 1))


def draw_slow(axes, events):
    draw_medians(axes, events, "slowest [c_s]", BLUE, -0.12)
    draw_medians(axes, events, "mean slow [c_s]", SKY, 0.12)
    for label, colour in (("slowest", BLUE), ("mean", SKY)):
        axes.plot([], [], "o", color=colour, label=label)
    axes.set(xlabel="slow$/c_s$", xlim=(0, None))
    axes.legend(loc="lower right", handletextpad=0)


def draw_bands(axes, bands):
    for sigma, colour, shift in zip(SIGMAS, (BLUE, VERMILION), (-0.12, 0.12)):
        for place, choice in enumerate(LABELS):
            if limits := bands[choice].get(sigma):
                axes.plot(limits, [place + shift] * 2, "|-", color=colour)
        axes.plot([], [], color=colour, label=rf"$\bar\sigma = {sigma:g}$")
    axes.set(xlabel=r"$\bar\tau_0$ of slow fronts", xlim=(0, 0.4))
    axes.legend(loc="lower right", handlelength=1)


def draw(events, bands, stem):
    fig, panels = figure(DOUBLE, 0.45 * DOUBLE, ncols=5, sharey=True)
    draw_share(panels[0], events)
    draw_medians(panels[1], events, "fast before [c_s]", BLUE)
    panels[1].set(xlabel="fast before$/c_s$", xlim=(0, None))
    draw_slow(panels[2], events)
    draw_medians(panels[3], events, "transition [L]", BLUE)
    panels[3].set(xlabel="transition $[L]$", xlim=(0.2, 0.8))
    draw_bands(panels[4], bands)
    for axes, name, text in zip(panels[1:4], PAPER, ("$c_s/3$", "$c_s/100$", "$0.4 L$")):
        draw_paper(axes, PAPER[name], text)
    panels[0].set_yticks(range(len(LABELS)), LABELS.values())
    panels[0].set_ylim(len(LABELS) + 1, -1.1)  # room for what the lines and colours are
    for axes, text in zip(panels, "ABCDE"):
        letter(axes, text)
    save(fig, stem)


def paths_of(data):
    """Loads that are as settled, as many as of each choice, and those of the choices."""
    settled = (of_ensemble(data, name, "events")[:SEEDS] for name in ("load", "decaying"))
    return [*chain(*settled), *sorted(data.glob("choices/*-events.json"))]


def make(data, results):
    rows = read_rows(data / "choices/choices.csv")
    paths = paths_of(data)
    events = {choice: measured_events(found) for choice, found in by_choice(paths).items()}
    bands = {choice: slow_bands(rows, choice) for choice in LABELS}
    draw(events, bands, results / "choices")
    write_choices(results / "choices.csv", events, bands)
    write_own(results, [own_result(events, bands)])
    # The terminal shows the table instead of a line per number.
    (results / "summary.txt").write_text(summary(events, bands), encoding="utf-8")
    return []
