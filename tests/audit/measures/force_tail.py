"""Fits to the distribution of contact forces."""
import numpy as np

import fit
from borders import exceeds
from measures.force_histograms import linear_bins, over_mean
from registry import Fit, audits

COLUMNS = [*(f"tail_k{kind}{error}" for kind in ("", "_loglinear", "_mle") for error in ("", "_error")), "mueth_a", "mueth_b",
           "mueth_beta", "gauss_centre", "gauss_width", "peak_position", "peak_prominence", "peak_prominence_error",
           "type_a", "bend", "bend_error"]


def tail(centre, count, norm):
    """k of A exp(-k f), with the error that counting leaves it: P varies by count/norm^2, bin by bin."""
    use = exceeds(centre, 1)
    x, y = centre[use], count[use] / norm
    p, _, inverse = fit.best_of(fit.exponential, x, y, [(1, 1), (3, 1.5), (10, 2.5)])
    through = fit.exponential(x, p)[1] @ inverse[:, 1]
    return p[1], np.sqrt((through**2 * count[use]).sum()) / norm


def tail_loglinear(centre, count, norm):
    """k of a line through ln P, which varies by 1/count."""
    use = exceeds(centre, 1) & (count > 0)
    p, inverse, _ = fit.polynomial(centre[use], np.log(count[use] / norm), 1)
    through = np.vander(centre[use], 2, increasing=True) @ inverse[:, 1]
    return -p[1], np.sqrt((through**2 / count[use]).sum())


def peak(centre, count, norm):
    """Highest bin beyond .3, its height above the lowest bin before it, the counting error of that."""
    beyond = np.flatnonzero(centre > 0.3 + 1e-9)
    top = beyond[np.argmax(count[beyond])]
    low = count[:top].min() if top else 0
    return centre[top], (count[top] - low) / norm, np.sqrt(count[top] + low) / norm


def bend(centre, count, norm):
    use = (centre > 0.2) & (centre < 2) & (count > 0)
    p, inverse, _ = fit.polynomial(centre[use], np.log(count[use] / norm), 2, count[use].astype(float))
    return p[2], np.sqrt(inverse[2, 2])


def nothing(f):
    """No fit to a handful of contacts."""
    above = f[exceeds(f, 1)]
    return {**{name: np.nan for name in COLUMNS}, "tail_contacts": len(above), "tail_excess": (above - 1).sum()}


@audits("force_tail")
def force_tail(packing, options):
    f = over_mean(packing, options)
    bins = linear_bins("force", f, options)
    centre, density, count, norm = bins["force"], bins["density"], bins["count"], bins["norm"][0]
    if len(f) < 3 or (count > 0).sum() < 4:
        return nothing(f)
    above = f[exceeds(f, 1)]
    excess = (above - 1).sum()
    k, k_error = tail(centre, count, norm)
    line, line_error = tail_loglinear(centre, count, norm)
    starts = [(a, b, beta) for a in (1, 3) for b in (-1, 0.5, 0.9) for beta in (0.5, 1.5, 3)]
    mueth_fit, cost, inverse = fit.best_of(fit.mueth, centre, density, starts)
    errors = np.sqrt(cost / (len(centre) - 3) * np.diag(inverse))
    gauss, gauss_cost, gauss_inverse = fit.best_of(fit.gaussian, centre, density,
                                                   [(1, c, w) for c in (-1, 0, 0.5, 1) for w in (0.5, 1, 2)])
    gauss_errors = np.sqrt(gauss_cost / (len(centre) - 3) * np.diag(gauss_inverse))
    position, prominence, counting = peak(centre, count, norm)
    curvature, curvature_error = bend(centre, count, norm)
    return {"tail_k": Fit(k, "tail_k_error"), "tail_k_error": Fit(k_error, k_error),
            "tail_k_loglinear": Fit(line, "tail_k_loglinear_error"), "tail_k_loglinear_error": Fit(line_error, line_error),
            "tail_k_mle": len(above) / excess, "tail_k_mle_error": Fit(np.sqrt(len(above)) / excess, len(above)**0.5 / excess),
            "tail_contacts": len(above), "tail_excess": excess,
            "mueth_a": Fit(mueth_fit[0], errors[0]), "mueth_b": Fit(mueth_fit[1], errors[1]),
            "mueth_beta": Fit(mueth_fit[2], errors[2]),
            "gauss_centre": Fit(gauss[1], gauss_errors[1], gauss[1] < 0),
            "gauss_width": Fit(abs(gauss[2]), gauss_errors[2], gauss[1] < 0),
            "peak_position": position, "peak_prominence": prominence, "peak_prominence_error": counting,
            "type_a": int(prominence > 2 * counting),
            "bend": Fit(curvature, "bend_error"), "bend_error": Fit(curvature_error, curvature_error)}
