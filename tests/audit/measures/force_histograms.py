"""Distributions of the contacts' forces."""
import numpy as np

from borders import counted, exceeds
from contacts import grain_pairs
from network import force_network
from registry import audits


def linear_bins(name, values, options):
    """Bins from 0 to contact_force_max, values in their mean."""
    edges = options.contact_force_max * np.arange(options.contact_force_bins + 1) / options.contact_force_bins
    count, width = counted(values, edges), options.contact_force_max / options.contact_force_bins
    norm = len(values) * width
    density = count / norm if norm else 0.0 * count
    return {name: (edges[1:] + edges[:-1]) / 2, "density": density, "count": count,
            "norm": np.full(len(count), norm, dtype=float)}


def from_walls(packing, options, places):
    """Whether places are at least force_margin mean diameters, at most a sixth of the width, from every wall."""
    inside = np.ones(len(places), dtype=bool)
    for a in range(packing.dimension):
        if not packing.periodic[a]:
            margin = min(options.force_margin * 2 * packing.radius.mean(), packing.sides[a] / 6)
            inside &= np.minimum(places[:, a] - packing.lo[a], packing.hi[a] - places[:, a]) >= margin * (1 - 1e-12)
    return inside if options.force_margin > 0 else inside | True


def single_forces(packing, options):
    """Normal forces above 0 of all contacts between grains, clusters' contacts each by itself; with their mean."""
    contacts = grain_pairs(packing)
    force = packing.fn[contacts][from_walls(packing, options, packing.point[contacts])]
    force = force[force > 0]
    return force, force.mean() if len(force) else 0.0


def over_mean(packing, options):
    force, mean = single_forces(packing, options)
    return force / mean if mean else force


@audits("force_distribution")
def force_distribution(packing, options):
    network = force_network(packing, options)
    force = network.force[from_walls(packing, options, network.point)]
    weights = force / force.mean() if len(force) and force.mean() > 0 else 0 * force
    low, high, n = options.force_min, options.force_max, options.force_bins
    if options.force_scale == "log":
        edges = low * (high / low) ** (np.arange(n + 1) / n)
        centre = np.sqrt(edges[1:] * edges[:-1])
    else:
        edges = low + (high - low) * np.arange(n + 1) / n
        centre = (edges[1:] + edges[:-1]) / 2
    count = counted(weights, edges)
    density = count / np.diff(edges) / len(weights) if len(weights) else 0.0 * count
    return {"force": centre, "density": density, "count": count}


@audits("contact_force_distribution")
def contact_force_distribution(packing, options):
    return linear_bins("force", over_mean(packing, options), options)


@audits("contact_forces")
def contact_forces(packing, options):
    force, mean = single_forces(packing, options)
    f = over_mean(packing, options)
    share = lambda limit: float(exceeds(f, limit).mean()) if len(f) else 0.0
    return {"force_contacts": len(force), "mean_contact_force": mean, "fraction_above_max": share(options.contact_force_max),
            "fraction_above_8": share(8), "largest_force": f.max() if len(f) else 0.0}
