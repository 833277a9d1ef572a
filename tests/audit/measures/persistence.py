"""Persistence diagrams and what is counted in them."""
import numpy as np

import persistence as homology
from borders import exceeds, multiples, reaches
from network import clamped, force_network
from registry import Sum, audits

CACHE = {}


def points(packing, options):
    """Points of the diagram of the force network, weights clamped."""
    key = id(packing), options.force, options.clamp, options.remove_rattlers
    if key not in CACHE:
        network = force_network(packing, options)
        CACHE[key] = homology.diagram(network.grains, network.edges, clamped(network, options), packing.dimension,
                                      packing.dimension - 1)
    return CACHE[key]


@audits("diagram")
def diagram(packing, options):
    p = points(packing, options)
    return {"dimension": p[:, 0].astype(int), "birth": p[:, 1], "death": p[:, 2], "essential": p[:, 3].astype(int)}


def binned(p, options):
    """Points of a diagram by strength."""
    counts = {}
    lasting = exceeds(p[:, 1] - p[:, 2], 0, p[:, 1])
    p = p[lasting | ((p[:, 0] == 0) & (p[:, 1] == 0))]  # of length 0 only isolated grains
    for k in (0, 1):
        birth, life = p[p[:, 0] == k, 1], (p[:, 1] - p[:, 2])[p[:, 0] == k]
        size = np.maximum(birth, 0.1)
        rough = ~exceeds(life, 0.1, size) if options.rough_includes_edge else ~reaches(life, 0.1, size)
        strong, medium = reaches(birth, 2.5), reaches(birth, 1)
        bins = {"rough": rough, "strong": ~rough & strong, "medium": ~rough & medium & ~strong, "weak": ~rough & ~medium}
        counts.update({f"b{k}_{name}": int(inside.sum()) for name, inside in bins.items()})
    return counts


def totals(p):
    return {f"tp{k}": float((p[:, 1] - p[:, 2])[p[:, 0] == k].sum()) for k in (0, 1, 2)}


@audits("persistence_bins")
def persistence_bins(packing, options):
    return binned(points(packing, options), options)


@audits("total_persistence")
def total_persistence(packing, options):
    return totals(points(packing, options))


@audits("betti")
def betti(packing, options):
    p, theta = points(packing, options), multiples(options.betti_max, options.betti_step)
    columns = {"threshold": Sum(theta, 1)}
    for k in (0, 1, 2):
        own = p[p[:, 0] == k]
        gone = reaches(own[:, 2], theta[:, None]) & (own[:, 3] == 0)
        alive = reaches(own[:, 1], theta[:, None]) & ~gone
        columns[f"b{k}"] = alive.sum(axis=1)
    return columns
