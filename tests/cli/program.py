"""Running the program in a folder of its own."""

import filecmp
import glob
import os
import pathlib
import shutil
import subprocess
import tempfile
import time
import unittest

PROGRAM = os.environ["JAMSCAPE"]

# Small and fast, but the real protocol: rough walls, friction, Gear, frames, all measures.
STUDY = """\
[study]
name = "tiny"
seed = 3
realisations = 2
ledger = "open"  # walls so fast turn over little
[grains]
count = 64
width = 0.4

[integrator]
scheme = "gear5"

[[stage]]
name = "approach"
to = 0.6
speed = 1e-2

[[stage]]
name = "compress"
to = 0.88
speed = 2e-3
frames = 8
frames_at = [0.8]

[[system]]
name = "smooth"
contact.friction = 0

[[system]]
name = "rough"
contact.friction = 0.5
"""


class Case(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="jamscape-cli-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.write("tiny.toml", STUDY)

    def write(self, name, text):
        (self.folder / name).write_text(text)
        return name

    def program(self, *arguments, code=0, **options):
        """Runs to the end and returns the result; fails when the exit code is another (None: any)."""
        result = subprocess.run([PROGRAM, *arguments], cwd=self.folder, capture_output=True, text=True, timeout=600,
                                **options)
        if code is not None:
            self.assertEqual(result.returncode, code, f"{arguments}\n{result.stdout}\n{result.stderr}")
        return result

    def start(self, *arguments):
        return subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                text=True)

    def wait_for(self, process, condition):
        """Until the condition holds or the process has ended."""
        while process.poll() is None and not condition():
            time.sleep(0.001)

    def count(self, pattern, folder):
        """Files; folders may vanish meanwhile (pathlib's glob would throw)."""
        return len(glob.glob(pattern, root_dir=self.folder / folder))

    def frames(self, out):
        return self.count("tasks/*/frames/*.h5", out)

    def checkpoints(self, out):
        return self.count("tasks/*/checkpoint.h5", out)

    def files(self, folder):
        base = self.folder / folder
        return {str(p.relative_to(base)): p.read_bytes() for p in base.rglob("*") if p.is_file()}

    def assert_same_results(self, a, b):
        """Tables and means of two folders are equal to the byte."""
        for part in ("tables", "ensemble"):
            names = sorted(p.name for p in (self.folder / a / part).iterdir())
            self.assertEqual(names, sorted(p.name for p in (self.folder / b / part).iterdir()))
            self.assertIn("frames.csv", names)
            for name in names:
                same = filecmp.cmp(self.folder / a / part / name, self.folder / b / part / name, shallow=False)
                self.assertTrue(same, f"{part}/{name} differs between {a} and {b}")

    def rows(self, file):
        lines = (self.folder / file).read_text().splitlines()
        header = lines[0].split(",")
        return [dict(zip(header, line.split(","))) for line in lines[1:]]
