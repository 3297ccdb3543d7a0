"""Numbers of things, in words."""


def plural(number, noun):
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"
