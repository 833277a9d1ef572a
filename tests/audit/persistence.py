"""Persistence of the superlevel sets of a clique complex over Z/2, by reducing the boundary matrix column by column."""
from itertools import combinations

import numpy as np


def cliques(vertices, weights, top):
    """All cliques of up to top + 1 vertices with the value at which each enters; vertices without edges enter at 0."""
    neighbours = {v: set() for v in vertices}
    for a, b in weights:
        neighbours[a].add(b)
        neighbours[b].add(a)
    found = [[((v,), max((weights[min(u, v), max(u, v)] for u in neighbours[v]), default=0.0)) for v in vertices]]
    found.append([(edge, w) for edge, w in sorted(weights.items())])
    for _ in range(2, top + 1):
        larger = []
        for clique, value in found[-1]:
            common = set.intersection(*(neighbours[v] for v in clique))
            for u in common:
                if u > clique[-1]:
                    larger.append((clique + (u,), min([value] + [weights[v, u] for v in clique])))
        found.append(larger)
    return found


def diagram(vertices, edges, weights, filled, highest):
    """Points (dimension, birth, death, essential) up to H_highest of the cliques of up to filled + 1 vertices, without pairs
    of zero length; a vertex with no edge is (0, 0, 0, 1), what never dies has death 0."""
    value = {}
    for (a, b), w in zip(edges, weights):
        key = (int(min(a, b)), int(max(a, b)))
        value[key] = max(w, value.get(key, 0.0))
    ordered = [simplex for level in cliques([int(v) for v in vertices], value, filled) for simplex in level]
    ordered.sort(key=lambda s: (-s[1], len(s[0])))
    position = {simplex: k for k, (simplex, _) in enumerate(ordered)}
    owner, columns, unpaired, points = {}, {}, set(), []
    for k, (simplex, w) in enumerate(ordered):
        column = 0
        if len(simplex) > 1:
            for face in combinations(simplex, len(simplex) - 1):
                column ^= 1 << position[face]
        while column and column.bit_length() - 1 in owner:
            column ^= columns[owner[column.bit_length() - 1]]
        if column:
            low = column.bit_length() - 1
            owner[low], columns[k] = k, column
            unpaired.discard(low)
            if ordered[low][1] > w:
                points.append((len(simplex) - 2, ordered[low][1], w, 0))
        elif len(simplex) <= highest + 1:
            unpaired.add(k)
    for k in unpaired:
        simplex, w = ordered[k]
        points.append((len(simplex) - 1, w, 0.0, 1))
    return np.array(sorted(points), dtype=float).reshape(len(points), 4)
