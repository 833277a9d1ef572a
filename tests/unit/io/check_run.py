"""Reads a run.h5 with h5py, as another program would, and holds it against the CSV tables of its frames.

usage: check_run.py RUN.h5 PARTICLES_0.csv CONTACTS_0.csv PARTICLES_1.csv CONTACTS_1.csv ...
Exit status 77: there is no h5py.
"""

import csv
import os
import pathlib
import re
import sys

try:
    import h5py
    import numpy as np
except ImportError:
    sys.exit(77)


def table(path):
    with open(path, newline="") as file:
        lines = [line for line in file if not line.startswith("#")]
    rows = list(csv.DictReader(lines))
    return {name: np.array([float(row[name]) for row in rows]) for name in rows[0]} if rows else {}


def same(name, found, wanted):
    assert np.array_equal(np.asarray(found, dtype=float), wanted), f"{name} differs"


DOCUMENTED = pathlib.Path(__file__).resolve().parents[3] / "docs" / "reference" / "files.md"


def check_documentation(run):
    """Every array that the page names is there, with the numbers it says, and its example runs."""
    page = DOCUMENTED.read_text()
    rows = re.findall(r"^\| `(/\S+)` \| (\S+) \|(.*?)\|.*\| (.*) \|$", page, re.M)
    assert len(rows) == page.count("| `/"), "a row of the page that is not understood"
    assert len(rows) > 50
    with h5py.File(run, "r") as f:
        clusters = "shapes" in f
        for path, kind, components, meaning in rows:
            if path.startswith("/knows/") or path.endswith(("/tilt", "/relaxation")) or (path.startswith("/shapes/") and not clusters):
                continue  # only where there is something to say
            if meaning.startswith("clusters") and not clusters:
                continue
            item = f[path]
            data = item["value"] if isinstance(item, h5py.Group) else item
            if kind != "text":
                wanted = np.dtype({"f": "f", "i": "i", "u": "u"}[kind[0]] + str(int(kind[1:]) // 8))
                assert data.dtype == wanted, f"{path} holds {data.dtype}, not {kind}"
            components = components.strip()
            if components in ("3", "4"):
                assert data.shape[-1] == int(components), path
    example = re.search(r"```python\n(.*?)```", page, re.S).group(1)
    os.chdir(pathlib.Path(run).parent)
    exec(compile(example, "the example of files.md", "exec"), {})


def main(run, *tables):
    frames = len(tables) // 2
    with h5py.File(run, "r") as f:
        assert list(f["h5md"].attrs["version"]) == [1, 1]
        assert f["h5md/creator"].attrs["name"] == "jamscape"
        assert f["h5md/creator"].attrs["version"] == "0.1.0"
        assert f["h5md/author"].attrs["name"] == "jamscape"
        f.visititems(lambda name, item: isinstance(item, h5py.Dataset) or int(item.attrs["layout_version"]) == 2 or 1 / 0)

        everyone = f["particles/all"]
        dimension = int(everyone["box"].attrs["dimension"])
        assert len(everyone["box"].attrs["boundary"]) == dimension
        assert set(everyone["box"].attrs["boundary"]) <= {"none", "periodic"}
        assert everyone["box/edges/value"].shape == (frames, dimension)
        assert np.array_equal(
            everyone["box/edges/value"][:], (everyone["box/upper"][:] - everyone["box/lower"][:])[:, :dimension])
        for element in ("position", "velocity", "angular_velocity", "angle", "count"):
            assert everyone[element]["step"] == f["frames/step"], "step is one array under many names"
            assert everyone[element]["time"] == f["frames/time"]
            assert everyone[element]["value"].shape[0] == frames
        assert everyone["position/value"].dtype == "<f8" and everyone["id"].dtype == "<i8"
        assert everyone["position/value"].compression == "gzip" and everyone["position/value"].shuffle
        assert len(f["frames/stage"]) == frames

        contacts = f["contacts"]
        offset = contacts["offset"][:]
        assert offset.dtype == "<u8" and len(offset) == frames + 1
        types = {"i": "<u4", "j": "<i4", "part_i": "<u2", "part_j": "<u2", "image": "i1", "overlap": "<f8", "fn": "<f8",
                 "normal": "<f8", "ft": "<f8", "point": "<f8", "slip": "u1"}
        for name, kind in types.items():
            assert contacts[name].dtype == kind, name
            assert len(contacts[name]) == offset[-1], name
        assert len(f["walls/offset"]) == frames + 1

        if "shapes" in f:
            shapes, arms = f["shapes"], len(f["shapes/arm_radius"])
            assert list(shapes["name"][:]) == [b"Form 0", b"Form 1"]
            assert shapes["arm_offset"][0] == 0 and shapes["arm_offset"][-1] == arms == 3
            assert shapes["arm_direction"].shape == shapes["arm_centre"].shape == (arms, 3)
            assert np.allclose(np.linalg.norm(shapes["arm_direction"][:], axis=1), 1)
            assert shapes["inertia"].shape == (2, 3)
            turned = everyone["orientation"]
            assert turned["step"] == f["frames/step"] and turned["value"].shape[0] == frames
            assert np.allclose(np.linalg.norm(turned["value"][:], axis=2), 1)
            assert everyone["shape/value"].dtype == "<i4" and set(everyone["shape/value"][:].flat) == {0, 1}
            last = int(f["walls/offset"][1]) - 1
            assert f["walls/kind"][last] == 2 and f["walls/cylinder_radius"][last] > 0

        for k in range(frames):
            p, c = table(tables[2 * k]), table(tables[2 * k + 1])
            n = int(everyone["count/value"][k])
            assert n == len(p["id"])
            same("radius", everyone["radius"][:], p["radius"])
            for name, part in zip(("qw", "qx", "qy", "qz"), range(4)):
                if name in p:
                    same(name, everyone["orientation/value"][k, :n, part], p[name])
            for d, axis in enumerate("xyz"[:dimension]):
                same(axis, everyone["position/value"][k, :n, d], p[axis])
                same("v" + axis, everyone["velocity/value"][k, :n, d], p["v" + axis])
                rows = slice(offset[k], offset[k + 1])
                same("n" + axis, contacts["normal"][rows, d], c["n" + axis])
                same("ft" + axis, contacts["ft"][rows, d], c["ft" + axis])
                same("point", contacts["point"][rows, d], c[axis])
            same("fn", contacts["fn"][rows], c["fn"])
            same("i", everyone["id"][:][contacts["i"][rows]], c["id1"])
            j = contacts["j"][rows].astype(int)
            same("j", np.where(j < 0, j, everyone["id"][:][np.maximum(j, 0)]), c["id2"])
        assert f["observables/packing_fraction/value"].shape == (frames,)
        assert f["observables/energy_rubbed/time"] == f["frames/time"]
        assert f["parameters/config"][()].decode() == "count = 50  # Körner\n"
        assert f["parameters"].attrs["seed"] == b"42"


main(*sys.argv[1:])
check_documentation(sys.argv[1])
