"""What ./reproduce.sh NAME --dry-run prints: the commands of all points, as one types them."""

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
            yield from (f"rupture {line}" for line in point.commands.values())
            yield ""
