"""The comparison of run_engine for stars: LAMMPS knows a star as a rigid clump of spheres, so bodies differ by the dips
between the spheres. Both programs let the same stars fall and settle; their beds are compared rather than contacts."""
import json
import math
import re
import sys
from collections import defaultdict
from pathlib import Path

from common import Disagreement, command, dump, run_lammps

STEPS_PER_SECOND = 300  # of LAMMPS, about
SPHERES = 9  # on an arm; the three arms share the one in the middle
VARIABLES = ("k_n", "k_t", "gamma_n", "gamma_t", "mu", "dt", "gravity", "side")  # of lammps/stars_law.in
SCRIPTS = Path(__file__).resolve().parent / "lammps"
LIMITS = {"load of the floor over weight": 0.01,  # of each, from 1
          "touching pairs of stars": 0.03, "mean force of a pair": 0.1}  # relative difference


def rotate(q, v):
    w, u = q[0], q[1:]
    cross = lambda a, b: [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    t = [2 * c for c in cross(u, v)]
    return [a + w * b + c for a, b, c in zip(v, t, cross(u, t))]


class Stars:
    """Our bed, and LAMMPS's."""

    def __init__(self, engine, folder):
        self.engine, self.folder, self.archive = engine, folder, folder / "stars.h5"
        self.setup = json.loads(command([engine, "start"]))
        self.count, self.steps_per_second = len(self.setup["bodies"]), STEPS_PER_SECOND
        self.variables = {name: self.setup[name] for name in VARIABLES} | {"reach": self.setup["aspect"] + 1, "spheres": SPHERES}
        for script in SCRIPTS.glob("stars_*.in"):
            (folder / script.name).write_text(script.read_text())
        if not self.archive.is_file():
            print("settling the stars ...", file=sys.stderr)
            command([engine, "settle", self.archive])
        if not (folder / "stars.restart").is_file():
            print("settling the stars in LAMMPS ...", file=sys.stderr)
            self.write_clumps()
            run_lammps("stars_settle.in", folder, steps=self.setup["settling"], **self.variables)

    def write_clumps(self):
        """stars.data: the spheres, with their star as molecule; stars.bodies: mass, centre and inertia of each star."""
        half = (self.setup["aspect"] - 1) / 2
        marks = [half * (2 * k / (SPHERES - 1) - 1) for k in range(SPHERES)]
        own = [[0, 0, 0]] + [[at if c == axis else 0 for c in range(3)] for axis in range(3) for at in marks if at != 0]
        atoms, molecules, bodies = [], [], [str(self.count)]
        i = self.setup["inertia"]
        for star, body in enumerate(self.setup["bodies"], 1):
            x, q, v = body[:3], body[3:7], body[7:]
            bodies.append(" ".join(map(repr, [star, 1, *x, i, i, i, 0, 0, 0, *v, 0, 0, 0, 0, 0, 0])))
            for point in own:
                p = [a + b for a, b in zip(x, rotate(q, point))]
                atoms.append(f"{len(atoms) + 1} 1 1 1 {p[0]!r} {p[1]!r} {p[2]!r}")
                molecules.append(f"{len(atoms)} {star}")
        side, top = self.setup["side"], max(body[2] for body in self.setup["bodies"]) + self.setup["aspect"]
        text = ["stars", "", f"{len(atoms)} atoms", "1 atom types", f"-2 {side + 2!r} xlo xhi", f"-2 {side + 2!r} ylo yhi",
                f"-2 {top!r} zlo zhi", "", "Atoms # sphere", "", *atoms, "", "Molecules", "", *molecules]
        (self.folder / "stars.data").write_text("\n".join(text) + "\n")
        (self.folder / "stars.bodies").write_text("\n".join(bodies) + "\n")

    def theirs(self):
        run_lammps("stars_state.in", self.folder, skin=0.1, **self.variables)
        spheres = 3 * SPHERES - 2
        pairs, contacts = defaultdict(lambda: [0, 0, 0]), 0
        for a, b, *f in dump(self.folder / "stars.contacts"):
            i, j = (int(a) - 1) // spheres, (int(b) - 1) // spheres
            sign = 1 if i < j else -1
            if any(f[:3]):
                contacts += 1
                pairs[min(i, j), max(i, j)] = [p + sign * (n + t) for p, n, t in zip(pairs[min(i, j), max(i, j)], f, f[3:])]
        floor = dump(self.folder / "stars.floor")
        motion = dump(self.folder / "stars.motion")
        kinetic = sum(sum(v * v for v in row[1:4]) + self.setup["inertia"] * sum(w * w for w in row[4:7]) for row in motion) / 2
        return {"floor_over_weight": abs(sum(row[3] for row in floor)) / (self.count * self.setup["gravity"]),
                "contacts": contacts, "pairs": len(pairs), "kinetic": kinetic,
                "mean_pair_force": sum(math.hypot(*f) for f in pairs.values()) / len(pairs),
                "height": max(row[4] for row in floor) + 0.5}

    def compare(self):
        """What both beds weigh; how far they are apart, each held against its limit."""
        theirs = self.theirs()
        ours = json.loads(command([self.engine, "state", self.archive]))
        apart = {"load of the floor over weight": max(abs(ours["floor_over_weight"] - 1), abs(theirs["floor_over_weight"] - 1)),
                 "touching pairs of stars": abs(theirs["pairs"] / ours["pairs"] - 1),
                 "mean force of a pair": abs(theirs["mean_pair_force"] / ours["mean_pair_force"] - 1)}
        for name, difference in apart.items():
            if not difference < LIMITS[name]:
                raise Disagreement(f"stars: {name} differs by {difference:.2g} (allowed: {LIMITS[name]:.2g})")
        return {"jamscape": ours, "lammps": theirs, "differences": apart}

    def time_lammps(self, skin, steps):
        log = run_lammps("stars_time.in", self.folder, skin=skin, steps=steps, **self.variables)
        return float(re.search(r"Loop time of (\S+)", log).group(1))

    def time_ours(self, steps):
        return json.loads(command([self.engine, "time", self.archive, steps]))

    def describe(self, agreement):
        lines = []
        for who in ("lammps", "jamscape"):
            a = agreement[who]
            lines.append(f"{who:8}  floor carries {a['floor_over_weight']:.5f} of the weight, {a['pairs']} touching pairs "
                         f"({a['contacts']} contacts), mean force of a pair {a['mean_pair_force']:.3e}, height "
                         f"{a['height']:.2f}, kinetic energy {a['kinetic']:.1e}")
        return f"L/d = {self.setup['aspect']}, 3 x {SPHERES} spheres a star in LAMMPS", lines
