"""Asks the program: which measures it has, and what it measures."""
import csv
import functools
import io
import os
import subprocess
from pathlib import Path

JAMSCAPE = os.environ.get("JAMSCAPE", "build/test/jamscape")


def call(*arguments):
    """Standard output of `jamscape ARGUMENTS`."""
    done = subprocess.run([JAMSCAPE, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"jamscape {' '.join(map(str, arguments))}: exit code {done.returncode}\n{done.stderr}")
    return done.stdout


def measures():
    """Names of all registered measures, as `jamscape explain` lists them."""
    listed, names = False, []
    for line in call("explain").splitlines():
        if line.startswith("Measures:"):
            listed = True
        elif listed and line.startswith("  "):
            names.append(line.split()[0])
        elif listed:
            break
    return names


@functools.lru_cache(maxsize=None)
def describe(measure):
    """Whether a measure gives one row a frame, and its columns, as `jamscape explain MEASURE` lists them."""
    lines = call("explain", measure).splitlines()
    rows = next(k for k, line in enumerate(lines) if line.startswith("  one row") or line.startswith("  several rows"))
    columns = []
    for line in lines[rows + 1:]:
        if not line.startswith("    ") or line.split()[0] == "ensemble:":
            break
        columns.append(line.split()[0])
    return lines[rows].startswith("  one row"), columns


def table(text):
    """Columns of a CSV text, as lists of texts."""
    rows = list(csv.reader(io.StringIO(text)))
    return {name: [row[k] for row in rows[1:]] for k, name in enumerate(rows[0])}


@functools.lru_cache(maxsize=None)
def read(path):
    return table(path.read_text())


def rows_of_frame(columns, frame):
    """The rows of one frame of a table of a folder of results."""
    kept = [k for k, f in enumerate(columns["frame"]) if int(f) == frame]
    return {name: [values[k] for k in kept] for name, values in columns.items()}


class Files:
    """A packing in two files, measured by `jamscape measure`."""

    def __init__(self, particles, contacts):
        self.files, self.rows = [particles, contacts], {}

    def measured(self, measure, settings):
        sets = [part for key, value in settings.items() for part in ("--set", f"measure.{key}={value}")]
        if not describe(measure)[0]:
            return table(call("measure", *self.files, "-m", measure, *sets))
        if tuple(sets) not in self.rows:  # all measures of one row together
            self.rows[tuple(sets)] = table(call("measure", *self.files, *sets))
        return self.rows[tuple(sets)]


class Frame:
    """A frame of a folder of results, from its tables."""

    def __init__(self, results, frame):
        self.results, self.frame = Path(results), frame

    def measured(self, measure, settings):
        one_row, _ = describe(measure)
        path = self.results / "tables" / ("frames.csv" if one_row else f"{measure}.csv")
        return rows_of_frame(read(path), self.frame)
