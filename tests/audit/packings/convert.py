"""Turns the dumps of a LAMMPS run (discs.in, spheres.in) into the two tables that `jamscape measure` reads.

    lmp -in discs.in && python3 convert.py discs
    lmp -in spheres.in && python3 convert.py spheres --length 6 --force 0.25

LAMMPS's p10..p12 is x1 - x2 and its fx.. and p1..p3 are the normal and the tangential force on the first grain. The
factors write lengths and forces in other units (here: 6 mm and a quarter of a newton), so that nothing is right only
because the mean diameter is 1.
"""
import argparse
import gzip

import numpy as np


def dump(path):
    lines = open(path).read().splitlines()
    box = np.array([[float(v) for v in line.split()] for line in lines[5:8]])
    return box, np.array([[float(v) for v in line.split()] for line in lines[9:]])


def write(path, notes, header, rows):
    text = "".join(f"# {note}\n" for note in notes) + ",".join(header) + "\n"
    text += "".join(",".join(repr(v) for v in row) + "\n" for row in rows)
    with open(path, "wb") as file:
        file.write(gzip.compress(text.encode(), mtime=0))


def main():
    options = argparse.ArgumentParser()
    options.add_argument("name")
    options.add_argument("--length", type=float, default=1.0)
    options.add_argument("--force", type=float, default=1.0)
    asked = options.parse_args()
    box, grains = dump(f"{asked.name}.grains")
    _, contacts = dump(f"{asked.name}.contacts")
    dimension = 2 if np.all(grains[:, 3] == 0) else 3
    axes, use = "xyz"[:dimension], slice(0, dimension)
    vector = lambda values: " ".join(repr(float(v)) for v in values)
    lo, hi = box[:, 0] * asked.length, box[:, 1] * asked.length
    if dimension == 2:
        lo[2] = hi[2] = 0
    notes = [f"dimension: {dimension}", "lo: " + vector(lo), "hi: " + vector(hi),
             "periodic: " + " ".join("1" if k < dimension else "0" for k in range(3))]
    rows = [[int(g[0]), *(g[1:4][use] * asked.length).tolist(), float(g[4] * asked.length), float(g[5])] for g in grains]
    write(f"{asked.name}.particles.csv.gz", notes, ["id", *axes, "radius", "mass"], rows)
    rows = []
    for c in sorted(contacts.tolist()):
        normal = -np.array(c[10:13])[use] / c[2]
        tangential = np.array(c[7:10])[use] * asked.force
        rows.append([int(c[0]), int(c[1]), c[3] * asked.force, *normal.tolist(), *tangential.tolist()])
    header = ["id1", "id2", "fn", *("n" + a for a in axes), *("ft" + a for a in axes)]
    write(f"{asked.name}.contacts.csv.gz", [], header, rows)


main()
