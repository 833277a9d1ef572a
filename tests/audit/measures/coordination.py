"""Counts of contacts."""
import numpy as np

from contacts import counts_with_walls, pair_counts, pairs, rattlers, wall_contacts
from network import force_network
from registry import audits


@audits("contacts")
def contacts(packing, options):
    network = force_network(packing, options)
    normal = force_network(packing, options.__class__(remove_rattlers=options.remove_rattlers))
    return {"contacts": len(network.edges), "wall_contacts": len(wall_contacts(packing)),
            "mean_normal_force": normal.mean}


@audits("coordination")
def coordination(packing, options):
    k = counts_with_walls(packing)
    bound = k[k >= 2]
    return {"z": pair_counts(packing).sum() / packing.count, "z_walls": k.sum() / packing.count,
            "z_multi": bound.mean() if len(bound) else 0.0, "rattlers": np.mean(k < 2)}


@audits("backbone")
def backbone(packing, options):
    kept = ~rattlers(packing)
    found, _ = pairs(packing)
    inside = kept[found[:, 0]] & kept[found[:, 1]]
    return {"z_backbone": 2 * inside.sum() / kept.sum() if kept.any() else 0.0, "grains_backbone": int(kept.sum())}
