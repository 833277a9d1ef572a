"""How much of the space is filled, and what the lid carries."""
import numpy as np

from contacts import touching, wall_contacts
from measures.walls import wall_forces
from registry import Sum, audits


@audits("solid_fraction")
def solid_fraction(packing, options):
    space = packing.space
    if packing.shape and packing.dimension == 2:
        filled = packing.volume.sum() / (space * packing.shape[1])
    else:
        filled = packing.volume.sum() / space
    overlaps = packing.overlap[touching(packing)]
    weight = np.nan
    if packing.walls and (load := wall_forces(packing)[-1]) > 0:
        carried = packing.force[wall_contacts(packing)].sum(axis=0)  # by all walls, friction of the sides included
        weight = carried[packing.upright] / load
    return {"solid_fraction": filled, "area_fraction": packing.area.sum() / space if packing.dimension == 2 else 0.0,
            "height": packing.sides[packing.upright], "weight_over_load": Sum(weight, 1),
            "deepest_overlap": max(overlaps.max(), 0.0) if len(overlaps) else 0.0}
