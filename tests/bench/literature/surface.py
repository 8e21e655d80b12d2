"""A triangle mesh that can be changed: collapses, splits and flips of edges, all of which keep a manifold one."""

import numpy

# The least cosine between the normals of a triangle before and after a collapse.
MIN_TURN = 0.2


def normal(a, b, c):
    """Twice the vector area of a triangle. (numpy.cross takes twenty times as long for single vectors.)"""
    (ux, uy, uz), (vx, vy, vz) = (b - a).tolist(), (c - a).tolist()
    return numpy.array((uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx))


class Surface:
    def __init__(self, positions, triangles):
        """positions: (n, 3) lengths; triangles: (m, 3) indices of a manifold surface, with or without borders."""
        self.positions = [numpy.array(p, float) for p in positions]
        self.triangles = {i: tuple(int(v) for v in t) for i, t in enumerate(triangles)}
        self.around = [set() for _ in positions]
        self.next = len(self.triangles)
        for i, triangle in self.triangles.items():
            for v in triangle:
                self.around[v].add(i)

    def neighbours(self, v):
        return {w for i in self.around[v] for w in self.triangles[i]} - {v}

    def shared(self, u, v):
        """The triangles at an edge."""
        return self.around[u] & self.around[v]

    def opposite(self, u, v):
        return [next(w for w in self.triangles[i] if w not in (u, v)) for i in self.shared(u, v)]

    def is_border(self, v):
        return any(len(self.shared(v, w)) == 1 for w in self.neighbours(v))

    def edges(self):
        return {(min(t[i], t[i - 1]), max(t[i], t[i - 1])) for t in self.triangles.values() for i in range(3)}

    def corners(self, i):
        return [self.positions[v] for v in self.triangles[i]]

    def can_collapse(self, u, v, position):
        """Whether the edge can become a vertex at `position` without a change of topology and without turned triangles."""
        shared = self.shared(u, v)
        if not shared or len(self.neighbours(u) & self.neighbours(v)) != len(shared):
            return False
        if self.is_border(u) and self.is_border(v) and len(shared) != 1:
            return False
        if len(self.triangles) <= 4 or any(len(self.around[w]) <= 2 for w in self.opposite(u, v) if not self.is_border(w)):
            return False
        return all(self.turns_little(i, u, v, position) for i in (self.around[u] | self.around[v]) - shared)

    def turns_little(self, i, u, v, position):
        before = normal(*self.corners(i))
        after = normal(*[position if w in (u, v) else self.positions[w] for w in self.triangles[i]])
        return before @ after > MIN_TURN * numpy.linalg.norm(before) * numpy.linalg.norm(after)

    def collapse(self, u, v, position):
        """Puts u at `position` and removes v."""
        for i in list(self.shared(u, v)):
            self.remove(i)
        for i in list(self.around[v]):
            corners = tuple(u if w == v else w for w in self.triangles[i])
            self.remove(i)
            self.add(corners)
        self.positions[u] = numpy.array(position, float)

    def split(self, u, v):
        """Cuts an edge in its middle; returns the new vertex."""
        middle = len(self.positions)
        self.positions.append((self.positions[u] + self.positions[v]) / 2)
        self.around.append(set())
        for i in list(self.shared(u, v)):
            corners = self.triangles[i]
            self.remove(i)
            for end in (u, v):
                self.add(tuple(middle if w == end else w for w in corners))
        return middle

    def can_flip(self, u, v):
        """Whether the two triangles at an edge can share their other diagonal."""
        opposite = self.opposite(u, v)
        if len(opposite) != 2 or opposite[1] in self.neighbours(opposite[0]):
            return False
        before = sum(normal(*self.corners(i)) for i in self.shared(u, v))
        return all(self.flipped_normal(end, opposite, i) @ before > 0 for i, end in self.kept_ends(u, v))

    def kept_ends(self, u, v):
        """For each triangle at an edge, the end that it keeps in a flip: the first in the order of its corners."""
        ends = []
        for i in self.shared(u, v):
            t = self.triangles[i]
            ends.append((i, t[(t.index(next(w for w in t if w not in (u, v))) + 1) % 3]))
        return ends

    def flipped(self, end, opposite, i):
        own = next(w for w in self.triangles[i] if w in opposite)
        other = opposite[1] if own == opposite[0] else opposite[0]
        return own, end, other

    def flipped_normal(self, end, opposite, i):
        return normal(*[self.positions[w] for w in self.flipped(end, opposite, i)])

    def flip(self, u, v):
        opposite = self.opposite(u, v)
        made = [(i, self.flipped(end, opposite, i)) for i, end in self.kept_ends(u, v)]
        for i, _ in made:
            self.remove(i)
        for _, corners in made:
            self.add(corners)

    def remove(self, i):
        for w in self.triangles.pop(i):
            self.around[w].discard(i)

    def add(self, corners):
        self.triangles[self.next] = corners
        for w in corners:
            self.around[w].add(self.next)
        self.next += 1

    def arrays(self):
        """Positions and triangles of the vertices that are used."""
        triangles = numpy.array([self.triangles[i] for i in sorted(self.triangles)], int)
        used, compact = numpy.unique(triangles, return_inverse=True)
        return numpy.array([self.positions[v] for v in used]), compact.reshape(-1, 3)


def is_manifold(triangles):
    """Whether every edge has at most two triangles, which run along it in opposite directions."""
    directed = [(t[i], t[(i + 1) % 3]) for t in triangles for i in range(3)]
    return len(set(map(tuple, directed))) == len(directed)
