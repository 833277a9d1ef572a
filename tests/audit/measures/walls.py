"""Walls and box."""
import numpy as np

from borders import reaches
from contacts import wall_contacts
from measures.percolation import face_of
from registry import Sum, audits


def wall_forces(packing, margins=None):
    """Force of the grains on each wall along the normal outward, by wall number; without contacts closer than a margin to
    another wall, where margins are given."""
    forces = np.zeros(len(packing.walls))
    for c in wall_contacts(packing):
        w = -1 - packing.j[c]
        if margins is not None:
            others = [a for a in range(packing.dimension) if a != face_of(packing.walls[w])[0]]
            depth = np.minimum(packing.point[c] - packing.lo, packing.hi - packing.point[c])
            if not all(reaches(depth[a], margins[a]) for a in others):
                continue
        forces[w] += packing.force[c] @ packing.walls[w]  # what a grain feels, the wall feels the other way round
    return forces


@audits("walls")
def walls(packing, options):
    forces = wall_forces(packing)
    columns = {f"wall_force_{a}_{side}": 0.0 for a in "xyz" for side in ("lo", "hi")}
    for normal, force in zip(packing.walls, forces):
        axis, side = face_of(normal)
        columns[f"wall_force_{'xyz'[axis]}_{'lo' if side > 0 else 'hi'}"] = force
    margins = np.where(packing.periodic, 0, np.minimum(options.force_margin * 2 * packing.radius.mean(), packing.sides / 6))
    lengths = packing.sides - 2 * margins
    inner = wall_forces(packing, margins) if options.force_margin > 0 else forces
    pressures = [force / np.delete(lengths, face_of(normal)[0]).prod() for normal, force in zip(packing.walls, inner)]
    columns["wall_pressure"] = np.mean(pressures) if pressures else 0.0
    c = wall_contacts(packing)
    terms = (packing.force[c] * (packing.point[c] - (packing.lo + packing.hi) / 2)).sum(axis=1)
    columns["wall_virial_pressure"] = Sum(-terms.sum() / packing.dimension / packing.space,
                                          np.abs(terms).sum() / packing.dimension / packing.space)
    return columns


@audits("box")
def box(packing, options):
    return {f"box_l{a}": packing.sides[k] if k < packing.dimension else 0.0 for k, a in enumerate("xyz")}
