"""The cotangent Laplacian (Pinkall and Polthier 1993) with masses of a third of the areas."""

import numpy
import scipy.sparse


def corner_cotangents(corners):
    """(m, 3, 3) positions of corners -> (m, 3) cotangents of the angles there."""
    cotangents = numpy.empty(corners.shape[:2])
    for i in range(3):
        a, b = (corners[:, (i + k) % 3] - corners[:, i] for k in (1, 2))
        cross = numpy.linalg.norm(numpy.cross(a, b), axis=1)
        cotangents[:, i] = (a * b).sum(1) / numpy.maximum(cross, 1e-300)
    return cotangents


def areas(corners):
    return numpy.linalg.norm(numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2


def applied(corners, values):
    """What each triangle adds to L f at its corners: (m, 3, 3) positions and (m, 3, k) values -> (m, 3, k)."""
    half = corner_cotangents(corners)[:, :, None] / 2
    sums = numpy.zeros_like(values)
    for i in range(3):
        a, b = (i + 1) % 3, (i + 2) % 3
        flow = half[:, i] * (values[:, a] - values[:, b])
        sums[:, a] += flow
        sums[:, b] -= flow
    return sums


def laplacian(positions, triangles):
    """L, positive semidefinite, and the diagonal of M."""
    corners = positions[triangles]
    half = corner_cotangents(corners) / 2
    count = len(positions)
    rows, columns, values = [], [], []
    for i in range(3):
        a, b = triangles[:, (i + 1) % 3], triangles[:, (i + 2) % 3]
        rows += [a, b, a, b]
        columns += [b, a, a, b]
        values += [-half[:, i], -half[:, i], half[:, i], half[:, i]]
    matrix = scipy.sparse.csr_matrix(
        (numpy.concatenate(values), (numpy.concatenate(rows), numpy.concatenate(columns))), shape=(count, count)
    )
    masses = numpy.bincount(triangles.ravel(), numpy.repeat(areas(corners) / 3, 3), count)
    return matrix, masses
