"""K, M and modes of a soft body as engines discretise it, at rest: an independent check of wasm/elastic/solvers.

Formulas: see docs/engine-models.md. Everything is in SI units; a mesh is in metres.
"""

import numpy as np
from scipy.sparse import coo_matrix, csc_matrix, diags, identity
from scipy.sparse.linalg import splu

MAX_ITERATIONS = 500


def _rows(weights, vertices, gradients, count):
    """The sparse matrix with one row per constraint: weights[c] * gradients[c, k] at vertices[c, k]."""
    rows = np.repeat(np.arange(len(vertices)), vertices.shape[1] * 3)
    columns = (3 * vertices[:, :, None] + np.arange(3)).ravel()
    values = (weights[:, None, None] * gradients).ravel()
    return coo_matrix((values, (rows, columns)), shape=(len(vertices), 3 * count)).tocsc()


def membrane(mesh, shear, lame):
    """CST, energy area (shear |eps|^2 + lame / 2 tr(eps)^2), constants in N/m. K (3n x 3n)."""
    positions, triangles = mesh.positions, mesh.triangles
    p = positions[triangles]
    e1, e2 = p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]
    x = e1 / np.linalg.norm(e1, axis=1)[:, None]
    normal = np.cross(e1, e2)
    double_area = np.linalg.norm(normal, axis=1)
    y = np.cross(normal / double_area[:, None], x)
    local = np.stack([np.einsum("tkc,tc->tk", p - p[:, :1], axis) for axis in (x, y)], -1)
    # Gradients of the hat functions.
    g = np.empty((len(triangles), 3, 2))
    for k in range(3):
        d = local[:, (k + 2) % 3] - local[:, (k + 1) % 3]
        g[:, k] = np.column_stack([-d[:, 1], d[:, 0]]) / double_area[:, None]
    xx = g[:, :, :1] * x[:, None]
    yy = g[:, :, 1:] * y[:, None]
    xy = g[:, :, 1:] * x[:, None] + g[:, :, :1] * y[:, None]
    area = double_area / 2
    count = len(positions)
    # shear (xx^2 + yy^2 + xy^2 / 2) + lame / 2 (xx + yy)^2
    parts = [
        (np.sqrt(2 * shear * area), xx),
        (np.sqrt(2 * shear * area), yy),
        (np.sqrt(shear * area), xy),
        (np.sqrt(max(lame, 0) * area), xx + yy),
    ]
    total = csc_matrix((3 * count, 3 * count))
    for weight, gradient in parts:
        b = _rows(weight, triangles, gradient, count)
        total = total + b.T @ b
    return total


def springs(mesh, pairs, constants):
    """1/2 k (|x_i - x_j| - L)^2 for pairs (c x 2) of vertices; K (3n x 3n)."""
    d = mesh.positions[pairs[:, 0]] - mesh.positions[pairs[:, 1]]
    d = d / np.linalg.norm(d, axis=1)[:, None]
    constants = np.broadcast_to(np.asarray(constants, float), len(pairs))
    b = _rows(np.sqrt(constants), pairs, np.stack([d, -d], 1), len(mesh.positions))
    return b.T @ b


def angle_gradients(positions, hinges):
    """Gradients of the dihedral angles by the four vertices (h x 4 x 3) and the angles (h).

    hinges: the ends of the edge, then the corners opposite (Bridson et al. 2003, Simulation of Clothing; Grinspun et al. 2003).
    """
    i, j, k, l = (positions[hinges[:, c]] for c in range(4))
    e = j - i
    length = np.linalg.norm(e, axis=1)[:, None]
    n1, n2 = np.cross(e, k - i), np.cross(l - i, e)
    s1, s2 = (n1**2).sum(1)[:, None], (n2**2).sum(1)[:, None]
    gk, gl = -length * n1 / s1, -length * n2 / s2
    share = lambda p: np.einsum("hc,hc->h", p - i, e)[:, None] / length**2
    a, b = share(k), share(l)
    gj, gi = -a * gk - b * gl, -(1 - a) * gk - (1 - b) * gl
    u1, u2, axis = n1 / np.sqrt(s1), n2 / np.sqrt(s2), e / length
    angle = np.arctan2(np.einsum("hc,hc->h", np.cross(u1, u2), axis), np.einsum("hc,hc->h", u1, u2))
    return np.stack([gi, gj, gk, gl], 1), angle


