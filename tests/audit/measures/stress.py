"""Stress of the packing and of each grain, balance of forces."""
import numpy as np

from contacts import by_grain, touching
from registry import Sum, audits


def per_grain(packing):
    """sum over the contacts of a grain of f_a l_b."""
    grain, force, lever = by_grain(packing)
    sums = np.zeros((packing.count, packing.dimension, packing.dimension))
    np.add.at(sums, grain, force[:, :, None] * lever[:, None, :])
    return sums


@audits("stress")
def stress(packing, options):
    sigma = per_grain(packing).sum(axis=0) / packing.space
    sigma = (sigma + sigma.T) / 2
    full = np.zeros((3, 3))
    full[:packing.dimension, :packing.dimension] = sigma
    pressure = -np.trace(sigma) / packing.dimension
    columns = {f"stress_{'xyz'[a]}{'xyz'[b]}": Sum(full[a, b], pressure)
               for a, b in ((0, 0), (1, 1), (0, 1), (2, 2), (0, 2), (1, 2))}
    return {**columns, "pressure": pressure}


@audits("kinetic_stress")
def kinetic_stress(packing, options):
    if np.isnan(packing.velocity).any():  # not given: nothing is known
        names = [f"kinetic_stress_{pair}" for pair in ("xx", "yy", "xy", "zz", "xz", "yz")]
        return {name: np.nan for name in names + ["kinetic_pressure"]}
    drift = packing.mass @ packing.velocity / packing.mass.sum()
    v = packing.velocity - drift
    full = np.zeros((3, 3))
    full[:packing.dimension, :packing.dimension] = -(packing.mass[:, None] * v).T @ v / packing.space
    pressure = -np.trace(full) / packing.dimension
    columns = {f"kinetic_stress_{'xyz'[a]}{'xyz'[b]}": Sum(full[a, b], pressure)
               for a, b in ((0, 0), (1, 1), (0, 1), (2, 2), (0, 2), (1, 2))}
    return {**columns, "kinetic_pressure": Sum(pressure, pressure)}


@audits("particle_stress")
def particle_stress(packing, options):
    sigma = per_grain(packing) / packing.volume[:, None, None]
    i1 = np.trace(sigma, axis1=1, axis2=2)
    skew, whole = (sigma - sigma.transpose(0, 2, 1)) / 2, np.linalg.norm(sigma, axis=(1, 2))
    s = np.zeros((packing.count, 3))
    s[:, :packing.dimension] = np.sort(np.linalg.eigvalsh((sigma + sigma.transpose(0, 2, 1)) / 2), axis=1)
    scale = np.abs(i1).max() if len(i1) else 0.0
    twist = np.linalg.norm(skew, axis=(1, 2))
    asymmetry = np.divide(twist, whole, out=np.zeros_like(twist), where=whole > 0)
    mean = i1.mean()
    return {"grain": packing.ids, "i1": Sum(i1, scale), "i": Sum(i1 / mean if mean else 0 * i1, 1), "s1": Sum(s[:, 0], scale),
            "s2": Sum(s[:, 1], scale), "s3": Sum(s[:, 2], scale), "asymmetry": Sum(asymmetry, 1)}


@audits("stress_distribution")
def stress_distribution(packing, options):
    from measures.force_histograms import from_walls, linear_bins
    i1 = np.trace(per_grain(packing) / packing.volume[:, None, None], axis1=1, axis2=2)
    i1 = i1[from_walls(packing, options, packing.x)]
    return linear_bins("stress", i1 / i1.mean() if i1.mean() else 0 * i1, options)


@audits("balance")
def balance(packing, options):
    grain, force, _ = by_grain(packing)
    net = np.zeros((packing.count, packing.dimension))
    np.add.at(net, grain, force)
    net[:, 1] -= options.gravity * packing.mass
    size = np.linalg.norm(packing.force[touching(packing)], axis=1)
    unbalanced = np.linalg.norm(net, axis=1).mean() / size.mean() if size.sum() > 0 else np.nan
    return {"unbalanced_force": Sum(unbalanced, 1)}
