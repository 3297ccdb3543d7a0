"""What ./reproduce.sh NAME --dry-run prints: the commands of all points, as one types them."""

from chains.chain import SCRIPT
from chains.check import check
from chains.points import Chains, Waiting


def chains_of(chains, recipe):
    """Those that its figure reads, each behind those that its points come from."""
    found: list = []
    for chain, _ in chains.read_by(chains.recipe(recipe)):
        check(chains, chain)
        lineage = [chain]
        while above := chains.above(lineage[-1]):
            lineage.append(above)
        found += reversed(lineage)
    return dict.fromkeys(found)


def typed(line):
    """A command as one types it in the folder of the project."""
    is_script = line.startswith(f"{SCRIPT} ")
    return f"python3 -m data.call {line[len(SCRIPT) + 1:]}" if is_script else f"rupture {line}"


def preview(recipe):
    """Lines; comments say which point it is, and where its base comes from."""
    chains = Chains()
    for chain in chains_of(chains, recipe):
        try:
            points = chains.points(chain)
        except Waiting:
            yield f"# {chain.name}: which points there are depends on what other points report"
            continue
        for point in points:
            yield f"# {point.described}"
            if point.base and point.base["of"]:
                yield f"# {point.base['shown']} is {point.base['file']}"
            yield from map(typed, point.commands.values())
            yield ""
