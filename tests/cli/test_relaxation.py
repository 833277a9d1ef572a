"""Studies that relax, with units: tables, marks, exit codes, stop and start again, and tables kept without simulations."""

import gzip
import shutil
import unittest

from program import Case

# Two systems with stages of different lengths; the second never gets its relaxation within the budget.
RELAXING = """\
[study]
name = "relaxing"
seed = 4
ledger = "open"  # walls so fast turn over little
realisations = 2

[units]
length = "1.735 cm"
mass = "3.0 g"
young = "23.45 kPa"
speed = "0.01 cm/s"

[grains]
count = 60
sizes = "bidisperse"

[domain]
walls = "flat"
area = "actual"

[contact]
damping = "clipped"

[[stage]]
name = "approach"
to = 0.7
speed = "20 cm/s"

[[stage]]
name = "steps"
kind = "steps"
to = 0.86
speed = "5 cm/s"
increment = 0.02
relax_window = 1000

[measure]
list = ["coordination", "backbone", "percolation", "level_sets"]
force = "total"
clamp = 0
remove_rattlers = true
rows_every = 0

[[system]]
name = "long"

[[system]]
name = "hasty"
stage.steps.to = 0.8
stage.steps.relax_windows = 1
stage.steps.relax_fluctuation = 0
stage.steps.relax_energy = 0
"""

TARGETS = """\
[[target]]
name = "percolation at jamming"
realisations = 2
tolerance = 0.1
left = { quantity = "rho_p", where = { stage.steps.to = 0.86 } }
right = { quantity = "rho_j" }

[[target]]
name = "clusters"
left = { quantity = "level_sets.mean_cluster_pooled", at = "max", reduce = "argmax", where = { stage.steps.to = 0.86 } }
right = { value = 1.5 }
tolerance = 1.5
realisations = 2
"""


