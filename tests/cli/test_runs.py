"""A study from its file to its tables: the same for any number of jobs and shards, growing without repetition."""

import json
import unittest

from program import STUDY, Case


class Runs(Case):
    def simulated(self, result):
        return sum(json.loads(line)["event"] == "finished" for line in result.stdout.splitlines())

    def test_from_file_to_tables(self):
        out = self.program("run", "tiny.toml", "--out", "out")
        self.assertIn("rho_c", out.stdout)
        self.assertIn("report.html", out.stdout)
        self.assertRegex(out.stderr, r"(?m)^100 %  4/4 runs", "no terminal: plain lines")
        self.assertNotIn("{", out.stderr)
        for file in ("study.toml", "report.html", "tables/frames.csv", "ensemble/frames.csv", "ensemble/transitions.csv"):
            self.assertTrue((self.folder / "out" / file).is_file(), file)
        rows = self.rows("out/tables/frames.csv")
        self.assertEqual(len(rows), 4 * 8)
        leading = ["system", "realisation", "contact.friction", "frame", "stage", "step", "time",
                   "packing_fraction_target", "packing_fraction", "packing_fraction_plain"]
        self.assertEqual(list(rows[0])[:10], leading)
        self.assertEqual({r["contact.friction"] for r in rows}, {"0", "0.5"})
        for row in rows:  # taken at the first step that reaches the target
            self.assertAlmostEqual(float(row["packing_fraction"]), float(row["packing_fraction_target"]), delta=1e-3)
            self.assertGreaterEqual(float(row["z"]), 0)
        mean = {(r["system"], r["frame"]): r for r in self.rows("out/ensemble/frames.csv") if r["quantity"] == "z"}
        for (system, frame), m in mean.items():
            z = [float(r["z"]) for r in rows if r["system"] == system and r["frame"] == frame]
            self.assertEqual(int(m["n"]), len(z))
            self.assertAlmostEqual(float(m["mean"]), sum(z) / len(z), places=12)
            self.assertAlmostEqual(float(m["se"]), abs(z[0] - z[1]) / 2, places=12)

    def test_the_same_for_any_number_of_jobs(self):
        self.program("run", "tiny.toml", "--out", "one", "--jobs", "1", "--quiet")
        self.program("run", "tiny.toml", "--out", "many", "--jobs", "3", "--quiet")
        self.assert_same_results("one", "many")

    def test_one_system_at_a_time(self):
        self.program("run", "tiny.toml", "--out", "whole", "--quiet")
        first = self.program("run", "tiny.toml", "--out", "parts", "--only", "rough", "--json")
        self.assertEqual(self.simulated(first), 2)
        self.assertEqual({r["system"] for r in self.rows("parts/tables/frames.csv")}, {"rough"})
        self.assertTrue((self.folder / "parts/report.html").is_file())
        self.program("run", "tiny.toml", "--out", "parts", "--only", "smooth,rough", "--quiet")
        self.assert_same_results("whole", "parts")
        error = self.program("run", "tiny.toml", "--out", "new", "--only", "smoth", code=2).stderr
        self.assertIn("did you mean 'smooth'", error)
        self.assertFalse((self.folder / "new").exists())

    def test_shards(self):
        self.program("run", "tiny.toml", "--out", "whole", "--quiet")
        first = self.program("run", "tiny.toml", "--out", "parts", "--shard", "1/2", "--json")
        self.assertEqual(self.simulated(first), 2)
        self.assertFalse((self.folder / "parts/tables").exists(), "tables come with the last share")
        self.program("run", "tiny.toml", "--out", "parts", "--shard", "2/2", "--quiet")
        self.assert_same_results("whole", "parts")

    def test_shards_at_the_same_time(self):
        self.program("run", "tiny.toml", "--out", "whole", "--quiet")
        shards = [self.start("run", "tiny.toml", "--out", "parts", "--shard", f"{i}/3", "--jobs", "1") for i in (1, 2, 3)]
        for shard in shards:
            output = shard.communicate(timeout=600)[0]
            self.assertEqual(shard.returncode, 0, output)
        self.assert_same_results("whole", "parts")

    def test_more_realisations_reuse_the_old_ones(self):
        self.program("run", "tiny.toml", "--out", "out", "--quiet")
        more = self.program("run", "tiny.toml", "--out", "out", "--set", "study.realisations=3", "--json")
        self.assertEqual(self.simulated(more), 2)
        self.program("run", "tiny.toml", "--out", "fresh", "--set", "study.realisations=3", "--quiet")
        self.assert_same_results("fresh", "out")

    def test_more_systems_leave_the_others(self):
        self.program("run", "tiny.toml", "--out", "out", "--quiet")
        self.write("more.toml", STUDY + '\n[[system]]\nname = "between"\ncontact.friction = 0.1\n')
        more = self.program("run", "more.toml", "--out", "out", "--json")
        self.assertEqual(self.simulated(more), 2)

    def test_a_new_measure_needs_no_simulation(self):
        few = ('[measure]\nlist = ["coordination"]\n')
        self.write("few.toml", STUDY + few)
        self.program("run", "few.toml", "--out", "out", "--quiet")
        self.assertNotIn("psi6", self.rows("out/tables/frames.csv")[0])
        more = self.program("run", "tiny.toml", "--out", "out", "--json")
        self.assertEqual(self.simulated(more), 0)
        self.assertIn("psi6", self.rows("out/tables/frames.csv")[0])
        self.program("run", "tiny.toml", "--out", "fresh", "--quiet")
        self.assert_same_results("fresh", "out")

    def test_fewer_frames_reuse_and_more_simulate_the_same(self):
        self.program("run", "tiny.toml", "--out", "out", "--quiet")
        fewer = self.program("run", "tiny.toml", "--out", "out", "--set", "stage.compress.frames=2", "--json")
        self.assertEqual(self.simulated(fewer), 0)
        self.assertEqual(len(self.rows("out/tables/frames.csv")), 4 * 3)
        more = self.program("run", "tiny.toml", "--out", "out", "--set", "stage.compress.frames=15", "--json")
        self.assertEqual(self.simulated(more), 4)
        self.program("run", "tiny.toml", "--out", "out", "--quiet")
        self.program("run", "tiny.toml", "--out", "fresh", "--quiet")
        self.assert_same_results("fresh", "out")

    def test_a_study_without_system_tables(self):
        self.write("sweep.toml", STUDY[:STUDY.index("[[system]]")] + "[sweep]\ncontact.friction = [0, 0.5]\n")
        self.program("run", "sweep.toml", "--out", "out", "--quiet")
        rows = self.rows("out/tables/frames.csv")
        self.assertEqual({r["system"] for r in rows}, {"friction=0", "friction=0.5"})
        self.program("run", "tiny.toml", "--out", "named", "--quiet")
        z = [r["z"] for r in self.rows("named/tables/frames.csv")]
        self.assertEqual([r["z"] for r in rows], z, "names do not change numbers")

    def test_results_are_found_without_the_study_file(self):
        self.program("run", "tiny.toml", "--out", "out", "--quiet")
        again = self.program("run", "out", "--json")
        self.assertEqual(self.simulated(again), 0)

    def test_reports_go_by_the_plans_kept_with_the_tasks(self):
        self.program("run", "tiny.toml", "--out", "out", "--quiet")
        plans = list((self.folder / "out/tasks").glob("*/plan.csv"))
        self.assertEqual(len(plans), 4)
        self.program("report", "out", "--out", "kept")
        plans[0].write_text("".join(plans[0].read_text().splitlines(True)[:-1]))  # a line less
        for plan in plans[1:]:  # as in folders of earlier versions
            plan.unlink()
        self.program("report", "out", "--out", "planned")
        tables = [t.relative_to(self.folder / "kept") for t in (self.folder / "kept").glob("*/*.csv")]
        self.assertGreater(len(tables), 10)
        for table in tables:
            self.assertEqual((self.folder / "kept" / table).read_bytes(), (self.folder / "planned" / table).read_bytes())

    def test_a_failing_run_lets_the_others_go_on(self):
        # One step is longer than a grain needs to pass another: this system must blow up.
        self.write("bad.toml", STUDY.replace("contact.friction = 0.5",
                                             "contact.friction = 0.5\nstage.compress.speed = 0.4\nintegrator.step = 0.2"))
        result = self.program("run", "bad.toml", "--out", "out", code=6)
        self.assertIn("failed", result.stderr)
        systems = {r["system"] for r in self.rows("out/tables/frames.csv")}
        self.assertEqual(systems, {"smooth"})
        status = json.loads(self.program("status", "out", "--json").stdout)
        reasons = [t["reason"] for t in status["tasks"] if t["state"] == "failed"]
        self.assertEqual(len(reasons), 2)
        for reason in reasons:
            self.assertIn("step", reason)
        self.program("run", "bad.toml", "--out", "out", "--quiet", code=6)

    def test_dry_run_writes_nothing(self):
        out = self.program("run", "tiny.toml", "--dry-run").stdout
        self.assertIn("4 runs", out)
        self.assertEqual(set(self.files(".")), {"tiny.toml"})

    def test_dry_run_names_systems_that_use_fewer_threads(self):
        self.assertNotIn("threads", self.program("run", "tiny.toml", "--dry-run", "--threads", "1").stdout)
        out = self.program("run", "tiny.toml", "--dry-run", "--threads", "3").stdout
        self.assertEqual(out.count("of 3 threads each run uses 1"), 2, out)
        ran = self.program("run", "tiny.toml", "--threads", "3").stderr
        self.assertEqual(ran.count("of 3 threads each run uses 1"), 2, ran)
        large = self.program("run", "quickstart", "--dry-run", "--threads", "3", "--set", "grains.count=22000",
                             "--set", "start.packing_fraction=0.5").stdout
        self.assertNotIn("of 3 threads", large)


if __name__ == "__main__":
    unittest.main()
