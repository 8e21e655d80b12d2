"""Adaptive remeshing, after Dunyach, Vanderhaeghe, Barthe and Botsch 2013.

An edge is as long as a circle of the local curvature allows at a distance eps: L = sqrt(6 eps / kappa - 3 eps^2). Rounds of splits,
collapses, flips and tangential smoothing lead to such edges; eps is searched for the number of faces.
"""

import numpy
import scipy.spatial
from laplacian import laplacian
from surface import Surface, normal

ROUNDS = 6
SEARCH_STEPS = 7


def closest_on_triangles(point, a, b, c):
    """The closest points of many triangles (Ericson 2005, 5.1.5) as barycentric coordinates (n, 3), and their squared distances."""
    edges = [(a, b), (b, c), (c, a)]
    normals = numpy.cross(b - a, c - a)
    square = numpy.maximum((normals**2).sum(1), 1e-300)
    inside = numpy.stack(
        [(numpy.cross(end - start, point - start) * normals).sum(1) / square for start, end in (edges[1], edges[2], edges[0])], 1
    )
    best = inside.copy()
    distance = numpy.where((inside >= 0).all(1), 0, numpy.inf)
    flat = ((inside[:, :, None] * numpy.stack([a, b, c], 1)).sum(1) - point) ** 2
    distance = numpy.where(numpy.isfinite(distance), flat.sum(1), numpy.inf)
    for i, (start, end) in enumerate(edges):
        along = end - start
        share = numpy.clip(((point - start) * along).sum(1) / numpy.maximum((along**2).sum(1), 1e-300), 0, 1)
        own = ((start + share[:, None] * along - point) ** 2).sum(1)
        closer = own < distance
        weights = numpy.zeros_like(best)
        weights[:, i], weights[:, (i + 1) % 3] = 1 - share, share
        best[closer], distance[closer] = weights[closer], own[closer]
    return best, distance


class Original:
    """The surface that is approximated, with its curvature."""

    def __init__(self, positions, triangles):
        self.positions, self.triangles = positions, triangles
        self.corners = positions[triangles]
        self.tree = scipy.spatial.cKDTree(self.corners.mean(1))
        self.curvature = largest_curvature(positions, triangles)

    def project(self, point, candidates=24):
        """The closest point, among the triangles whose centres are nearest, and the curvature there."""
        _, near = self.tree.query(point, min(candidates, len(self.triangles)))
        weights, distance = closest_on_triangles(point, *(self.corners[near, i] for i in range(3)))
        i = int(distance.argmin())
        return weights[i] @ self.corners[near[i]], weights[i] @ self.curvature[self.triangles[near[i]]]


def largest_curvature(positions, triangles):
    """|H| + sqrt(H^2 - K) per vertex; on borders that of their neighbours."""
    matrix, masses = laplacian(positions, triangles)
    mean = numpy.linalg.norm(matrix @ positions, axis=1) / (2 * masses)
    angles = numpy.zeros(len(positions))
    for i in range(3):
        a, b = (positions[triangles[:, (i + k) % 3]] - positions[triangles[:, i]] for k in (1, 2))
        cosine = (a * b).sum(1) / (numpy.linalg.norm(a, axis=1) * numpy.linalg.norm(b, axis=1))
        numpy.add.at(angles, triangles[:, i], numpy.arccos(numpy.clip(cosine, -1, 1)))
    gauss = (2 * numpy.pi - angles) / masses
    largest = mean + numpy.sqrt(numpy.maximum(mean**2 - gauss, 0))
    surface = Surface(positions, triangles)
    on_border = numpy.array([surface.is_border(v) for v in range(len(positions))])
    for v in numpy.flatnonzero(on_border):
        inner = [w for w in surface.neighbours(v) if not on_border[w]]
        largest[v] = largest[inner].mean() if inner else 0
    return largest


