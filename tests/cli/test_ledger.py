"""The energy ledger is watched: a run that makes energy is stopped, or marked where the study allows it by name."""

import unittest

from program import Case

# Linear springs, clipped dashpots, friction, Gear at .02: the ledger is off by 20 times what was turned over at .9.
MAKING = """\
[study]
name = "making"
seed = 3
realisations = 2

[grains]
count = 64
width = 0.4

[domain]
area = "actual"

[contact]
friction = 0.5
damping = "clipped"

[integrator]
scheme = "gear5"
step = 0.02

[[stage]]
name = "approach"
to = 0.6
speed = 1e-2

[[stage]]
name = "compress"
to = 0.9
speed = 1e-3
frames = 16

[measure]
list = ["coordination", "energy", "force_distribution"]
"""


class Ledger(Case):
    def setUp(self):
        super().setUp()
        self.write("making.toml", MAKING)

    def test_a_run_that_makes_energy_is_stopped(self):
        self.program("run", "making.toml", "-o", "out", "-q", code=6)
        status = self.program("status", "out").stdout
        self.assertEqual(status.count("the energy ledger is off by"), 2)
        self.assertIn("study.ledger", status)

    def test_or_marked_where_the_study_allows_it(self):
        result = self.program("run", "making.toml", "-o", "out", "-q", "--set", "study.ledger=\"open\"")
        self.assertIn("warning: system 'making': the energy ledger of ", result.stderr)
        self.assertIn("of 2 of 2 runs", result.stderr)
        rows = self.rows("out/tables/frames.csv")
        for row in rows:
            self.assertEqual(row["marked"], "1" if float(row["ledger_error"]) > 0.01 else "0")
        self.assertEqual(rows[-1]["marked"], "1")
        marked = {(r["realisation"], r["frame"]) for r in rows if r["marked"] == "1"}
        others = self.rows("out/tables/force_distribution.csv")
        self.assertEqual(marked, {(r["realisation"], r["frame"]) for r in others if r["marked"] == "1"})
        last = [r for r in self.rows("out/ensemble/frames.csv") if r["quantity"] == "z"][-1]
        self.assertEqual((last["n"], last["marked"]), ("2", "2"))
        page = (self.folder / "out" / "report.html").read_text()
        self.assertIn('"ledger":{"frames":', page)

    def test_and_marked_frames_enter_no_mean_otherwise(self):
        self.program("run", "making.toml", "-o", "out", "-q", "--set", "study.ledger_stop=1e5")
        means = [r for r in self.rows("out/ensemble/frames.csv") if r["quantity"] == "z"]
        for row in means:
            self.assertEqual(int(row["n"]) + int(row["marked"]), 2)
        self.assertEqual((means[-1]["n"], means[-1]["marked"]), ("0", "2"))
        bins = self.rows("out/ensemble/force_distribution.csv")
        self.assertNotIn(means[-1]["frame"], {r["frame"] for r in bins})

    def test_a_scheme_that_closes_marks_nothing(self):
        result = self.program("run", "making.toml", "-o", "out", "-q", "--set", "integrator.scheme=\"verlet\"", "--set",
                              "integrator.step=0.005")
        self.assertNotIn("ledger", result.stderr)
        self.assertEqual({r["marked"] for r in self.rows("out/tables/frames.csv")}, {"0"})


if __name__ == "__main__":
    unittest.main(verbosity=2)
