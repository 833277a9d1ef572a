"""Least squares by Gauss and Newton with a damped step, numbers for derivatives nowhere: the models give theirs."""
import numpy as np


def least_squares(model, x, y, start):
    """Parameters at the minimum of sum (y - model)^2 nearest to the start, that sum, and (J'J)^-1 there; model(x, p) gives
    value and derivatives."""
    p, damping = np.array(start, dtype=float), 1e-3
    value, slope = model(x, p)
    cost = ((y - value) ** 2).sum()
    for _ in range(500):
        normal, gradient = slope.T @ slope, slope.T @ (y - value)
        step = np.linalg.lstsq(normal + damping * np.diag(np.diag(normal)), gradient, rcond=None)[0]
        with np.errstate(over="ignore", invalid="ignore"):
            new_value, new_slope = model(x, p + step)
            new_cost = ((y - new_value) ** 2).sum()
        if np.isfinite(new_cost) and new_cost <= cost:
            done = np.all(np.abs(step) <= 1e-14 * (np.abs(p) + 1e-300))
            p, value, slope, cost, damping = p + step, new_value, new_slope, new_cost, damping / 5
            if done:
                break
        else:
            damping *= 4
            if damping > 1e14:
                break
    return p, cost, np.linalg.pinv(slope.T @ slope)


def best_of(model, x, y, starts):
    """The lowest minimum found from many starts."""
    found = [least_squares(model, x, y, start) for start in starts]
    return min(found, key=lambda result: result[1])


def exponential(x, p):
    e = np.exp(-p[1] * x)
    return p[0] * e, np.column_stack([e, -p[0] * x * e])


def mueth(x, p):
    a, b, beta = p
    e, g = np.exp(-beta * x), np.exp(-x**2)
    return a * (1 - b * g) * e, np.column_stack([(1 - b * g) * e, -a * g * e, -a * (1 - b * g) * x * e])


def gaussian(x, p):
    h, c, w = p
    z = (x - c) / w
    e = np.exp(-z**2 / 2)
    return h * e, np.column_stack([e, h * e * z / w, h * e * z**2 / w])


def polynomial(x, y, degree, weights=None):
    """Coefficients from the constant on, their covariance (J'WJ)^-1 and the residual sum of squares."""
    weights = np.ones(len(x)) if weights is None else weights
    powers = np.vander(x, degree + 1, increasing=True)
    root = np.sqrt(weights)[:, None]
    p = np.linalg.lstsq(powers * root, y * root[:, 0], rcond=None)[0]
    return p, np.linalg.pinv(powers.T @ (weights[:, None] * powers)), (weights * (y - powers @ p) ** 2).sum()
