"""Packings and networks made elsewhere: what they state is believed, what contradicts itself is refused."""

import csv
import unittest

from program import Case

HEXAGON = """\
0,0.0,0.0,{z}0.5
1,0.98,0.0,{z}0.5
2,0.4900000000000001,0.8487048957087499,{z}0.5
3,-0.48999999999999977,0.84870489570875,{z}0.5
4,-0.98,1.2001538631644062e-16,{z}0.5
5,-0.49000000000000044,-0.8487048957087496,{z}0.5
6,0.4899999999999993,-0.8487048957087503,{z}0.5
"""
SPOKES = "id1,id2,fn\n" + "".join(f"0,{k},1\n" for k in range(1, 7)) + "".join(f"{k},{k % 6 + 1},1\n" for k in range(1, 7))
THREE = "# dimension: 2\nid,x,y,radius\n1,0,0,0.5\n2,0.98,0,0.5\n3,0.49,0.8487,0.5\n"


def table(text):
    return list(csv.DictReader(line for line in text.splitlines() if not line.startswith("#")))


class Packings(Case):
    def measure(self, particles, contacts, *options, code=0):
        self.write("p.csv", particles)
        self.write("c.csv", contacts)
        return self.program("measure", "p.csv", "c.csv", *options, code=code)

    def test_layers_of_one_height(self):
        for head, z in (("id,x,y,z,radius\n", "0.5,"), ("id,x,y,z,radius\n", "0,"), ("# dimension: 2\nid,x,y,z,radius\n", "0.5,")):
            result = self.measure(head + HEXAGON.format(z=z), SPOKES)
            row = table(result.stdout)[0]
            self.assertAlmostEqual(float(row["z"]), 24 / 7, 12)
            self.assertAlmostEqual(float(row["psi6_local"]), 1, 9)
            self.assertAlmostEqual(float(row["psi6_global"]), 1, 9)
        self.assertIn("z = 0.5", self.measure("id,x,y,z,radius\n" + HEXAGON.format(z="0.5,"), SPOKES).stderr)

    def test_two_contacts_through_both_sides(self):
        grains = "# dimension: 2\n# lo: 0 0 0\n# hi: 1.9 10 0\n# periodic: 1 0 0\nid,x,y,radius\n1,0,5,0.5\n2,0.95,5,0.5\n"
        for contacts in ("1,2,1.0,0,0\n1,2,1.0,-1,0\n", "1,2,1.0,0,0\n2,1,3.0,1,0\n"):
            error = self.measure(grains, "id1,id2,fn,sx,sy\n" + contacts, code=3).stderr
            self.assertIn("both sides of the periodic box, which is only 1.9 wide along x", error)

    def test_mirrored_rows_and_frames(self):
        one = "frame,id1,id2,ft,fn\n1,2,1,0.05,1.2\n1,3,1,0,2.0\n1,1,2,0.05,1.0\n1,3,2,-0.1,3.0\n1,1,3,0,2.0\n"
        result = self.measure(THREE, one)
        self.assertAlmostEqual(float(table(result.stdout)[0]["mean_normal_force"]), 6.1 / 3, 12)
        self.assertIn("given from both sides", result.stderr)
        two = "frame,id1,id2,ft,fn\n1,1,2,0.05,1.0\n1,1,3,0,2.0\n2,2,1,0.05,9.0\n2,3,1,0,8.0\n"
        self.assertIn("c.csv:4:1: the table holds several frames: 1, 2", self.measure(THREE, two, code=3).stderr)
        for frame, mean in (("1", 1.5), ("2", 8.5)):
            row = table(self.measure(THREE, two, "--frame", frame).stdout)[0]
            self.assertEqual(float(row["mean_normal_force"]), mean)
        raw = "1,2,1,0.05,1.2\n1,3,1,0,2\n1,1,-1,0.2,0.7\n"
        self.assertIn("put a row of names above it", self.measure(THREE, raw, code=3).stderr)
        self.assertIn("direction of a contact with a wall", self.measure(THREE, "frame,id1,id2,ft,fn\n" + raw, code=3).stderr)

    def test_tables_of_one_packing_are_not_empty(self):
        # The packing fraction is no multiple of rows_every.
        particles = "# packing_fraction: 0.837\n" + THREE
        contacts = "id1,id2,fn\n1,2,1\n1,3,2\n2,3,3\n"
        for name in ("diagram", "force_distribution", "level_sets", "betti"):
            self.assertTrue(table(self.measure(particles, contacts, "-m", name).stdout), name)
        seldom = self.measure(particles, contacts, "-m", "diagram", "--set", "measure.rows_every=0.02")
        self.assertEqual(table(seldom.stdout), [])
        self.assertIn("no packing fraction is a multiple of measure.rows_every = 0.02", seldom.stderr)
        empty = self.measure(particles, "id1,id2,fn\n", "-m", "stress_distribution")
        if not table(empty.stdout):
            self.assertIn("no rows of 'stress_distribution'", empty.stderr)

    def test_equal_forces_have_no_tail(self):
        grains = "# lo: -1 -1 0\n# hi: 20 1 0\nid,x,y,radius\n" + "".join(f"{k},{0.99 * k!r},0,0.5\n" for k in range(18))
        for contacts, force in ((10, "0.1"), (5, "0.1"), (3, "0.7"), (17, "1e-3"), (7, "0.30000000000000004")):
            rows = "".join(f"{k},{k + 1},{force}\n" for k in range(contacts))
            row = table(self.measure(grains, "id1,id2,fn\n" + rows, "-m", "force_tail", "--set",
                                     "measure.rows_every=0").stdout)[0]
            self.assertEqual((row["tail_contacts"], row["tail_excess"], row["tail_k_mle"]), ("0", "0", "nan"), force)

    def test_text_of_others_does_not_steer_the_terminal(self):
        result = self.measure(THREE.replace("id,x", "# \x1b[2Jcode: 1\nid,x"), "id1,id2,fn\n1,2,1\n1,\x1b[31m,2\n", code=3)
        self.assertNotIn("\x1b", result.stdout + result.stderr)
        self.assertIn("\\x1b[31m", result.stderr)
        noted = self.measure(THREE.replace("radius\n", "radius,\x1b[5m\n").replace("0.5\n", "0.5,1\n"), "id1,id2,fn\n1,2,1\n")
        self.assertNotIn("\x1b", noted.stdout + noted.stderr)
        self.assertIn("\\x1b[5m", noted.stderr)


