"""Distributions of the distances between grains."""
import warnings

import numpy as np

from borders import counted, multiples, reaches
from registry import Drawn, Fit, Sum, audits


def distances(packing):
    """Of each grain to every other, the nearest copy in a periodic box; itself at infinity."""
    gap = packing.x[None, :, :] - packing.x[:, None, :]
    gap -= np.round(gap / packing.sides) * packing.sides * packing.periodic
    found = np.linalg.norm(gap, axis=2)
    np.fill_diagonal(found, np.inf)
    return found


def room(packing, inset, skip=None):
    """How far the shell about each grain may reach: to where centres end before the nearest wall; half a side of a periodic
    box."""
    free = np.full(packing.count, np.inf)
    for axis in range(packing.dimension):
        if axis == skip:
            continue
        if packing.periodic[axis]:
            free = np.minimum(free, packing.sides[axis] / 2)
        else:
            x = packing.x[:, axis]
            free = np.minimum(free, np.minimum(x - packing.lo[axis], packing.hi[axis] - x) - inset)
    return free


def away(packing, margins):
    """Grains at least a margin from the walls of each axis."""
    inside = np.ones(packing.count, dtype=bool)
    for axis, margin in enumerate(margins):
        if not packing.periodic[axis]:
            x = packing.x[:, axis]
            inside &= reaches(x - packing.lo[axis], margin) & reaches(packing.hi[axis] - x, margin)
    return inside


def shell(r, width, dimension):
    """Of radius r: 2 pi r dr, 4 pi r^2 dr, the whole shell."""
    inner, outer = r - width / 2, r + width / 2
    return np.pi * (outer**2 - inner**2) if dimension == 2 else 4 / 3 * np.pi * (outer**3 - inner**3)


def shells(packing, references, free, edges):
    """For each bin: references whose shell is inside, and grains in their shells."""
    apart = distances(packing)
    fits = references[:, None] & (reaches(free[:, None], edges[None, 1:]))
    found = np.zeros((packing.count, len(edges) - 1), dtype=int)
    for g in np.flatnonzero(references):
        found[g] = counted(apart[g], np.append(edges, 1e300))[:-1]  # of a shell the outer edge is out
    return fits, found * fits


@audits("pair_correlation")
def pair_correlation(packing, options):
    d = 2 * packing.radius.mean()
    edges = multiples(options.pair_range, options.pair_bin) * d
    margins = [0.0 if p else min(options.pair_margin * d, side / 6) for p, side in zip(packing.periodic, packing.sides)]
    references = away(packing, margins)
    density = references.sum() / np.prod(packing.sides - 2 * np.array(margins))
    fits, found = shells(packing, references, room(packing, packing.inset), edges)
    centre = (edges[1:] + edges[:-1]) / 2
    ideal = fits.sum(axis=0) * density * shell(centre, options.pair_bin * d, packing.dimension)
    with np.errstate(invalid="ignore"):
        return {"distance": centre / d, "g": found.sum(axis=0) / ideal}


def rdf_length(packing):
    return packing.shape[0] if packing.shape else packing.diameter


def thin_axis(packing, options):
    """In three dimensions the narrowest of the sides, where shells of rdf_range do not fit between its walls; or none."""
    sides = [a for a in range(packing.dimension) if a != packing.upright and not packing.periodic[a]]
    if packing.dimension < 3 or not sides:
        return None
    axis = min(sides, key=lambda a: packing.sides[a])
    return axis if packing.sides[axis] < 2 * options.rdf_range * rdf_length(packing) else None


def rdf_margins(packing, options):
    """Margin of each axis: as asked, or a sixth of a width that would keep less than a quarter; none in a thin slab."""
    margins, thin = [], thin_axis(packing, options)
    for axis, side in enumerate(packing.sides):
        asked = (options.rdf_margin_ends if axis == packing.upright else options.rdf_margin_sides) * rdf_length(packing)
        none = packing.periodic[axis] or axis == thin
        margins.append(0.0 if none else side / 6 if side - 2 * asked < side / 4 else asked)
    return margins


def shells_in_slab(packing, edges, axis):
    """Volume of each shell about each grain that is between the two walls of an axis."""
    def ball(radius, height):  # half of it, up to a plane
        height = np.minimum(height[:, None], radius)
        return np.pi * (radius**2 * height - height**3 / 3)

    x = packing.x[:, axis]
    return np.diff(ball(edges, x - packing.lo[axis]) + ball(edges, packing.hi[axis] - x), axis=1)