class Remesher(Surface):
    def __init__(self, original, error, shortest, longest):
        super().__init__(original.positions, original.triangles)
        self.original, self.error, self.span = original, error, (shortest, longest)
        self.lengths = [self.length_for(kappa) for kappa in original.curvature]

    def length_for(self, kappa):
        square = 6 * self.error / max(kappa, 1e-300) - 3 * self.error**2
        return float(numpy.clip(numpy.sqrt(max(square, 0)), *self.span))

    def target(self, u, v):
        return min(self.lengths[u], self.lengths[v])

    def length(self, u, v):
        return numpy.linalg.norm(self.positions[u] - self.positions[v])

    def split_long(self):
        for u, v in sorted(self.edges()):
            if self.length(u, v) > 4 / 3 * self.target(u, v):
                self.split(u, v)
                self.lengths.append((self.lengths[u] + self.lengths[v]) / 2)

    def collapse_short(self):
        for u, v in sorted(self.edges()):
            if not self.shared(u, v) or self.length(u, v) >= 4 / 5 * self.target(u, v):
                continue
            on_border = [self.is_border(w) for w in (u, v)]
            share = 0.5 if on_border[0] == on_border[1] else (0.0 if on_border[0] else 1.0)
            position = (1 - share) * self.positions[u] + share * self.positions[v]
            around = (self.neighbours(u) | self.neighbours(v)) - {u, v}
            limits = [(w, 4 / 3 * min(self.lengths[w], self.target(u, v))) for w in around]
            if any(numpy.linalg.norm(self.positions[w] - position) > most for w, most in limits):
                continue
            if self.can_collapse(u, v, position):
                self.collapse(u, v, position)

    def flip_for_valence(self):
        wanted = {}

        def excess(v, change):
            if v not in wanted:
                wanted[v] = 4 if self.is_border(v) else 6
            return (len(self.neighbours(v)) + change - wanted[v]) ** 2

        for u, v in sorted(self.edges()):
            if len(self.shared(u, v)) != 2:
                continue
            ends = [(u, -1), (v, -1), *((w, 1) for w in self.opposite(u, v))]
            gain = sum(excess(w, 0) - excess(w, change) for w, change in ends)
            if gain > 0 and self.can_flip(u, v):
                self.flip(u, v)

    def smooth(self):
        moved = {}
        for v, around in enumerate(self.around):
            if not around or self.is_border(v):
                continue
            corners = [numpy.array(self.corners(i)) for i in around]
            normals = [normal(*own) for own in corners]
            lengths = [numpy.mean([self.lengths[w] for w in self.triangles[i]]) for i in around]
            weights = [numpy.linalg.norm(n) * size for n, size in zip(normals, lengths)]
            centre = sum(w * own.mean(0) for w, own in zip(weights, corners)) / sum(weights)
            direction = sum(normals)
            square = direction @ direction
            step = centre - self.positions[v]
            moved[v] = self.positions[v] + (step - direction * (direction @ step) / square if square > 0 else 0)
        for v, position in moved.items():
            self.positions[v] = position

    def project(self):
        for v, around in enumerate(self.around):
            if not around:
                continue
            point, kappa = self.original.project(self.positions[v])
            if not self.is_border(v):
                self.positions[v] = point
            self.lengths[v] = self.length_for(kappa)

    def run(self):
        for _ in range(ROUNDS):
            self.split_long()
            self.collapse_short()
            self.flip_for_valence()
            self.smooth()
            self.project()
        return self


def simplify(positions, triangles, faces):
    """Remeshes to about `faces` triangles (at most); returns positions and triangles."""
    positions, triangles = numpy.asarray(positions, float), numpy.asarray(triangles, int)
    original = Original(positions, triangles)
    diagonal = numpy.linalg.norm(positions.max(0) - positions.min(0))
    corners = positions[triangles]
    edge = numpy.linalg.norm(corners - numpy.roll(corners, 1, 1), axis=2).mean()
    longest = 4 * edge * numpy.sqrt(len(triangles) / faces)
    low, high, best = 1e-6 * diagonal, 0.1 * diagonal, None
    for _ in range(SEARCH_STEPS):
        error = numpy.sqrt(low * high)
        found = Remesher(original, error, edge / 2, longest).run().arrays()
        if len(found[1]) > faces:
            low = error
        else:
            high = error
            if best is None or len(found[1]) > len(best[1]):
                best = found
    return best if best is not None else found
