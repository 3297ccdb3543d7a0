"""Do the members of one group have lower values than those of the other, stratum by stratum?"""

import numpy as np


def share_of_lower(strata):
    """Share of pairs in which the member of the first group has the lower value; ties count half.
    0.5 without any difference; None without pairs. A stratum is (values of the first group, values
    of the second); only pairs from the same stratum are compared."""
    wins = pairs = 0.0
    for first, second in strata:
        difference = np.subtract.outer(np.array(second), np.array(first))
        wins += np.sum(difference > 0) + 0.5 * np.sum(difference == 0)
        pairs += difference.size
    return float(wins / pairs) if pairs else None