class Runs(Case):
    def test_a_run_is_measured_with_its_own_gravity(self):
        self.write("heavy.toml", """[study]
name = "heavy"
ledger = "open"
[grains]
count = 36
[domain]
walls = "flat"
gravity = 0.01
[measure]
list = ["balance"]
[[stage]]
to = 0.8
speed = 1e-2
frames = 3
""")
        self.program("run", "heavy.toml", "--out", "out", "--quiet")
        run = str(next((self.folder / "out/tasks").glob("*/run.h5")))
        self.program("measure", run, "-m", "balance", "--out", "alone.csv")
        whole = [r["unbalanced_force"] for r in self.rows("out/tables/frames.csv")]
        self.assertEqual([r["unbalanced_force"] for r in self.rows("alone.csv")], whole)
        self.program("measure", run, "-m", "balance", "--set", "measure.gravity=0", "--out", "without.csv")
        self.assertNotEqual([r["unbalanced_force"] for r in self.rows("without.csv")], whole)
        error = self.program("measure", "out", "--set", "measure.gravity=1", code=2).stderr
        self.assertIn("domain.gravity", error)


class Networks(Case):
    def test_lifetimes_on_the_edge_of_rough(self):
        self.write("n.csv", "i,j,force\n1,2,11\n3,4,11\n2,3,10\n5,6,5\n7,8,5\n6,7,4\n9,10,24\n")
        bins = ("b0_rough", "b0_strong", "b0_medium", "b0_weak")
        row = table(self.program("measure", "n.csv").stdout)[0]
        self.assertEqual([row[b] for b in bins], ["0", "0", "3", "2"])
        row = table(self.program("measure", "n.csv", "--set", "measure.rough_includes_edge=true").stdout)[0]
        self.assertEqual([row[b] for b in bins], ["2", "0", "2", "1"])
        noted = self.program("measure", "n.csv", "--set", "measure.pair_bin=0.1").stderr
        self.assertIn("measure.pair_bin changes nothing", noted)

    def test_separators_and_decimal_commas(self):
        forces = {}
        for name, text in {"german": "i;j;force\n0;1;2,5\n1;2;3,5\n", "stated": "sep=;\ni;j;force\n0;1;2,5\n1;2;3,5\n",
                           "points": "i;j;force\n0;1;2.5\n1;2;3.5\n", "tabs": "i\tj\tforce\n0\t1\t2.5\n1\t2\t3.5\n"}.items():
            self.write(name + ".csv", text)
            forces[name] = [p["birth"] for p in table(self.program("persistence", name + ".csv").stdout)]
        self.assertEqual(set(map(tuple, forces.values())), {("3.5",)})
        self.write("quoted.csv", 'i,j,force\n0,1,"2,5"\n1,2,"3,5"\n')
        error = self.program("persistence", "quoted.csv", code=3).stderr
        self.assertIn("quoted.csv:2:5: '2,5' in column 'force' is no number", error)
        self.assertIn("decimal point", error)

    def test_walls_are_no_grains(self):
        self.write("c.csv", "id1,id2,fn\n0,1,3\n1,2,2\n0,-1,4\n2,-1,1\n")
        result = self.program("persistence", "c.csv")
        self.assertIn("2 of 4 rows are contacts with walls", result.stderr)
        self.assertEqual([p["dimension"] for p in table(result.stdout)], ["0"])
        kept = self.program("persistence", "c.csv", "--walls")
        self.assertEqual([(p["dimension"], p["birth"]) for p in table(kept.stdout)], [("0", "4"), ("1", "1")])
        self.assertEqual(table(self.program("measure", "c.csv").stdout)[0]["vertices"], "3")
        self.assertEqual(table(self.program("measure", "c.csv", "--walls").stdout)[0]["vertices"], "4")

    def test_cells_keep_their_numbers(self):
        # Octahedron: a hollow sphere with a cone on two of its faces.
        edges = [(a, b) for a in range(6) for b in range(a) if a + b != 5] + [(6, k) for k in (0, 1, 2)] + [(7, k) for k in (3, 4, 5)]
        self.write("n.csv", "i,j,force\n" + "".join(f"{a},{b},{30 - n}\n" for n, (a, b) in enumerate(edges)))
        points = {}
        for top in (1, 2, 3):
            self.program("persistence", "n.csv", "--max-dimension", str(top), "--zero-length", "-o", "d.csv", "--cells", "l.csv")
            diagram, cells = (table((self.folder / f).read_text()) for f in ("d.csv", "l.csv"))
            points[top] = [p for p in diagram if p["dimension"] in "01"]
            listed = {(c["dimension"], c["cell"]): c for c in cells}
            for p in diagram:
                birth = listed[p["dimension"], p["birth_cell"]]
                self.assertEqual(birth["force"], p["birth"])
                self.assertEqual(len(birth["vertices"].split()), int(p["dimension"]) + 1)
                if p["essential"] == "0":
                    death = listed[str(int(p["dimension"]) + 1), p["death_cell"]]
                    self.assertEqual(death["force"], p["death"])
        self.assertEqual(points[1], points[2])
        self.assertEqual(points[2], points[3])
        self.assertTrue(any(int(p["death_cell"]) > 5 for p in points[1] if p["dimension"] == "1"))

    def test_complete_graphs_are_asked_for_twice(self):
        self.write("k300.csv", "i,j,force\n" + "".join(f"{a},{b},{a * 300 + b}\n" for a in range(300) for b in range(a)))
        error = self.program("persistence", "k300.csv", "--max-dimension", "2", code=3).stderr
        self.assertRegex(error, r"k300.csv: the diagrams up to dimension 2 need about 3.\de\+08 cliques and \d+ GB")
        self.assertIn("--anyway", error)
        self.write("k40.csv", "i,j,force\n" + "".join(f"{a},{b},{a * 40 + b}\n" for a in range(40) for b in range(a)))
        plain = self.program("persistence", "k40.csv", "--max-dimension", "2").stdout
        self.assertEqual(self.program("persistence", "k40.csv", "--max-dimension", "2", "--anyway").stdout, plain)


