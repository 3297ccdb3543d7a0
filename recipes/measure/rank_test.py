"""Do the members of one group have lower values than those of the other, stratum by stratum?

A stratum is (values of the first group, values of the second); only pairs from the same stratum are
compared.
"""

import math

import numpy as np
from scipy.stats import norm, rankdata, wilcoxon


def comparable(strata):
    """The strata in which both groups have members."""
    return [(first, second) for first, second in strata if len(first) and len(second)]


def share_of_lower(strata):
    """Share of pairs in which the member of the first group has the lower value; ties count half.
    0.5 without any difference; None without pairs."""
    wins = pairs = 0.0
    for first, second in comparable(strata):
        difference = np.subtract.outer(np.array(second), np.array(first))
        wins += np.sum(difference > 0) + 0.5 * np.sum(difference == 0)
        pairs += difference.size
    return float(wins / pairs) if pairs else None


def van_elteren(strata):
    """Van Elteren's stratified rank-sum test: one-sided p for lower values in the first group,
    normal approximation, corrected for ties; None if no stratum has both groups."""
    statistic = variance = 0.0
    for first, second in comparable(strata):
        n, m = len(first), len(second)
        ranks = rankdata([*first, *second])
        weight = 1 / (n + m + 1)
        statistic += weight * (ranks[:n].sum() - n * (n + m + 1) / 2)
        variance += weight**2 * n * m * np.var(ranks, ddof=1) / (n + m)
    if variance == 0:
        return None
    return float(norm.cdf(statistic / math.sqrt(variance)))


def chances_of_rank_sums(doubled_ranks, n):
    """Chance of each sum that n of these ranks can have; ranks and sums are doubled, so that those
    of ties are whole."""
    ways = np.zeros((n + 1, sum(doubled_ranks) + 1))
    ways[0, 0] = 1
    for rank in doubled_ranks:
        ways[1:, rank:] += ways[:-1, : ways.shape[1] - rank]
    return ways[n] / ways[n].sum()


def permutation(strata):
    """Permutation test for lower values in the first group, which takes the values as given: the
    share of all ways to hand out the groups within each stratum in which as many pairs or more
    have the lower value in the first group. Exact; None if no stratum has both groups."""
    chances, observed = np.ones(1), 0
    for first, second in comparable(strata):
        doubled = np.rint(2 * rankdata([*first, *second])).astype(int)
        observed += doubled[: len(first)].sum()
        chances = np.convolve(chances, chances_of_rank_sums(doubled, len(first)))
    return float(chances[: observed + 1].sum()) if len(chances) > 1 else None


def signed_rank(shares):
    """Wilcoxon's signed-rank test, one-sided: are shares of independent repetitions above 0.5?
    Those that are 0.5 do not count."""
    differences = np.array([share - 0.5 for share in shares if share != 0.5])
    return float(wilcoxon(differences, alternative="greater").pvalue)
