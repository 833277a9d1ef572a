"""The packings that are measured, and the options they are measured with."""
from dataclasses import dataclass, field
from pathlib import Path

import packing
import program

HERE = Path(__file__).resolve().parent
ALL = {"rows_every": 0}  # every measure at every packing fraction

# Each setting with the measures that it can change; none: all of them.
VARIANTS = [
    ("", {}, None),
    ("no rattlers", {"remove_rattlers": True}, None),
    ("total force", {"force": "total", "clamp": 0.0},
     ["contacts", "persistence_bins", "total_persistence", "percolation", "betti", "level_sets", "force_distribution",
      "diagram"]),
    ("no clamp, edge rough", {"rough_includes_edge": True, "clamp": 0.0, "remove_rattlers": True},
     ["persistence_bins", "total_persistence", "diagram"]),
    ("other bins", {"force_scale": "linear", "force_min": 0.0, "force_max": 5.0, "force_bins": 20, "contact_force_max": 6.0,
                    "contact_force_bins": 24, "betti_step": 0.1, "betti_max": 2.0, "level_step": 0.1, "level_max": 2.0},
     ["force_distribution", "contact_force_distribution", "stress_distribution", "contact_forces", "force_tail", "betti",
      "level_sets"]),
    ("away from walls", {"force_margin": 1.0, "gravity": 0.001},
     ["contact_forces", "contact_force_distribution", "stress_distribution", "balance", "force_distribution", "force_tail",
      "walls"]),
    ("hollow tetrahedra", {"tetrahedra": "hollow"}, ["level_sets"]),
    ("other margins", {"pair_bin": 0.05, "pair_range": 4.0, "pair_margin": 1.5, "rdf_bin": 0.04, "rdf_range": 3.0,
                       "rdf_margin_ends": 2.0, "rdf_margin_sides": 1.5},
     ["pair_correlation", "radial_distribution", "rdf_peaks"]),
]


@dataclass
class Case:
    name: str
    packing: packing.Packing
    source: object
    settings: dict
    measures: list = None
    known: dict = field(default_factory=dict)  # what the program takes from the study


def of_files(name, particles, contacts):
    read = packing.read(particles, contacts)
    for variant, settings, measures in VARIANTS:
        full = f"{name}, {variant}" if variant else name
        yield Case(full, read, program.Files(particles, contacts), {**settings, **ALL}, measures)


def of_study(name, folder):
    """Runs studies/NAME.toml; every frame from the exported tables beside the study's own."""
    results, tables = folder / name, folder / f"{name}-frames"
    program.call("run", HERE / "studies" / f"{name}.toml", "--out", results, "--quiet")
    program.call("export", results, "-o", tables)
    particles = sorted(tables.glob("*/particles-*.csv"))
    for frame, file in enumerate(particles):
        contacts = file.with_name(file.name.replace("particles", "contacts"))
        read = packing.read(file, contacts)
        read.bead = 0.5 if name == "beads" else 0.0  # the tables do not say so
        known = {"gravity": 0.0005} if name == "crosses" else {}  # domain.gravity of studies/crosses.toml
        yield Case(f"{name}, frame {frame}", read, program.Frame(results, frame), ALL, known=known)
    yield from of_files(f"{name}, exported", particles[-1], particles[-1].with_name(
        particles[-1].name.replace("particles", "contacts")))


def cases(folder, wanted=None):
    asked = lambda name: not wanted or any(name.startswith(w) or w.startswith(name) for w in wanted)
    for name in ("discs", "spheres"):
        if asked(name):
            yield from of_files(name, HERE / f"packings/{name}.particles.csv.gz", HERE / f"packings/{name}.contacts.csv.gz")
    for name in ("beads", "flat", "crosses"):
        if asked(name):
            yield from of_study(name, folder)