def hinges_stiffness(mesh, hinges, constants):
    """1/2 k (theta - theta0)^2 for hinges (h x 4); K (3n x 3n)."""
    gradient, _ = angle_gradients(mesh.positions, hinges)
    constants = np.broadcast_to(np.asarray(constants, float), len(hinges))
    b = _rows(np.sqrt(constants), hinges, gradient, len(mesh.positions))
    return b.T @ b


def hinge_lengths(mesh, hinges):
    return np.linalg.norm(mesh.positions[hinges[:, 0]] - mesh.positions[hinges[:, 1]], axis=1)


def hinge_areas(mesh, hinges):
    """A1 + A2 of the two triangles of every hinge."""
    i, j, k, l = (mesh.positions[hinges[:, c]] for c in range(4))
    area = lambda p: np.linalg.norm(np.cross(j - i, p - i), axis=1) / 2
    return area(k) + area(l)


class Body:
    """A soft body at rest: stretch and bend stiffness apart (3n x 3n each), masses (n)."""

    def __init__(self, stretch, bend, masses, zero_modes=6):
        self.stretch, self.bend, self.masses = stretch, bend, np.asarray(masses, float)
        self.zero_modes = zero_modes

    @property
    def stiffness(self):
        return self.stretch + self.bend

    def modes(self, count, pins=()):
        """(lambda, phi): the lowest `count` elastic modes, ascending; phi (3n x count) is mass-normalised."""
        n = len(self.masses)
        free = np.ones(n, bool)
        free[np.asarray(pins, int)] = False
        unknown = np.flatnonzero(np.repeat(free, 3))
        stiffness = self.stiffness.tocsc()[unknown][:, unknown]
        mass = np.repeat(self.masses, 3)[unknown]
        skip = 0 if len(pins) else self.zero_modes
        values, vectors = lowest_modes(stiffness, mass, count + skip)
        phi = np.zeros((3 * n, count))
        phi[unknown] = vectors[:, skip:]
        return values[skip:], phi


def lowest_modes(stiffness, mass, count):
    """The lowest `count` eigenpairs of K phi = lambda M phi, ascending.

    By subspace iteration (Bathe and Wilson 1973), because it finds eigenvalues that are repeated: the rigid motions are
    one that is there six times, and the Lanczos iteration of a single vector can miss some of them.
    """
    root = np.sqrt(mass)
    scaled = (diags(1 / root) @ stiffness @ diags(1 / root)).tocsc()
    shift = 1e-10 * scaled.diagonal().max()
    factor = splu(scaled + shift * identity(len(mass), format="csc"), permc_spec="MMD_AT_PLUS_A",
                  options={"SymmetricMode": True}, diag_pivot_thresh=0.0)
    block = np.random.default_rng(0).standard_normal((len(mass), min(2 * count + 8, len(mass))))
    before = np.full(count, np.inf)
    rounding = 8 * np.finfo(float).eps * scaled.diagonal().max()  # of the products below
    for _ in range(MAX_ITERATIONS):
        block, _ = np.linalg.qr(factor.solve(block))
        values, rotation = np.linalg.eigh(block.T @ (scaled @ block))
        block = block @ rotation
        values = values[:count]
        if np.abs(values - before).max() <= max(1e-9 * values[-1], rounding):
            return values, block[:, :count] / root[:, None]
        before = values
    raise RuntimeError(f"the modes have not converged in {MAX_ITERATIONS} iterations")


def frequency_error(eigenvalues, goal):
    """Mean relative error of frequencies, %."""
    return float(100 * np.mean(np.abs(np.sqrt(np.maximum(eigenvalues, 0) / goal) - 1)))