class WhatWouldBeIgnored(Case):
    def test_folders_and_files(self):
        self.program("run", "tiny.toml", "--out", "out", "--quiet", "--only", "smooth")
        for options in (["out", "out"], ["out", "tiny.toml"], ["tiny.toml", "out"], ["out", "--out", "m.csv"],
                        ["out", "--frame", "1"], ["out", "--walls"]):
            self.assertIn("try: ", self.program("measure", *options, code=2).stderr, options)
        run = str(next((self.folder / "out").glob("tasks/*/run.h5")))
        self.write("n.csv", "i,j,force\n0,1,1\n")
        self.program("measure", run, "n.csv", code=2)
        self.program("measure", "n.csv", "n.csv", code=2)
        self.program("measure", "n.csv", "--again", code=2)
        self.program("measure", run, "--walls", code=2)
        self.program("measure", run, "--frame", "99", code=2)
        self.assertEqual(len(table(self.program("measure", run, "--frame", "7").stdout)), 1)
        rows = table(self.program("measure", run, "-m", "diagram").stdout)
        self.assertEqual({r["frame"] for r in rows}, {str(f) for f in range(8)})
        self.write("p.csv", THREE)
        self.assertIn("holds particles, but no contacts", self.program("measure", "p.csv", code=2).stderr)

    def test_the_programs_own_export_says_nothing(self):
        self.program("run", "tiny.toml", "--out", "out", "--quiet", "--only", "rough", "--set", "contact.damping=clipped")
        self.program("export", "out", "--out", "csv")
        for f in range(8):
            base = f"csv/rough-0/{{}}-{f:06}.csv"
            result = self.program("measure", base.format("particles"), base.format("contacts"))
            self.assertEqual(result.stderr, "")
            self.assertEqual(table(self.program("measure", base.format("contacts")).stdout)[0]["edges"],
                             table(result.stdout)[0]["contacts"])


if __name__ == "__main__":
    unittest.main()
