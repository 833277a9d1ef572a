"""A packing as its two CSV tables state it: grains, box, walls and contacts."""
import csv
import gzip
from dataclasses import dataclass, field

import numpy as np


def read_csv(path):
    """The `# key: value` lines and the columns of a CSV file, plain or gzipped."""
    with (gzip.open if str(path).endswith(".gz") else open)(path, "rt") as file:
        lines = file.read().splitlines()
    notes = [line[1:].split(":", 1) for line in lines if line.startswith("#") and ":" in line]
    rows = list(csv.reader(line for line in lines if line and not line.startswith("#")))
    columns = {name: [row[k] for row in rows[1:]] for k, name in enumerate(rows[0])}
    return [(key.strip(), value.strip()) for key, value in notes], columns


def vectors(columns, names, count, missing="0"):
    """Columns side by side; zeros where a column is not there, or what is given for it."""
    return np.array([[float(v) for v in columns.get(n, [missing] * count)] for n in names]).reshape(len(names), count).T


@dataclass
class Packing:
    dimension: int
    x: np.ndarray            # centres (N, D)
    radius: np.ndarray
    mass: np.ndarray
    volume: np.ndarray       # of each grain: area of a disc, volume of a sphere, union of the arms of a cluster
    area: np.ndarray         # in two dimensions, what a grain covers of the plane
    inertia: np.ndarray      # about the axis of the plane; of spheres about any
    velocity: np.ndarray
    spin: np.ndarray
    ids: np.ndarray
    lo: np.ndarray
    hi: np.ndarray
    periodic: np.ndarray
    walls: list              # normals into the domain, in the order of the walls
    i: np.ndarray            # contacts: grain, and grain or -1 - wall
    j: np.ndarray
    fn: np.ndarray
    normal: np.ndarray       # from i to j
    tangential: np.ndarray   # force on i
    overlap: np.ndarray
    point: np.ndarray        # where i touches
    image: np.ndarray        # x_j + image * box is the copy that touches i
    bead: float = 0.0        # radius of the beads that the walls are made of
    shape: tuple = None      # of clusters: length, diameter of an arm, name
    energy: dict = field(default_factory=dict)

    @property
    def count(self):
        return len(self.radius)

    @property
    def sides(self):
        return self.hi - self.lo

    @property
    def space(self):
        return float(np.prod(self.sides))

    @property
    def upright(self):
        """Axis from the floor to the lid, which is the last wall; the last axis without walls."""
        return int(np.argmax(np.abs(self.walls[-1]))) if self.walls else self.dimension - 1

    @property
    def diameter(self):
        """Unit of length: the mean diameter of discs and spheres."""
        return 1.0 if self.shape else 2 * self.radius.mean()

    @property
    def inset(self):
        """Where the centres of grains end before a wall: a mean radius, and that of a bead where walls are made of them."""
        return self.radius.mean() + self.bead

    @property
    def force(self):
        """Force on grain i of each contact."""
        return self.tangential - self.fn[:, None] * self.normal

    @property
    def between(self):
        """Which contacts are between two grains."""
        return self.j >= 0


def measure_of(radius, dimension):
    return np.pi * radius**2 if dimension == 2 else 4 / 3 * np.pi * radius**3


def read(particles, contacts):
    notes, grains = read_csv(particles)
    more, table = read_csv(contacts)
    keyed = dict(notes)
    dimension = int(keyed["dimension"]) if "dimension" in keyed else (3 if "z" in grains else 2)
    axes = "xyz"[:dimension]
    count, touching = len(grains["radius"]), len(table["id1"])
    ids = np.array([int(v) for v in grains["id"]])
    order = np.argsort(ids, kind="stable")
    grains = {name: [values[k] for k in order] for name, values in grains.items()}
    ids = ids[order]
    radius = np.array([float(v) for v in grains["radius"]])
    x = vectors(grains, axes, count)
    index = {name: k for k, name in enumerate(ids)}
    triple = lambda key: np.array([float(v) for v in keyed[key].split()])[:dimension]
    lo, hi, periodic = triple("lo"), triple("hi"), triple("periodic").astype(bool)

    volume = measure_of(radius, dimension)
    area, shape = volume, None
    mass = np.array([float(v) for v in grains["mass"]])
    inertia = mass * radius**2 * (0.5 if dimension == 2 else 0.4)
    if "shape" in keyed:
        # volume, surface, area in the plane, length, reach, moments of inertia (3), ..., name: of size factor 1
        numbers, name = keyed["shape"].split(",", 1)
        numbers = [float(v) for v in numbers.split()]
        scale = np.array([float(v) for v in grains["scale"]])
        shape = (numbers[3], 2 * numbers[-1], name.strip())
        union, cross = volume_of_arms(*shape)
        volume, area = union * scale**3, cross * scale**2
        inertia = mass / numbers[0] * numbers[7] * scale**2

    i = np.array([index[int(v)] for v in table["id1"]], dtype=int)
    j = np.array([index[int(v)] if int(v) >= 0 else int(v) for v in table["id2"]], dtype=int)
    normal = vectors(table, ["n" + a for a in axes], touching)
    image = vectors(table, ["s" + a for a in axes], touching) if "sx" in table else None
    if image is None:
        gap = np.where(j[:, None] >= 0, x[np.maximum(j, 0)] - x[i], 0)
        image = -np.round(gap / (hi - lo)) * periodic
    if "overlap" in table:
        overlap = np.array([float(v) for v in table["overlap"]])
    else:
        gap = x[np.maximum(j, 0)] + image * (hi - lo) - x[i]
        overlap = radius[i] + radius[np.maximum(j, 0)] - np.linalg.norm(gap, axis=1)
    point = vectors(table, axes, touching)
    if "x" not in table:
        point = x[i] + normal * (radius[i] - overlap / 2)[:, None]
    spins = ["spin"] if dimension == 2 else ["spin_x", "spin_y", "spin_z"]
    return Packing(
        dimension, x, radius, mass, volume, area, inertia,
        vectors(grains, ["v" + a for a in axes], count, missing="nan"), vectors(grains, spins, count), ids, lo, hi, periodic,
        [np.array([float(v) for v in value.split()])[3:3 + dimension] for key, value in more if key == "wall"],
        i, j, np.array([float(v) for v in table["fn"]]), normal, vectors(table, ["ft" + a for a in axes], touching),
        overlap, point, image, 0.0, shape, {key[7:]: float(value) for key, value in notes if key.startswith("energy_")})


def volume_of_arms(length, diameter, name):
    """Union of two (cross) or three (star) spherocylinders at right angles through one centre, L/d of 2 and more: the
    common part of two cylinders is 16 r^3/3, of three 8 (2 - sqrt 2) r^3. Second, the area of a cross in the plane."""
    r, h = diameter / 2, (length - diameter) / 2
    assert name in ("cross", "star") and h >= r
    arm = 2 * np.pi * r**2 * h + 4 / 3 * np.pi * r**3
    union = 2 * arm - 16 / 3 * r**3 if name == "cross" else 3 * arm - 16 * r**3 + 8 * (2 - np.sqrt(2)) * r**3
    shadow = diameter**2 * (2 * (length / diameter - 1 + np.pi / 4) - 1)
    return union, shadow
