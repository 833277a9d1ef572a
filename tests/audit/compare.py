"""One column of the program beside one of ours."""
import math

import numpy as np

from registry import Drawn, Fit, Sum

RELATIVE = 1e-12


def numbers(texts):
    return np.array([float(t) for t in texts])


def differing(theirs, ours, tolerance):
    """Rows in which two columns differ by more than the tolerance; two missing values are equal."""
    both_missing = np.isnan(theirs) & np.isnan(ours)
    with np.errstate(invalid="ignore"):
        near = np.abs(theirs - ours) <= tolerance
    return np.flatnonzero(~(near | both_missing))


def compare(column, table, ours):
    """List of (row, program's value, ours, what was allowed)."""
    theirs = numbers(table[column])
    allowed = None
    if isinstance(ours, Fit):
        error = ours.error if not isinstance(ours.error, str) else numbers(table[ours.error])[0]
        tolerance = 1e-3 * error if math.isfinite(error) else RELATIVE * abs(ours.value)
        if ours.may_miss and math.isnan(numbers(table[column])[0]):
            return []
        allowed, ours = f"{tolerance:.2g}, of a fit", ours.value
    elif isinstance(ours, Drawn):
        tolerance = abs(ours.value) * (ours.factor - 1)
        allowed, ours = f"a factor {ours.factor:g}, drawn at random", ours.value
    elif isinstance(ours, Sum):
        tolerance = RELATIVE * ours.scale
        allowed, ours = f"{tolerance:.2g}, of a sum", ours.value
    else:
        exact = np.asarray(ours).dtype.kind in "biu"
        tolerance = 0.0 if exact else None
        allowed = "none: counts" if exact else "1e-12 relative"
    ours = np.atleast_1d(np.asarray(ours, dtype=float))
    if tolerance is None:
        tolerance = RELATIVE * np.abs(ours)
    if len(ours) != len(theirs):
        return [("rows", len(theirs), len(ours), "none: number of rows")]
    return [(int(k), theirs[k], ours[k], allowed) for k in differing(theirs, ours, tolerance)]
