"""Two factors (stretch, bend) with which a coarse body has the original's frequencies: the reference of `limber tune`.

Gauss-Newton on ln(lambda_i / lambda_i,original) with the exact derivatives of models.Body.shares.
"""

import numpy as np

from meshes import closest_points

FREE_MODES, PINNED_MODES = 20, 8
ROUNDS = 8
LONGEST_CHANGE = 0.7
SMALLEST, LARGEST = 0.1, 10.0


def carried_masses(original, masses, coarse):
    """Masses of the original's vertices, given to the corners of the coarse triangle nearest to each."""
    triangle, weights = closest_points(coarse, original.positions)
    corners = coarse.triangles[triangle]
    return np.bincount(corners.ravel(), (masses[:, None] * weights).ravel(), len(coarse.positions))


def carried_pins(original, pins, coarse):
    """Vertices of the coarse mesh whose nearest point on the original is at least half pinned."""
    if len(pins) == 0:
        return np.zeros(0, int)
    pinned = np.zeros(len(original.positions))
    pinned[pins] = 1
    triangle, weights = closest_points(original, coarse.positions)
    share = (pinned[original.triangles[triangle]] * weights).sum(1)
    return np.flatnonzero(share >= 0.5)


def targets(body, pins):
    free = body.modes(FREE_MODES)[0]
    clamped = body.modes(PINNED_MODES, pins)[0] if len(pins) else np.zeros(0)
    return free, clamped


def tune(goal, body, pins, keep_stretch):
    """(stretch factor, bend factor); `goal` is targets() of the original. keep_stretch: the stretch factor stays 1."""
    x = np.zeros(2)
    unknown = [1] if keep_stretch else [0, 1]
    for _ in range(ROUNDS):
        factors = np.exp(x)
        rows, residual = [], []
        for eigenvalues, clamp in ((goal[0], ()), (goal[1], pins)):
            if len(eigenvalues) == 0:
                continue
            found, phi = body.modes(len(eigenvalues), clamp, factors)
            rows.append(body.shares(phi, factors)[:, unknown])
            residual.append(np.log(np.maximum(found, 1e-12) / eigenvalues))
        jacobian, r = np.concatenate(rows), np.concatenate(residual)
        change = np.linalg.lstsq(np.vstack([jacobian, 1e-3 * np.eye(len(unknown))]),
                                 np.r_[-r, np.zeros(len(unknown))], rcond=None)[0]
        longest = np.abs(change).max()
        if longest > LONGEST_CHANGE:
            change *= LONGEST_CHANGE / longest
        x[unknown] = np.clip(x[unknown] + change, np.log(SMALLEST), np.log(LARGEST))
        if longest < 1e-4:
            break
    return tuple(np.exp(x))


def frequency_error(eigenvalues, goal):
    """Mean relative error of frequencies, %."""
    return float(100 * np.mean(np.abs(np.sqrt(np.maximum(eigenvalues, 0) / goal) - 1)))
