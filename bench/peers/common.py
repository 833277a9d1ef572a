"""What the comparisons share: running programs, reading LAMMPS's dumps."""
import os
import subprocess
import sys


class Disagreement(Exception):
    pass


def command(words, **more):
    done = subprocess.run([str(w) for w in words], stdin=subprocess.DEVNULL, capture_output=True, text=True, **more)
    if done.returncode != 0:
        sys.exit(f"run_engine: {' '.join(map(str, words))}\nended with {done.returncode}:\n"
                 f"{done.stdout[-2000:]}{done.stderr[-2000:]}")
    return done.stdout


def run_lammps(script, folder, **variables):
    """Runs an input in `folder`, as one process with one thread; its log as text."""
    words = ["lmp", "-in", script, "-log", f"{script}.log", "-screen", "none"]
    for name, value in variables.items():
        words += ["-var", name, repr(value) if isinstance(value, float) else str(value)]
    command(words, cwd=folder, env={**os.environ, "OMP_NUM_THREADS": "1"})
    return (folder / f"{script}.log").read_text()


def dump(path):
    """The rows of a LAMMPS dump of one instant."""
    lines = path.read_text().split("\n")
    return [[float(w) for w in line.split()] for line in lines[9:9 + int(lines[3])]]
