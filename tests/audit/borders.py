"""Which side of a border a number is on: within 1e-12 of it, times its size, a number is on the border itself."""
import numpy as np

WIDTH = 1e-12


def reaches(number, border, size=None):
    """At or above the border; of a difference the size is that of what was subtracted."""
    size = np.maximum(np.abs(number), np.abs(border)) if size is None else size
    return np.asarray(number) >= border - WIDTH * size


def exceeds(number, border, size=None):
    """Above the border."""
    size = np.maximum(np.abs(number), np.abs(border)) if size is None else size
    return np.asarray(number) > border + WIDTH * size


def counted(values, edges):
    """How many values lie in each bin of a histogram: lower edge in, upper edge out, the last bin has both."""
    at = np.searchsorted(edges - WIDTH * np.abs(edges), values, side="right") - 1
    last = len(edges) - 1
    at = np.where((at == last) & ~exceeds(values, edges[-1]), last - 1, at)
    return np.bincount(at[(at >= 0) & (at < last)], minlength=last)


def multiples(highest, step):
    """0, step, 2 step ... up to and with the highest."""
    return step * np.arange(int(np.floor(highest / step * (1 + WIDTH) + WIDTH)) + 1)
