"""The force network: grains, touching pairs, and the force of each pair over the mean."""
from dataclasses import dataclass

import numpy as np

from contacts import grain_pairs, pairs, rattlers


@dataclass
class Network:
    grains: np.ndarray       # which grains are in it
    edges: np.ndarray        # (E, 2) grains
    image: np.ndarray        # (E, D)
    force: np.ndarray        # of each edge, as it is
    mean: float
    point: np.ndarray        # where they touch

    @property
    def weight(self):
        return self.force / self.mean if self.mean > 0 else 0 * self.force


def force_network(packing, options):
    found, pair = pairs(packing)
    contacts = grain_pairs(packing)
    vector = packing.fn[contacts, None] * packing.normal[contacts]
    if options.force == "total":
        vector = -packing.force[contacts]
    sums = np.zeros((len(found), packing.dimension))
    np.add.at(sums, pair, vector)
    force = np.linalg.norm(sums, axis=1)
    kept = ~rattlers(packing) if options.remove_rattlers else np.ones(packing.count, dtype=bool)
    inside = kept[found[:, 0]] & kept[found[:, 1]]
    edges, force = found[inside, :2], force[inside]
    point = np.zeros((len(found), packing.dimension))
    point[pair] = packing.point[contacts]  # of a pair with several contacts one of them
    return Network(np.flatnonzero(kept), edges, found[inside, 2:], force, force.mean() if len(force) else 0.0, point[inside])


def clamped(network, options):
    """Weights cut at the option clamp; 0 keeps all."""
    return np.minimum(network.weight, options.clamp) if options.clamp > 0 else network.weight


def components(count, edges):
    """A label for each of count vertices, the smallest vertex of its component."""
    parent = list(range(count))

    def root(v):
        while parent[v] != v:
            parent[v] = parent[parent[v]]
            v = parent[v]
        return v

    for a, b in edges:
        a, b = root(a), root(b)
        if a != b:
            parent[max(a, b)] = min(a, b)
    return np.array([root(v) for v in range(count)])


def winding(count, edges, images):
    """For each vertex the axes along which its component closes on itself through the periodic box."""
    at, label, winds = {}, np.full(count, -1), {}
    neighbours = [[] for _ in range(count)]
    for (a, b), s in zip(edges, images):
        neighbours[a].append((b, s))
        neighbours[b].append((a, -s))
    for start in range(count):
        if label[start] >= 0:
            continue
        label[start], at[start], stack = start, np.zeros(images.shape[1]), [start]
        winds[start] = np.zeros(images.shape[1], dtype=bool)
        while stack:
            v = stack.pop()
            for u, s in neighbours[v]:
                if label[u] < 0:
                    label[u], at[u] = start, at[v] + s
                    stack.append(u)
                else:
                    winds[start] |= at[u] != at[v] + s
    return np.array([winds[k] for k in label]).reshape(count, images.shape[1])
