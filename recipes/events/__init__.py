"""Rupture events: which are shown, kinds of fronts, the claims about an event and its continuations."""
