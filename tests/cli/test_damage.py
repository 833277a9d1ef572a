"""One rule for damage: whatever is done with results, it is named, the others go on, and the exit code says so; `run`
simulates again."""

import random
import shutil
import unittest

from program import Case

TARGETS = """
[[target]]
name = "z grows"
realisations = 2
left = { quantity = "z", at = "0.88" }
right = { quantity = "z", at = "0.6" }
"""


def flip(data, bit):
    data = bytearray(data)
    data[bit // 8] ^= 1 << bit % 8
    return bytes(data)


class Damage(Case):
    def setUp(self):
        super().setUp()
        self.write("targets.toml", TARGETS)
        self.program("run", "tiny.toml", "--out", "sound", "--quiet")

    def spoil(self, change, pattern="tasks/*/run.h5"):
        """A copy of the results in which one file is changed; that file."""
        shutil.rmtree(self.folder / "out", ignore_errors=True)
        shutil.copytree(self.folder / "sound", self.folder / "out")
        file = sorted((self.folder / "out").glob(pattern))[0]
        file.write_bytes(change(file.read_bytes()))
        return file

    def realisations(self, table):
        return {(r["system"], r["realisation"]) for r in self.rows(table)}

    def test_named_everywhere_and_made_anew(self):
        rng = random.Random(5)
        changes = {
            "one byte less": lambda d: d[:-1],
            "half": lambda d: d[: len(d) // 2],
            "nothing left": lambda d: b"",
            "without its seal": lambda d: d[:-24],
            "one bit": lambda d: flip(d, rng.randrange(8 * len(d))),
            "text": lambda d: b"no HDF5 file\n",
        }
        for name, change in changes.items():
            with self.subTest(name):
                file = self.spoil(change)
                for command in (["status", "out"], ["report", "out"], ["measure", "out", "--again"],
                                ["score", "out", "--targets", "targets.toml"], ["export", "out", "--out", "csv"],
                                ["verify", "out", "--all"], ["verify", "out"]):
                    result = self.program(*command, code=3)
                    self.assertIn(str(file.relative_to(self.folder)), result.stdout + result.stderr, command)
                    if command[0] == "report":
                        self.assertEqual(len(self.realisations("out/tables/frames.csv")), 3)
                    if command[0] == "verify":
                        self.assertIn("the same bits", result.stdout)
                    if command[0] == "export":
                        self.assertEqual(len(list((self.folder / "csv").rglob("particles-*.csv"))), 3 * 8)
                        shutil.rmtree(self.folder / "csv")
                damaged = file.read_bytes()
                said = self.program("run", "tiny.toml", "--out", "out", "--quiet").stderr
                self.assertIn("run.damaged-1.h5, and is simulated again", said)
                self.assertEqual((file.parent / "run.damaged-1.h5").read_bytes(), damaged, "nothing is thrown away")
                self.assert_same_results("sound", "out")
                self.program("verify", "out", "--all")

    def test_of_another_system_than_those_asked_for(self):
        codes = set()
        for only in ("smooth", "rough"):
            self.spoil(lambda d: d[:-1])
            result = self.program("run", "tiny.toml", "--out", "out", "--only", only, "--quiet", code=None)
            codes.add(result.returncode)
            if result.returncode == 0:  # it was of this system, and was made anew
                self.assert_same_results("sound", "out")
            else:
                self.assertEqual(result.returncode, 3)
                self.assertIn("is left out", result.stderr)
        self.assertEqual(codes, {0, 3})

    def test_of_rows_kept(self):
        """A digit of a table in a task's folder: its bytes are not those written, so it is measured anew."""
        self.spoil(lambda d: d.replace(b"1", b"2"), "tasks/*/tables/coordination.csv")
        self.program("report", "out")
        self.assert_same_results("sound", "out")
        self.spoil(lambda d: d[:-9], "tasks/*/tables/keys.json")
        self.program("report", "out")
        self.assert_same_results("sound", "out")

    def test_of_one_among_several_files(self):
        file = self.spoil(lambda d: d[:-1])
        others = [str(p.relative_to(self.folder)) for p in sorted((self.folder / "out").glob("tasks/*/run.h5"))]
        result = self.program("measure", *others, "--measure", "energy", code=3)
        self.assertIn(str(file.relative_to(self.folder)), result.stderr)
        self.assertEqual(len(result.stdout.splitlines()), 1 + 3 * 8)


if __name__ == "__main__":
    unittest.main()
