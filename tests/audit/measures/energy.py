"""The energy ledger."""
import numpy as np

from registry import Sum, audits


@audits("energy")
def energy(packing, options):
    if not packing.energy:  # not given: nothing is known
        return {name: np.nan for name in ("kinetic", "elastic", "damped", "rubbed", "wall_work", "gravity_work", "ledger_sum")}
    moving = 0.5 * packing.mass @ (packing.velocity**2).sum(axis=1)
    turning = 0.5 * packing.inertia @ (packing.spin**2).sum(axis=1)
    stored = {name: packing.energy.get(name, 0.0)
              for name in ("elastic", "damped", "rubbed", "wall_work", "gravity_work")}
    kinetic = moving + turning
    total = kinetic + stored["elastic"] + stored["damped"] + stored["rubbed"] - stored["wall_work"] - stored["gravity_work"]
    largest = max([abs(v) for v in stored.values()] + [kinetic])
    return {**stored, "kinetic": Sum(kinetic, kinetic), "ledger_sum": Sum(total, largest)}
