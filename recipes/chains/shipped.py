"""The checkpoints in checkpoints/, computed anew from t = 0: what --from-scratch does first."""

from chains.chain import RECIPES
from chains.points import Chains
from chains.store import result_of
from reproduce.project import SHARE
from rupture.errors import Failure

FILES = [str(RECIPES / f"fig2/event_{number}.ini") for number in ("I", "II", "III")]


def compare():
    """Raises Failure if one is not the state that the manifest names."""
    chains, known = Chains(), (SHARE / "checkpoints/manifest").read_text(encoding="utf-8")
    for chain in map(chains.load, FILES):
        if not (points := chains.points(chain)):
            raise Failure(f"{chain.shown}: the load has no such event")
        result, (name,) = result_of(points[0].path), chain.keep
        if f"{result['checksums'].get(name)}  {name}\n" not in known:
            said = result["sentence"] or "it is another state than the manifest names"
            raise Failure(f"{points[0].file(name)}: {said} (see checkpoints/README.md)")
