"""What ./reproduce.sh NAME --dry-run prints: the commands of all points, as one types them."""

from chains.chain import SCRIPT
from chains.plan import selected
from chains.points import Waiting
from chains.selection import Chains


def typed(line):
    """A command as one types it in the folder of the project."""
    is_script = line.startswith(f"{SCRIPT} ")
    return f"python3 -m chains.script {line[len(SCRIPT) + 1:]}" if is_script else f"rupture {line}"


def in_order(points):
    """Each behind those that it comes from, and those that its scripts read."""
    for point in points:
        listed = [one for _, others in point.lists.values() for one in others]
        yield from in_order([*listed, *([point.of] if point.of else [])])
        yield point


def preview(recipe):
    """Lines; comments say which point it is, and where its base comes from."""
    chains, points, said = Chains(), [], set()
    figure = chains.recipe(recipe)
    for chain, condition in chains.read_by(figure):
        try:
            points += selected(chains, chain, condition)
        except Waiting:
            yield f"# {chain.name}: which points there are depends on what other points report"
            points += chains.deciding
    for point in in_order(points):
        if point.path not in said:
            yield f"# {point.described}"
            if point.base and point.base["of"]:
                yield f"# {point.base['shown']} is {point.base['file']}"
            yield from map(typed, point.commands.values())
            yield ""
        said.add(point.path)
