"""Places that can do less: read-only archives, folders of others, file systems without locks or fsync, full disks, few
cores."""

import os
import shutil
import subprocess
import unittest

from program import PROGRAM, Case

TINY = """\
[study]
name = "tiny"
realisations = 2

[grains]
count = 36

[[stage]]
name = "compress"
to = 0.8
speed = 2e-3
frames = 4
"""

TARGETS = """
[[target]]
name = "z grows"
realisations = 2
left = { quantity = "z", at = "0.8" }
right = { quantity = "z", at = "0.6" }
"""


class Places(Case):
    def setUp(self):
        super().setUp()
        self.write("tiny.toml", TINY)
        self.write("targets.toml", TARGETS)

    def results(self, out="out"):
        self.program("run", "tiny.toml", "--out", out, "--quiet")

    def check_reading(self, run):
        """What needs no writing works; what does says where else it can go. `run` starts the program."""
        before = self.files("out")
        for command in (["status", "out"], ["verify", "out", "--all"], ["measure", "out"], ["measure", "out", "--again"],
                        ["measure", "out", "--set", "measure.clamp=1"], ["score", "out", "--targets", "targets.toml"],
                        ["export", "out", "--out", "free/csv"], ["report", "out", "--out", "free/report"]):
            result = run(command)
            self.assertEqual(result.returncode, 0, f"{command}\n{result.stdout}\n{result.stderr}")
        result = run(["report", "out"])
        self.assertEqual(result.returncode, 3, result.stderr)
        self.assertIn("--out", result.stderr)
        result = run(["run", "tiny.toml", "--out", "out", "--set", "study.realisations=3", "--quiet"])
        self.assertNotEqual(result.returncode, 0)
        self.assertEqual(self.files("out"), before)
        self.assert_same_results("out", "free/report")
        self.assertTrue((self.folder / "free/report/report.html").is_file())

    def test_read_only_file_system(self):
        self.results()
        (self.folder / "free").mkdir()
        mount = f"mount --bind {self.folder}/out {self.folder}/out && mount -o remount,ro,bind {self.folder}/out"
        enter = ["unshare", "-rm", "bash", "-c", f'{mount} && ! touch {self.folder}/out/x 2>/dev/null || exit 99; exec "$@"', "-"]

        def run(command):
            return subprocess.run([*enter, PROGRAM, *command], cwd=self.folder, capture_output=True, text=True, timeout=600)
        try:
            able = subprocess.run([*enter, "true"], cwd=self.folder, capture_output=True).returncode == 0
        except OSError:
            able = False
        if not able:
            self.skipTest("nothing can be mounted here")
        self.check_reading(run)

    def test_results_of_somebody_else(self):
        self.results()
        (self.folder / "free").mkdir()
        user = {}
        if os.geteuid() == 0:  # whom no permission stops
            user = {"user": 65534, "group": 65534, "extra_groups": []}
            os.chmod(self.folder, 0o755)
            os.chmod(self.folder / "free", 0o777)
            program = self.folder / "jamscape"
            shutil.copy(PROGRAM, program)
        else:
            program = PROGRAM
            for path in [*(self.folder / "out").rglob("*"), self.folder / "out"]:
                path.chmod(0o555 if path.is_dir() else 0o444)
            self.addCleanup(lambda: [p.chmod(0o755) for p in [self.folder / "out", *(self.folder / "out").rglob("*")]])

        def run(command):
            return subprocess.run([program, *command], cwd=self.folder, capture_output=True, text=True, timeout=600, **user)
        if run(["--version"]).returncode != 0:
            self.skipTest("no other user may run the program here")
        self.check_reading(run)

    def test_rows_that_are_missing_are_measured_elsewhere(self):
        self.results()
        for file in (self.folder / "out").glob("tasks/*/tables/coordination.csv"):
            file.unlink()
        shutil.copytree(self.folder / "out", self.folder / "kept")
        self.program("report", "out", "--out", "free")
        self.assertEqual(self.files("out"), self.files("kept"))
        self.assert_same_results("out", "free")
        self.assertTrue(list((self.folder / "free").glob("tasks/*/tables/coordination.csv")))

    def preloaded(self, **settings):
        return {**os.environ, "LD_PRELOAD": os.environ["SHIM"], "ASAN_OPTIONS": "verify_asan_link_order=0",
                **{k: str(v) for k, v in settings.items()}}

    def test_without_locks_or_fsync(self):
        self.results("plain")
        for call, code, words in [("FLOCK", e, "has no locks") for e in (22, 37, 38, 95, 524)] + \
                                 [("FSYNC", e, "cannot force files to its disk") for e in (22, 38, 95, 524)]:
            out = f"{call}{code}"
            result = self.program("run", "tiny.toml", "--out", out, "--quiet", env=self.preloaded(**{f"SHIM_{call}": code}))
            self.assertEqual(result.stderr.count("note: "), 1, result.stderr)
            self.assertIn(words, result.stderr)
            self.assert_same_results("plain", out)
            status = self.program("status", out, env=self.preloaded(**{f"SHIM_{call}": code})).stdout
            self.assertIn("2 of 2 runs done, 0 running", status)

    def test_an_fsync_that_fails_is_a_failure(self):
        result = self.program("run", "tiny.toml", "--out", "out", "--quiet", code=None, env=self.preloaded(SHIM_FSYNC=5))
        self.assertIn(result.returncode, (3, 6))
        self.assertIn("Input/output error", result.stderr)

    def test_full_disk(self):
        for code, words in ((28, "No space left on device"), (122, "Disk quota exceeded")):
            for after in (0, 20000, 100000):
                env = self.preloaded(SHIM_WRITE=code, SHIM_AFTER=after)
                out = f"out{code}-{after}"
                result = self.program("run", "tiny.toml", "--out", out, "--quiet", code=None, env=env)
                self.assertIn(result.returncode, (3, 6), result.stderr)
                self.assertIn(words, result.stderr)
                self.assertNotIn("HDF5:", result.stderr)
                self.results(out)

    def test_full_output(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("no /dev/full here")
        self.results()
        with open("/dev/full", "w") as full:
            result = subprocess.run([PROGRAM, "status", "out"], cwd=self.folder, stdout=full, stderr=subprocess.PIPE, text=True)
        self.assertEqual(result.returncode, 3)
        self.assertIn("No space left", result.stderr)

    def test_cores(self):
        core = min(os.sched_getaffinity(0))
        result = self.program("run", "tiny.toml", "--dry-run", preexec_fn=lambda: os.sched_setaffinity(0, {core}))
        self.assertIn("on 1 cores", result.stdout)


if __name__ == "__main__":
    unittest.main()
