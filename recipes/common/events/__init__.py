"""Rupture events: which are shown, kinds of fronts, claims about an event and its continuations."""
