"""Networks without grains: what `jamscape measure network.csv` says, on networks whose forces are decimals."""
import numpy as np

import persistence as homology
import program
from compare import compare
from measures.persistence import binned, totals
from options import spelled, with_settings

SETTINGS = [{}, {"rough_includes_edge": True}, {"clamp": 0.0}]


def network(vertices, edges, seed):
    """A random network with forces of one decimal and mean 1, so that lifetimes fall on the borders of the bins."""
    random = np.random.default_rng(seed)
    chosen = set()
    while len(chosen) < edges:
        a, step = random.integers(vertices), random.integers(1, 4)
        chosen.add((int(a), int((a + step * step) % vertices)))
    tenths = np.maximum(random.poisson(9, edges), 1)
    tenths[0] += max(10 * edges - tenths.sum(), 0)
    while tenths.sum() > 10 * edges:
        tenths[np.argmax(tenths)] -= 1
    links = sorted({(min(e), max(e)) for e in chosen})
    return [(a, b, t / 10) for (a, b), t in zip(links, tenths)]


def audit(folder, differences):
    """Compares two networks; the number of columns compared."""
    compared = 0
    for seed, (vertices, edges) in enumerate([(40, 70), (60, 150)]):
        rows = network(vertices, edges, seed)
        file = folder / f"network-{seed}.csv"
        file.write_text("i,j,force\n" + "".join(f"{a},{b},{f}\n" for a, b, f in rows))
        ends, force = np.array([row[:2] for row in rows]), np.array([row[2] for row in rows])
        for settings in SETTINGS:
            options = with_settings(settings)
            sets = [part for key, value in spelled(settings).items() for part in ("--set", f"measure.{key}={value}")]
            table = program.table(program.call("measure", file, *sets))
            weights = force / force.mean()
            weights = np.minimum(weights, options.clamp) if options.clamp else weights
            grains = np.unique(ends)
            p = homology.diagram(grains, ends, weights, 2, 1)
            ours = {"vertices": len(grains), "edges": len(rows), "mean_force": force.mean(), "z": 2 * len(rows) / len(grains),
                    **binned(p, options), **totals(p)}
            for column in table:
                compared += 1
                found = compare(column, table, ours[column]) if column in ours else [(0, "there", "no audit", "")]
                differences += [(f"network {seed} {settings}", "measure", column, row, repr(a), repr(b), allowed)
                                for row, a, b, allowed in found]
    return compared
