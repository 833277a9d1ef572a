"""The commands on results, and on data made elsewhere."""

import json
import unittest

from program import Case


class OnResults(Case):
    def setUp(self):
        super().setUp()
        self.program("run", "tiny.toml", "--out", "out", "--quiet")

    def test_status(self):
        text = self.program("status", "out").stdout
        self.assertIn("4 of 4 runs done", text)
        times = self.program("status", "out", "--times").stdout
        self.assertRegex(times, r"smooth +2 of 2 .* s\b")
        self.assertRegex(times, r"the whole study: .* cores")
        status = json.loads(self.program("status", "out", "--json").stdout)
        for task in status["tasks"]:
            self.assertGreater(task["steps"], 0)
            self.assertGreater(task["seconds"], 0)
            self.assertGreater(task["core_seconds"], 0)
        self.assertEqual((status["done"], status["failed"], status["running"]), (4, 0, 0))

    def test_report_again(self):
        before = self.files("out/tables")
        (self.folder / "out/report.html").unlink()
        self.program("report", "out")
        self.assertTrue((self.folder / "out/report.html").is_file())
        self.assertEqual(self.files("out/tables"), before)

    def test_measure_with_other_options(self):
        before = self.rows("out/tables/frames.csv")
        self.program("measure", "out", "--set", "measure.clamp=1")
        after = self.rows("out/tables/frames.csv")
        self.assertEqual([r["z"] for r in before], [r["z"] for r in after])
        self.assertNotEqual([r["tp0"] for r in before], [r["tp0"] for r in after])
        self.assertIn("clamp = 1.0", (self.folder / "out/study.toml").read_text())
        self.assertIn("simulating again", self.program("measure", "out", "--set", "grains.count=3", code=2).stderr)

    def test_verify(self):
        self.assertIn("the same bits", self.program("verify", "out", "--all").stdout)
        run = next((self.folder / "out").glob("tasks/*/run.h5"))
        data = bytearray(run.read_bytes())
        data[len(data) // 2] ^= 1
        run.write_bytes(bytes(data))
        self.program("verify", "out", "--task", run.parent.name, code=3)

    def test_view_says_where(self):
        import os
        env = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
        self.assertIn("report.html", self.program("view", "out", env=env).stdout)

    def test_score_needs_targets_and_runs(self):
        self.assertIn("--targets", self.program("score", "out", code=2).stderr)
        self.write("t.toml", """
[[target]]
name = "z grows"
source = "common sense"
realisations = 2
left = { quantity = "z", at = "0.88" }
right = { quantity = "z", at = "0.6" }

[[target]]
name = "z shrinks"
realisations = 2
left = { quantity = "z", at = "0.6" }
right = { quantity = "z", at = "0.88" }

[[target]]
name = "far off, and known to be"
realisations = 2
quantity = "rho_c"
value = 0.5
tolerance = 0.001
known_deviation = "it is made up"
where = { contact.friction = 0.5 }

[[target]]
name = "many runs"
realisations = 100
quantity = "rho_c"
value = 0.8
tolerance = 0.1

[[target]]
name = "of another study"
quantity = "rho_c"
value = 0.8
tolerance = 0.1
where = { contact.friction = 7 }
""")
        lines = [json.loads(x) for x in self.program("score", "out", "--targets", "t.toml", "--json").stdout.splitlines()]
        verdicts = {}
        for line in lines:
            verdicts.setdefault(line["target"], []).append(line["verdict"])
        self.assertEqual(verdicts, {"z grows": ["pass", "pass"], "z shrinks": ["fail", "fail"],
                                    "far off, and known to be": ["known deviation"],
                                    "many runs": ["insufficient", "insufficient"]})
        text = self.program("score", "out", "--targets", "t.toml").stdout
        self.assertIn("1 targets are of systems that this study does not have", text)

    def test_export_and_measure_come_back_to_the_same(self):
        self.program("export", "out", "--out", "csv")
        self.assertEqual(len(list((self.folder / "csv").rglob("particles-*.csv"))), 4 * 8)
        row = next(r for r in self.rows("out/tables/frames.csv")
                   if r["system"] == "rough" and r["realisation"] == "0" and r["frame"] == "7")
        self.program("measure", "csv/rough-0/particles-000007.csv", "csv/rough-0/contacts-000007.csv", "--out", "m.csv")
        measured = self.rows("m.csv")[0]
        for name in ("z", "rattlers", "psi6", "b0_strong", "b1_weak", "tp0", "tp1", "mean_normal_force"):
            self.assertEqual(measured[name], row[name], name)
        h5 = next((self.folder / "out").glob("tasks/*/run.h5"))
        out = self.program("measure", str(h5), "--measure", "coordination").stdout.splitlines()
        self.assertEqual(len(out), 1 + 8)


class OnData(Case):
    def test_persistence_of_known_networks(self):
        # theory sec. 4: a square of forces 4, 3, 2, 1; the same with a weak diagonal is in the unit tests.
        self.write("square.csv", "i,j,force\n0,1,4\n1,2,3\n2,3,2\n3,0,1\n")
        lines = [x for x in self.program("persistence", "square.csv").stdout.splitlines() if not x.startswith("#")]
        self.assertEqual(lines[0], "dimension,birth,death,essential,birth_cell,death_cell,i,j")
        self.assertEqual([x.split(",")[:4] for x in lines[1:]], [["0", "4", "0", "1"], ["1", "1", "0", "1"]])
        self.assertEqual(set(lines[2].split(",")[6:]), {"0", "3"}, "the contact that closes the loop")

    def test_triangles_filled_or_kept(self):
        self.write("triangle.csv", "i,j,force\n5,6,3\n6,7,2\n7,5,1\n")
        count = {}
        for rule in ("fill", "keep"):
            self.program("persistence", "triangle.csv", "--triangles", rule, "--out", f"{rule}.csv")
            text = (self.folder / f"{rule}.csv").read_text()
            count[rule] = sum(line.startswith("1,") for line in text.splitlines())
        self.assertEqual(count, {"fill": 0, "keep": 1})

    def test_measure_a_network(self):
        self.write("square.csv", "i,j,force\n0,1,4\n1,2,3\n2,3,2\n3,0,1\n")
        self.program("measure", "square.csv", "--out", "m.csv")
        row = self.rows("m.csv")[0]
        self.assertEqual((row["vertices"], row["edges"], float(row["mean_force"]), float(row["z"])), ("4", "4", 2.5, 2.0))
        self.assertAlmostEqual(float(row["tp0"]), 4 / 2.5)

    def test_studies_and_explain(self):
        listed = self.program("studies").stdout
        for name in ("quickstart", "kramar2013", "kramar2013-mu0.5-rp0.4"):
            self.assertIn(name, listed)
        printed = self.program("studies", "quickstart").stdout
        self.write("copy.toml", printed)
        self.assertEqual(self.program("run", "copy.toml", "--dry-run").stdout,
                         self.program("run", "quickstart", "--dry-run").stdout)
        self.assertIn("jamscape studies quickstart", self.program("studies", "quickstrt", code=2).stderr)
        text = self.program("explain", "contact.friction").stdout
        self.assertIn("Coulomb", text)
        self.assertIn("d/tau_c", self.program("explain", "stage.compress.speed").stdout)
        self.assertIn("bond", self.program("explain", "psi6").stdout)
        self.assertIn("grains.width", self.program("explain").stdout)
        self.assertIn("jamscape explain contact.friction", self.program("explain", "contact.frction", code=2).stderr)

    def test_help_and_version(self):
        self.assertIn("persistence", self.program("--help").stdout)
        self.assertIn("--shard", self.program("run", "--help").stdout)
        self.assertRegex(self.program("--version").stdout, r"jamscape \d+\.\d+\.\d+")


if __name__ == "__main__":
    unittest.main()
