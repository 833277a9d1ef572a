"""Which function audits which measure."""
from dataclasses import dataclass

AUDITS = {}


def audits(measure):
    """Marks a function (packing, options) -> {column: value} as the second writing of a measure."""
    def keep(function):
        AUDITS[measure] = function
        return function
    return keep


@dataclass
class Sum:
    """A sum whose terms may cancel: equal to 1e-12 of this scale."""
    value: object
    scale: float


@dataclass
class Fit:
    """A fitted value: equal to 1e-3 of its error, which stands in the program's column of that name or is a number."""
    value: float
    error: object
    may_miss: bool = False   # the documentation lets it be missing


@dataclass
class Drawn:
    """An error found with random numbers: equal to this factor."""
    value: float
    factor: float
