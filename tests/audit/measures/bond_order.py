"""Six-fold order of the bonds in the plane."""
import numpy as np

from contacts import pairs
from registry import Sum, audits


def bonds(packing):
    """Angles of each grain's bonds, from centre to centre of every touching pair, sorted in [-pi, pi)."""
    angles = [[] for _ in range(packing.count)]
    for i, j, *image in pairs(packing)[0]:
        n = packing.x[j] + image * packing.sides - packing.x[i]
        angles[i].append(np.arctan2(n[1], n[0]))
        angles[j].append(np.arctan2(-n[1], -n[0]))
    return [np.sort(np.where(np.array(a) >= np.pi, -np.pi, a)) for a in angles]


@audits("bond_order")
def bond_order(packing, options):
    printed, closed, local, complex_sum = 0.0, 0.0, 0.0, 0j
    if packing.dimension == 2:
        for theta in bonds(packing):
            if len(theta) == 0:
                continue
            if len(theta) > 1:
                gaps = np.diff(theta)
                printed += np.cos(6 * gaps).mean()
                closed += np.cos(6 * np.append(gaps, theta[0] - theta[-1])).mean()
            phase = np.exp(6j * theta).mean()
            local += abs(phase)
            complex_sum += phase
    n = packing.count
    return {"psi6": Sum(printed / n, 1), "psi6_closed": Sum(closed / n, 1), "psi6_local": Sum(local / n, 1),
            "psi6_global": Sum(abs(complex_sum) / n, 1)}