class Relaxation(Case):
    def setUp(self):
        super().setUp()
        self.write("relaxing.toml", RELAXING)
        self.write("t.targets.toml", TARGETS)

    def test_the_end_of_every_relaxation_is_in_every_table(self):
        self.program("run", "relaxing.toml", "--out", "out", "--quiet")
        for table in ("frames", "level_sets"):
            rows = self.rows(f"out/tables/{table}.csv")
            columns = list(rows[0])
            self.assertEqual(columns[columns.index("stage") + 1], "relaxation")
            self.assertEqual({r["relaxation"] for r in rows if r["system"] == "hasty"}, {"budget"})
            self.assertNotIn("", {r["relaxation"] for r in rows})
        rows = self.rows("out/tables/frames.csv")
        self.assertEqual(len([r for r in rows if r["system"] == "long"]), 2 * 8)
        self.assertEqual(len([r for r in rows if r["system"] == "hasty"]), 2 * 5)
        means = self.rows("out/ensemble/frames.csv")
        marks = {r["mean"] for r in means if r["quantity"] == "not_relaxed" and r["system"] == "hasty"}
        self.assertEqual(marks, {"1"})
        names = {r["quantity"] for r in self.rows("out/ensemble/transitions.csv") if r["system"] == "long"}
        self.assertLessEqual({"rho_j", "z_at_rho_j", "z_above", "z_backbone_above", "rho_p"}, names)

    def test_not_relaxed_is_a_warning_and_with_strict_an_exit_code(self):
        result = self.program("run", "relaxing.toml", "--out", "out", "--quiet", "--strict", code=4)
        self.assertIn("frames are not relaxed", result.stderr)
        self.program("run", "relaxing.toml", "--out", "out", "--quiet")
        wide = self.program("run", "relaxing.toml", "--out", "wide", "--quiet", "--strict", "--set",
                            "system.hasty.stage.steps.relax_fluctuation=1", "--set", "system.hasty.stage.steps.relax_windows=200")
        self.assertNotIn("not relaxed", wide.stderr)

    def test_without_relaxation_no_column(self):
        self.program("run", "tiny.toml", "--out", "out", "--quiet", "--strict")
        self.assertNotIn("relaxation", self.rows("out/tables/frames.csv")[0])

    def test_scaled_numbers_and_scales_in_the_resolved_study(self):
        self.program("run", "relaxing.toml", "--out", "out", "--quiet")
        text = (self.folder / "out/study.toml").read_text()
        self.assertIn("tau_c = 0.0063", text)
        self.assertIn("stiffness = 4.9348", text)
        self.assertNotIn("cm/s", text)
        again = self.program("run", "out", "--quiet")
        self.assertNotIn("error", again.stderr)

    def test_frames_damaged_before_the_end_are_set_aside(self):
        slow = ["--set", "stage.steps.speed=3e-5", "--set", "study.realisations=1"]
        process = self.start("run", "relaxing.toml", "--out", "out", "--quiet", "--checkpoint", "0.02", "--jobs", "1", *slow)
        frames = self.folder / "out"
        self.wait_for(process, lambda: self.frames("out") >= 3)
        process.terminate()
        process.communicate()
        damaged = sorted(frames.glob("tasks/*/frames/000001.h5"))
        self.assertTrue(damaged, "stopped in the middle")
        damaged[0].write_bytes(damaged[0].read_bytes()[:1000])
        result = self.program("run", "relaxing.toml", "--out", "out", "--json", *slow)
        self.assertIn("simulated again", result.stdout)
        self.assertTrue(list(frames.glob("tasks/*/frames.damaged-1/000001.h5")))
        self.program("run", "relaxing.toml", "--out", "again", "--quiet", *slow)
        self.assert_same_results("out", "again")

    def test_kept_tables_score_like_the_results(self):
        self.program("run", "relaxing.toml", "--out", "out", "--quiet")
        kept = self.folder / "relaxing"
        kept.mkdir()
        for table, ending in (("frames", ""), ("level_sets", ".level_sets")):
            lines = (self.folder / f"out/tables/{table}.csv").read_text().splitlines()
            for system in ("long", "hasty"):
                rows = [lines[0]] + [line for line in lines[1:] if line.startswith(system + ",")]
                (kept / f"{system}{ending}.csv.gz").write_bytes(gzip.compress("\n".join(rows).encode() + b"\n"))
        shutil.copy(self.folder / "out/study.toml", kept)
        there = self.program("score", "out", "--targets", "t.targets.toml").stdout
        here = self.program("score", "relaxing", "--targets", "t.targets.toml").stdout
        self.assertEqual(here, there)
        self.assertIn("runs 2 of 2", here)
        self.program("report", "relaxing", "--out", "page")
        self.assertTrue((self.folder / "page/report.html").exists())
        self.assert_same_results("out", "page")
        self.assertEqual({p.name for p in kept.iterdir()} - {"study.toml"},
                         {f"{s}{e}.csv.gz" for s in ("long", "hasty") for e in ("", ".level_sets")}, "left as they were")
        (kept / "study.toml").unlink()
        result = self.program("score", "relaxing", code=2)
        self.assertIn("no study.toml", result.stderr)
        self.program("report", "out", "--out", "other")
        self.assert_same_results("out", "other")


class Units(Case):
    def complain(self, old, new):
        self.write("relaxing.toml", RELAXING.replace(old, new))
        return self.program("run", "relaxing.toml", "--dry-run", code=2).stderr

    def test_mistakes_in_units(self):
        text = self.complain('length = "1.735 cm"', 'length = "1.735 g"')
        self.assertIn("relaxing.toml:8:10", text)
        self.assertIn("an SI unit such as m", text)
        self.assertIn("has no 'mass'", self.complain('mass = "3.0 g"\n', ""))
        self.assertIn("did you mean 'units.young'?", self.complain("young", "yuong"))
        self.assertIn("[units]", self.complain(RELAXING[RELAXING.index("[units]"):RELAXING.index("[grains]")], ""))


if __name__ == "__main__":
    unittest.main()
