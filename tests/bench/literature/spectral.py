"""Spectral Mesh Simplification, after Lescoat, Liu, Thiery, Jacobson, Boubekeur and Ovsjanikov 2020.

Edges are collapsed where the coarse Laplacian applied to the low eigenvectors differs least from the fine one. With F the first k
eigenvectors, P the restriction to the coarse vertices (a new vertex takes the mean of the two ends, weighted by its position) the energy is
the sum over vertices of m_v |(P M^-1 L F)_v - (M~^-1 L~ P F)_v|^2. A collapse changes the terms of its one-ring alone, and its cost is
their growth, at the least of a parabola through the costs at both ends and the middle. Deviation: a cost is computed again as its edge
comes to the top of the queue, not at once.
"""

import heapq

import numpy
import scipy.sparse
import scipy.sparse.linalg
from laplacian import applied, areas, laplacian
from surface import Surface


def eigenvectors(positions, triangles, count):
    """The first `count` eigenvectors of L f = lambda M f as columns, and their eigenvalues."""
    matrix, masses = laplacian(positions, triangles)
    scale = masses.sum()
    found = scipy.sparse.linalg.eigsh(matrix, count, scipy.sparse.diags(masses), sigma=-1 / scale, v0=numpy.ones(len(positions)))
    return found[1], found[0]


class SpectralMesh(Surface):
    def __init__(self, positions, triangles, count):
        super().__init__(positions, triangles)
        self.values, frequencies = eigenvectors(positions, triangles, count)
        self.wanted = self.values * frequencies  # P M^-1 L F
        corners = positions[triangles]
        self.sums = numpy.zeros_like(self.values)  # L~ P F
        numpy.add.at(self.sums, triangles, applied(corners, self.values[triangles]))
        self.masses = numpy.bincount(triangles.ravel(), numpy.repeat(areas(corners) / 3, 3), len(positions))
        self.version = numpy.zeros(len(positions), int)

    def terms(self, wanted, sums, masses):
        with numpy.errstate(over="ignore"):  # of triangles without an area
            return masses * ((wanted - sums / masses[:, None]) ** 2).sum(1)

    def energy(self):
        used = [v for v, around in enumerate(self.around) if around]
        return self.terms(self.wanted[used], self.sums[used], self.masses[used]).sum()

    def accumulated(self, triangles, place, positions, values):
        """Sums and masses that triangles add, at the rows that `place` gives to their vertices."""
        rows = numpy.array([[place[v] for v in t] for t in triangles], int).reshape(-1, 3)
        sums, masses = numpy.zeros_like(values), numpy.zeros(len(values))
        corners = positions[rows]
        numpy.add.at(sums, rows, applied(corners, values[rows]))
        numpy.add.at(masses, rows, areas(corners)[:, None].repeat(3, 1) / 3)
        return sums, masses

    def collapsed(self, u, v, share):
        """The state of the one-ring after a collapse at (1 - share) u + share v: vertices (u first), values, wanted, sums, masses."""
        star = self.around[u] | self.around[v]
        vertices = [u, v, *sorted((self.neighbours(u) | self.neighbours(v)) - {u, v})]
        place = {w: i for i, w in enumerate(vertices)}
        positions = numpy.array([self.positions[w] for w in vertices])
        values, wanted = self.values[vertices], self.wanted[vertices].copy()
        old = self.accumulated([self.triangles[i] for i in star], place, positions, values)
        sums, masses = self.sums[vertices] - old[0], self.masses[vertices] - old[1]
        values, positions = values.copy(), positions.copy()
        for rows in (values, wanted, positions):
            rows[0] = (1 - share) * rows[0] + share * rows[1]
        kept = [tuple(u if w == v else w for w in self.triangles[i]) for i in star - self.shared(u, v)]
        new = self.accumulated(kept, place, positions, values)
        keep = [i for i in range(len(vertices)) if i != 1]
        state = [rows[keep] for rows in (values, wanted, sums + new[0], masses + new[1])]
        state[2][0], state[3][0] = new[0][0], new[1][0]
        return vertices, [vertices[i] for i in keep], state

    def cost_at(self, u, v, share):
        before, _, (_, wanted, sums, masses) = self.collapsed(u, v, share)
        if masses.min() <= 1e-9 * masses.max():
            return numpy.inf
        old = self.terms(self.wanted[before], self.sums[before], self.masses[before]).sum()
        return self.terms(wanted, sums, masses).sum() - old

    def shares(self, u, v):
        """Where the new vertex may lie: anywhere, or at the only end on a border."""
        on_border = [self.is_border(w) for w in (u, v)]
        if on_border[0] != on_border[1]:
            return [0.0 if on_border[0] else 1.0]
        return [0.0, 0.5, 1.0]

    def best(self, u, v):
        """(cost, share); the cost is infinite where the edge cannot be collapsed."""
        found = [(self.cost_at(u, v, share), share) for share in self.shares(u, v)]
        if len(found) == 3 and all(numpy.isfinite(cost) for cost, _ in found):
            (a, _), (b, _), (c, _) = found
            bend = a - 2 * b + c
            if bend > 0:
                share = float(numpy.clip(0.5 + (a - c) / (4 * bend), 0, 1))
                found.append((self.cost_at(u, v, share), share))
        allowed = [(cost, share) for cost, share in found if self.can_collapse(u, v, self.point(u, v, share))]
        return min(allowed, default=(numpy.inf, 0.0))

    def point(self, u, v, share):
        return (1 - share) * self.positions[u] + share * self.positions[v]

    def stamp(self, u, v):
        return int(self.version[list(self.neighbours(u) | self.neighbours(v))].sum())

    def take(self, u, v, share):
        _, vertices, (values, wanted, sums, masses) = self.collapsed(u, v, share)
        self.collapse(u, v, self.point(u, v, share))
        self.values[vertices], self.wanted[vertices] = values, wanted
        self.sums[vertices], self.masses[vertices] = sums, masses
        self.version[vertices] += 1

    def simplify(self, faces):
        """Collapses edges until at most `faces` triangles are left."""
        queue = []

        def push(u, v):
            cost, share = self.best(u, v)
            if numpy.isfinite(cost):
                heapq.heappush(queue, (cost, u, v, share, self.stamp(u, v)))

        for u, v in sorted(self.edges()):
            push(u, v)
        while queue and len(self.triangles) > faces:
            _, u, v, share, stamp = heapq.heappop(queue)
            if not self.shared(u, v):
                continue
            if stamp != self.stamp(u, v):
                push(u, v)
                continue
            self.take(u, v, share)
            for w in sorted(self.neighbours(u)):
                push(min(u, w), max(u, w))


def simplify(positions, triangles, faces, count=60):
    """Positions and triangles of at most `faces` triangles, where collapses allow."""
    mesh = SpectralMesh(numpy.asarray(positions, float), numpy.asarray(triangles, int), min(count, len(positions) - 2))
    mesh.simplify(faces)
    return mesh.arrays()
