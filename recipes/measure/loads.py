"""The events of the ensemble's loads, by load."""


def name_of(point):
    """Names the run from which a point comes: `load-403`, `decaying-01`, or `damping-half-403` of
    another chain of loads."""
    variant = point["variant"]
    is_drawn = "numerics.seed" in point.names  # the loads that figures show have seed 1
    seed = point["numerics.seed"] if is_drawn else 1
    return f"{'load' if variant == 'reference' else variant}-{seed:02.0f}"


def events_of(points):
    """{load: its events} of points of ensemble/events or shown_events."""
    return {name_of(point): point["measured"]["events"] for point in points}
