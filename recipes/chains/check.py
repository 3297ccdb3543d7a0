"""Finds names that lead nowhere before anything runs, also in chains whose points are not known
yet; and what a sweep must not do."""

import re

from chains.chain import BASE, kept_names
from chains.point import HOLE, PROGRAMS, without_time
from chains.points import LAST_BEFORE
from rupture.errors import UsageError
from chains.programs import check_expression, given_in
from chains.ini import check_known, existing, words_of
from chains.values import is_expression

OWN = ("values", "base")  # holes that are no names


def check(chains, chain):
    """The chain, and those that it comes from. Raises UsageError with the file and the line."""
    origins = [chain]
    while above := chains.above(origins[-1]):
        if above in origins:
            raise chain.error("chain", "points", "points cannot come from themselves")
        origins.append(above)
    names = names_of(chains, chain)
    if not chain.commands:
        raise UsageError(f"{chain.shown}: it has no section [commands]")
    for name in chain.commands:
        with chain.errors_at("commands", name):
            check_command(chains.programs, chain, name, names)
    for section, lists in chain.lists.items():
        for name, texts in lists.items():
            with chain.errors_at(section, name):
                for text in filter(is_expression, texts):
                    check_expression(text[1:-1], names)
    if chain.points["condition"]:
        with chain.errors_at("chain", "points"):
            check_expression(chain.points["condition"], names)
    with chain.errors_at("chain", "base"):
        check_base(chains, chain, names)
    check_kept(chain)
    _ = chain.needs
    if above := chains.above(chain):
        check(chains, above)


def names_of(chains, chain):
    """All names that its points have."""
    above = chains.above(chain)
    names = names_of(chains, above) if above else set()
    if of_list := chain.points["list"]:
        with chain.errors_at("chain", "points"):
            check_expression(of_list, names)
        names |= {chain.points["element"]}
    values = {name for lists in chain.lists.values() for name in lists}
    if chain.lists.keys() - {"values"}:
        values |= {"variant"}
    for name in {*values, chain.points["element"]}.intersection(chain.commands):
        sentence = f"'{name}' is the name of a value, too; take another one"
        raise chain.error("commands", name, sentence)
    return names | values | set(chain.commands)


def check_command(programs, chain, name, names):
    """It runs a program that computes, and writes in the folder of its point."""
    line = chain.commands[name]
    words_of(line)  # which must be possible
    check_known(line.split()[0], PROGRAMS, "there is no program")
    for hole in HOLE.findall(line):
        if hole == "base" and "base" not in chain.keys:
            raise UsageError(f"'{line}': {{base}} needs base = FILE in [chain]")
        if hole not in (*OWN, *names):
            check_expression(hole, names)
    if re.search(r"[{}]", HOLE.sub("", line)):
        raise UsageError(f"'{line}': a brace is missing")
    list(given_in(line, programs))


def check_base(chains, chain, names):
    """A chain above must keep it; of a name with holes, what stands before the first of them."""
    if not (found := BASE.fullmatch(chain.keys.get("base", ""))):
        return
    for hole in HOLE.findall(found["file"]):
        if not re.fullmatch(r"[\d.]+", hole):
            check_expression(hole.removeprefix(LAST_BEFORE), names)
    if found["chain"]:
        kept, path = chain, existing(chain.path.parent / f"{found['chain']}.ini").resolve()
        while kept.path.resolve() != path:
            if not (kept := chains.above(kept)):
                raise UsageError(f"its points do not come from {found['chain']}: see 'points'")
        start = found["file"].partition("{")[0]
        if not any(name.startswith(start) for name in kept.keep):
            keeps = ", ".join(kept.keep) or "nothing"
            raise UsageError(f"{kept.shown} does not keep {found['file']} (it keeps {keeps})")


def check_kept(chain):
    """A command must write what is kept."""
    words = {word for line in chain.commands.values() for word in words_of(line)}
    for word in chain.keep_words:
        with chain.errors_at("chain", "keep"):
            name = kept_names(word)[0]
            if name not in words and without_time(name) not in words:
                raise UsageError(f"no command writes {word}")
