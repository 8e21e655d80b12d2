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


def accumulated(rows, positions, values):
    """Sums of L f and masses that triangles, rows of corners, add to their vertices."""
    sums, masses = numpy.zeros_like(values), numpy.zeros(len(values))
    if len(rows):
        corners = positions[rows]
        numpy.add.at(sums, rows, applied(corners, values[rows]))
        numpy.add.at(masses, rows, areas(corners)[:, None].repeat(3, 1) / 3)
    return sums, masses


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

    def star(self, u, v):
        """What a collapse of an edge changes, without the collapse: u and v are the first rows."""
        triangles = self.around[u] | self.around[v]
        shared = self.shared(u, v)
        vertices = [u, v, *sorted({w for i in triangles for w in self.triangles[i]} - {u, v})]
        place = {w: i for i, w in enumerate(vertices)}
        rows = {i: [place[w] for w in self.triangles[i]] for i in triangles}
        positions = numpy.array([self.positions[w] for w in vertices])
        values, wanted = self.values[vertices], self.wanted[vertices]
        old = accumulated(numpy.array(list(rows.values())), positions, values)
        kept = numpy.array([row for i, row in rows.items() if i not in shared], int).reshape(-1, 3)
        kept[kept == 1] = 0
        before = self.terms(wanted, self.sums[vertices], self.masses[vertices]).sum()
        rest = self.sums[vertices] - old[0], self.masses[vertices] - old[1]
        return vertices, kept, positions, values, wanted, rest, before

    def state(self, star, share):
        """Values, wanted, sums and masses after a collapse at (1 - share) u + share v, of u and the ring."""
        _, kept, positions, values, wanted, rest, _ = star
        positions, values, wanted = positions.copy(), values.copy(), wanted.copy()
        for rows in (values, wanted, positions):
            rows[0] = (1 - share) * rows[0] + share * rows[1]
        new = accumulated(kept, positions, values)
        sums, masses = rest[0] + new[0], rest[1] + new[1]
        sums[0], masses[0] = new[0][0], new[1][0]
        return tuple(numpy.delete(rows, 1, 0) for rows in (values, wanted, sums, masses))

    def cost_at(self, star, share):
        _, wanted, sums, masses = self.state(star, share)
        if masses.min() <= 1e-9 * masses.max():
            return numpy.inf
        return self.terms(wanted, sums, masses).sum() - star[-1]

    def shares(self, u, v):
        """Where the new vertex may lie: anywhere, or at the only end on a border."""
        on_border = [self.is_border(w) for w in (u, v)]
        if on_border[0] != on_border[1]:
            return [0.0 if on_border[0] else 1.0]
        return [0.0, 0.5, 1.0]

    def best(self, u, v):
        """(cost, share); the cost is infinite where the edge cannot be collapsed."""
        shares = [share for share in self.shares(u, v) if self.can_collapse(u, v, self.point(u, v, share))]
        if not shares:
            return numpy.inf, 0.0
        star = self.star(u, v)
        found = [(self.cost_at(star, share), share) for share in shares]
        if len(found) == 3 and all(numpy.isfinite(cost) for cost, _ in found):
            (a, _), (b, _), (c, _) = found
            bend = a - 2 * b + c
            if bend > 0:
                share = float(numpy.clip(0.5 + (a - c) / (4 * bend), 0, 1))
                if self.can_collapse(u, v, self.point(u, v, share)):
                    found.append((self.cost_at(star, share), share))
        return min(found)

    def point(self, u, v, share):
        return (1 - share) * self.positions[u] + share * self.positions[v]

    def stamp(self, u, v):
        return int(self.version[list(self.neighbours(u) | self.neighbours(v))].sum())

    def take(self, u, v, share):
        star = self.star(u, v)
        vertices = [w for w in star[0] if w != v]
        values, wanted, sums, masses = self.state(star, share)
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