def radial(packing, options):
    """Centres of the bins; for each grain and bin: whether it is a reference there, grains in its shell, those of an ideal
    gas; which grains are references."""
    length, thin = rdf_length(packing), thin_axis(packing, options)
    edges = multiples(options.rdf_range, options.rdf_bin) * length
    references = away(packing, rdf_margins(packing, options))
    inset = packing.shape[1] / 2 if packing.shape else packing.inset
    fits, found = shells(packing, references, room(packing, inset, thin), edges)
    centre = (edges[1:] + edges[:-1]) / 2
    if thin is None:
        volume = np.tile(shell(centre, options.rdf_bin * length, packing.dimension), (packing.count, 1))
    else:
        volume = shells_in_slab(packing, edges, thin)
    return centre / length, fits, found, fits * volume * packing.count / packing.space, references


@audits("radial_distribution")
def radial_distribution(packing, options):
    centre, fits, found, ideal, _ = radial(packing, options)
    pairs, references, expected = found.sum(axis=0), fits.sum(axis=0), ideal.sum(axis=0)
    with np.errstate(invalid="ignore"):
        return {"distance": centre, "g": pairs / expected, "pairs": pairs, "ideal": expected, "references": references}


def sum_of_three(values):
    return np.convolve(values, np.ones(3), mode="valid")


def stands_out(centre, g, error, k, reach):
    """Whether g falls on both sides of bin k within a reach by .05 and by 4 errors of the difference."""
    sides = [(centre >= centre[k] - reach) & (centre < centre[k]), (centre <= centre[k] + reach) & (centre > centre[k])]
    return all(np.any(g[k] - g[side] >= np.maximum(0.05, 4 * np.hypot(error[k], error[side]))) for side in sides)


def top(centre, g, error, low, high, reach):
    """Place of the highest maximum of g between two distances, by a parabola through its neighbours."""
    inside = np.flatnonzero((centre >= low) & (centre <= high) & np.isfinite(g))
    inside = inside[(inside > 0) & (inside < len(g) - 1)]
    if not len(inside):
        return np.nan
    k = inside[np.argmax(g[inside])]
    a, b, c = g[k - 1:k + 2]
    curve = a - 2 * b + c
    place = centre[k] + (0.5 * (a - c) / curve if curve < 0 else 0.0) * (centre[1] - centre[0])
    return place if stands_out(centre, g, error, k, place / 2 if reach is None else reach) else np.nan


def peaks(centre, pairs, expected):
    with np.errstate(invalid="ignore", divide="ignore"):
        g = sum_of_three(pairs / expected) / 3
        error = g * np.sqrt(2 / sum_of_three(pairs))  # most pairs are counted from both ends
        error[sum_of_three(pairs) == 0] = 0
    middle = centre[1:-1]
    first = top(middle, g, error, 0, np.inf, None)
    return [first] + [top(middle, g, error, k * first - first / 2, k * first + first / 2, first / 2) for k in (2, 3)]


@audits("rdf_peaks")
def rdf_peaks(packing, options):
    length = rdf_length(packing)
    centre, fits, found, ideal, references = radial(packing, options)
    places = peaks(centre, found.sum(axis=0), ideal.sum(axis=0))
    chosen, random, drawn = np.flatnonzero(references), np.random.default_rng(1), []
    for _ in range(200):
        again = random.choice(chosen, len(chosen))
        drawn.append(peaks(centre, found[again].sum(axis=0), ideal[again].sum(axis=0)))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # a peak that is never found has no error
        spread = np.nanstd(drawn, axis=0, ddof=1)
    margins = rdf_margins(packing, options)
    sides = [m for axis, m in enumerate(margins) if axis != packing.upright]
    columns = {"rdf_references": int(references.sum()), "rdf_margin_ends": margins[packing.upright] / length,
               "rdf_margin_sides": min(sides) / length, "rdf_length": length}
    for k in range(3):
        columns[f"rdf_peak{k + 1}"] = Fit(places[k], f"rdf_peak{k + 1}_error")
        columns[f"rdf_peak{k + 1}_error"] = Drawn(spread[k] if np.isfinite(places[k]) else np.nan, 1.5)
    d1 = np.nan
    if packing.shape:
        d = packing.shape[1]
        d1 = np.sqrt(d**2 + ((length + d) / 2) ** 2) / length
    columns.update({f"rdf_d{k}": k * d1 for k in (1, 2, 3)})
    columns["rdf_j1"] = np.sqrt(3) * packing.shape[1] / length if packing.shape else np.nan
    return columns
