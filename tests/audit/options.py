"""Options of the measures with their defaults, as docs/reference/options.md lists them."""
from dataclasses import dataclass, replace


@dataclass(frozen=True)
class Options:
    force: str = "normal"
    clamp: float = 5.0
    remove_rattlers: bool = False
    rows_every: float = 0.02
    pair_bin: float = 0.02
    pair_range: float = 8.0
    pair_margin: float = 3.0
    force_min: float = 0.1
    force_max: float = 6.0
    force_bins: int = 50
    force_scale: str = "log"
    betti_max: float = 5.0
    betti_step: float = 0.05
    level_max: float = 3.0
    level_step: float = 0.05
    tetrahedra: str = "filled"
    rough_includes_edge: bool = False
    force_margin: float = 0.0
    gravity: float = 0.0
    contact_force_max: float = 10.0
    contact_force_bins: int = 50
    rdf_bin: float = 0.02
    rdf_range: float = 4.0
    rdf_margin_ends: float = 10.0
    rdf_margin_sides: float = 10.0
    rdf_margin_cylinder: float = 3.0


def with_settings(settings):
    return replace(Options(), **settings)


def spelled(settings):
    """As they are written behind --set measure.KEY=."""
    word = lambda v: str(v).lower() if isinstance(v, bool) else f'"{v}"' if isinstance(v, str) else str(v)
    return {key: word(value) for key, value in settings.items()}
