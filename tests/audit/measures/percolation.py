"""Clusters that join opposite walls or wind around the box."""
import numpy as np

from contacts import wall_contacts
from network import components, force_network, winding
from registry import audits


def touched_walls(packing):
    """For each grain the walls that it presses with a positive force."""
    touched = [set() for _ in range(packing.count)]
    for c in wall_contacts(packing):
        if packing.fn[c] > 0:
            touched[packing.i[c]].add(-1 - packing.j[c])
    return touched


def percolating(packing, label, edges, images):
    """For each grain whether its cluster percolates along each axis."""
    joins = winding(packing.count, edges, images) & packing.periodic
    walls = {}
    for grain, walls_of_grain in enumerate(touched_walls(packing)):
        walls.setdefault(label[grain], set()).update(walls_of_grain)
    faces = [face_of(normal) for normal in packing.walls]
    for grain in range(packing.count):
        found = {faces[w] for w in walls[label[grain]]}
        for axis in range(packing.dimension):
            joins[grain, axis] |= {(axis, 1), (axis, -1)} <= found
    return joins


def face_of(normal):
    """Axis and side of a wall by its normal into the domain."""
    axis = int(np.argmax(np.abs(normal)))
    return axis, int(np.sign(normal[axis]))


@audits("percolation")
def percolation(packing, options):
    network = force_network(packing, options)
    strong = network.force > 0
    edges = network.edges[strong]
    label = components(packing.count, edges)
    joins = percolating(packing, label, edges, network.image[strong])
    k = np.bincount(edges.ravel(), minlength=packing.count)
    joins[k == 0] = False  # a cluster has an edge
    k = k[network.grains]
    columns = {f"percolates_{a}": int(joins[:, n].any()) if n < packing.dimension else 0 for n, a in enumerate("xyz")}
    some = joins.any(axis=1)
    square = (k**2).mean() - k.mean() if len(k) else 0.0
    columns.update({"percolates": int(some.any()), "percolating_fraction": some.sum() / packing.count,
                    "percolation_estimate": k.mean() / square if square > 0 else np.nan,
                    "mean_degree": k.mean() if len(k) else 0.0})
    return columns
