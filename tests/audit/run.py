#!/usr/bin/env python3
"""Measures packings twice, with the program and with the numpy functions here, and prints a table of what differs.

    JAMSCAPE=build/test/jamscape python3 tests/audit/run.py [-m MEASURE ...] [-p PACKING ...]
"""
import argparse
import sys
import tempfile
import time
from pathlib import Path

import measures  # noqa: F401  registers the audits
import networks
import program
from cases import cases
from compare import compare
from options import spelled, with_settings
from registry import AUDITS

HERE = Path(__file__).resolve().parent


def left_out():
    """Columns that README.md lists as not audited: rows `| measure | column | reason |` below the heading."""
    text = (HERE / "README.md").read_text().split("## Not audited", 1)[1].split("\n## ", 1)[0]
    rows = [[cell.strip(" `") for cell in line.strip("|").split("|")] for line in text.splitlines() if line.startswith("| `")]
    return {(row[0], row[1]): row[2] for row in rows}


def sorted_points(columns):
    """A diagram is compared as a multiset."""
    order = sorted(range(len(columns["birth"])), key=lambda k: tuple(float(columns[c][k]) for c in columns))
    return {name: [values[k] for k in order] for name, values in columns.items()}


def audit(case, measure, skipped, differences):
    """Compares every column of a measure on one packing; the number of columns compared."""
    table = case.source.measured(measure, spelled(case.settings))
    _, columns = program.describe(measure)
    ours = AUDITS[measure](case.packing, with_settings({**case.settings, **case.known}))
    table = {name: table[name] for name in columns}
    if measure == "diagram":
        table = sorted_points(table)
    compared = 0
    for column in columns:
        if (measure, column) in skipped:
            continue
        compared += 1
        if column not in ours:
            differences.append((case.name, measure, column, "-", "there", "no audit", "write one, or list it in README.md"))
            continue
        found = compare(column, table, ours[column])
        for row, theirs, value, allowed in found[:4]:
            differences.append((case.name, measure, column, str(row), repr(theirs), repr(value), allowed))
        if len(found) > 4:
            differences.append((case.name, measure, column, "...", f"{len(found)} rows differ", "", ""))
    return compared


def missing(names, skipped):
    """Registered measures that nobody audits, audits and listed reasons of what is not registered."""
    lines = []
    for name in names:
        if name not in AUDITS and not all((name, column) in skipped for column in program.describe(name)[1]):
            lines.append((" ", name, "*", "-", "registered", "no audit", "write one, or list it in README.md"))
    registered = {(name, column) for name in names for column in program.describe(name)[1]}
    lines += [(" ", name, "*", "-", "not registered", "audited", "") for name in AUDITS if name not in names]
    lines += [(" ", *key, "-", "not registered", "listed in README.md", "") for key in skipped if key not in registered]
    return lines


def show(rows):
    header = ("packing", "measure", "column", "row", "jamscape", "audit", "allowed")
    widths = [max(len(str(row[k])) for row in [header, *rows]) for k in range(len(header))]
    for row in [header, *rows]:
        print("  ".join(str(cell).ljust(width) for cell, width in zip(row, widths)).rstrip())


def main():
    options = argparse.ArgumentParser()
    options.add_argument("-m", "--measure", nargs="*", help="only these measures")
    options.add_argument("-p", "--packing", nargs="*", help="only packings whose name begins so")
    asked = options.parse_args()
    began, skipped, names = time.time(), left_out(), program.measures()
    differences = missing(names, skipped)
    count = {name: 0 for name in names}
    seen = set()
    with tempfile.TemporaryDirectory() as folder:
        for case in cases(Path(folder), asked.packing):
            for name in case.measures or names:
                if name in AUDITS and (not asked.measure or name in asked.measure):
                    count[name] += audit(case, name, skipped, differences)
                    seen.add(case.name)
        networked = 0 if asked.measure or asked.packing else networks.audit(Path(folder), differences)
    print(f"{len(seen)} packings and settings, {len(names)} measures, {sum(count.values()) + networked} columns compared, "
          f"{time.time() - began:.0f} s")
    if differences:
        print(f"{len(differences)} differences:")
        show(differences)
        sys.exit(1)


main()
