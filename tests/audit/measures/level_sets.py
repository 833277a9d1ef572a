"""Clusters of the network above each threshold."""
import numpy as np

import persistence as homology
from borders import exceeds, multiples
from measures.percolation import percolating
from network import clamped, components, force_network
from registry import Sum, audits


def classes(network, weights, dimension, options):
    """Points of H1 and H2; a hollow tetrahedron is a void, for H2 only."""
    p = homology.diagram(network.grains, network.edges, weights, dimension, dimension - 1)
    if options.tetrahedra == "hollow":
        hollow = homology.diagram(network.grains, network.edges, weights, 2, 2)
        p = np.concatenate([p[p[:, 0] < 2], hollow[hollow[:, 0] == 2]])
    return p


@audits("level_sets")
def level_sets(packing, options):
    network = force_network(packing, options)
    weights, n = clamped(network, options), packing.count
    theta = multiples(options.level_max, options.level_step)
    names = ("b0", "b1", "b2", "clusters", "cluster_grains", "percolating_x", "percolating_y", "percolating_z")
    counts = {name: [] for name in names}
    shape, fraction = [], []
    p = classes(network, weights, packing.dimension, options)
    for t in theta:
        inside = exceeds(weights, t)
        edges = network.edges[inside]
        label = components(n, edges)
        joins = percolating(packing, label, edges, network.image[inside])
        has_edge = np.zeros(n, dtype=bool)
        has_edge[edges.ravel()] = True
        roots = np.unique(label[has_edge])
        joined = np.array([joins[label == r].any() for r in roots], dtype=bool)
        grains = np.array([(label == r).sum() for r in roots], dtype=int)
        links = np.array([(label[edges[:, 0]] == r).sum() for r in roots], dtype=int)
        counts["b0"].append(len(roots))
        for k in (1, 2):
            counts[f"b{k}"].append(((p[:, 0] == k) & exceeds(p[:, 1], t) & ~(exceeds(p[:, 2], t) & (p[:, 3] == 0))).sum())
        counts["clusters"].append((~joined).sum())
        counts["cluster_grains"].append(grains[~joined].sum())
        for axis, name in enumerate("xyz"):
            along = joins[has_edge, axis].any() if axis < packing.dimension else False
            counts[f"percolating_{name}"].append(int(along))
        shape.append((links / grains).mean() if len(roots) else 0.0)
        fraction.append(grains[joined].sum() / n)
    columns = {name: np.array(values, dtype=int) for name, values in counts.items()}
    size = columns["cluster_grains"] / n
    columns.update({"threshold": Sum(theta, 1), "cluster_fraction": size, "percolating_grains": np.array(fraction),
                    "shape": np.array(shape), "mean_cluster": size / np.maximum(columns["clusters"], 1)})
    return columns
