"""Contacts by grain and by pair."""
import numpy as np


def touching(packing):
    """Contacts that are there: those that overlap or carry a force, walls among them."""
    loaded = (packing.fn != 0) | np.any(packing.tangential != 0, axis=1)
    return (packing.overlap >= 0) | loaded


def grain_pairs(packing):
    """Contacts between grains."""
    return np.flatnonzero(touching(packing) & packing.between)


def wall_contacts(packing):
    return np.flatnonzero(touching(packing) & ~packing.between)


def pairs(packing):
    """Touching pairs (i, j, image) of grains, and for each contact between grains the pair it belongs to: clusters may
    touch with several arms, two grains of a narrow periodic box on both sides."""
    contacts = grain_pairs(packing)
    keys = np.column_stack([packing.i[contacts], packing.j[contacts], packing.image[contacts]]).astype(int)
    found, pair = np.unique(keys, axis=0, return_inverse=True)
    return found, pair.reshape(-1)


def pair_counts(packing):
    """Touching grains of each grain."""
    found, _ = pairs(packing)
    return np.bincount(found[:, :2].ravel(), minlength=packing.count)


def counts_with_walls(packing):
    """Touching grains of each grain, and each contact with a wall."""
    return pair_counts(packing) + np.bincount(packing.i[wall_contacts(packing)], minlength=packing.count)


def rattlers(packing):
    """Grains with fewer than two contacts, walls counted."""
    return counts_with_walls(packing) < 2


def by_grain(packing):
    """Every contact once for each grain it has: grain, force on it, lever from its centre to the contact point."""
    c = np.flatnonzero(touching(packing))
    force, lever = packing.force[c], packing.point[c] - packing.x[packing.i[c]]
    pair = packing.between[c]
    j, shift = packing.j[c][pair], packing.image[c][pair] * packing.sides
    other = packing.point[c][pair] - (packing.x[j] + shift)
    return (np.concatenate([packing.i[c], j]), np.concatenate([force, -force[pair]]), np.concatenate([lever, other]))
