"""Triangle meshes of the engine benches: reading, welding, generating, and closest points."""

import numpy as np
from scipy.sparse.csgraph import connected_components
from scipy.sparse import coo_matrix
from scipy.spatial import cKDTree


class Mesh:
    """Welded vertices `positions` (n x 3, file units) and `triangles` (m x 3)."""

    def __init__(self, positions, triangles):
        self.positions = np.asarray(positions, float)
        self.triangles = np.asarray(triangles, np.int64)

    @property
    def diagonal(self):
        return float(np.linalg.norm(np.ptp(self.positions, axis=0)))

    @property
    def areas(self):
        a, b, c = (self.positions[self.triangles[:, k]] for k in range(3))
        return 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)

    @property
    def vertex_areas(self):
        """A third of the areas of the triangles around every vertex."""
        return np.bincount(self.triangles.ravel(), np.repeat(self.areas / 3, 3), len(self.positions))

    def edges(self):
        """(edges, hinges): all edges (e x 2), and the inner ones with their opposite corners (h x 4)."""
        corners = self.triangles
        half = np.concatenate([corners[:, [0, 1, 2]], corners[:, [1, 2, 0]], corners[:, [2, 0, 1]]])
        low, high = half[:, :2].min(axis=1), half[:, :2].max(axis=1)
        order = np.lexsort((high, low))
        low, high, opposite = low[order], high[order], half[order, 2]
        starts = np.flatnonzero(np.r_[True, (low[1:] != low[:-1]) | (high[1:] != high[:-1])])
        counts = np.diff(np.r_[starts, len(low)])
        inner = starts[counts == 2]
        hinges = np.column_stack([low[inner], high[inner], opposite[inner], opposite[inner + 1]])
        return np.column_stack([low[starts], high[starts]]), hinges

    @property
    def is_open(self):
        edges, hinges = self.edges()
        return len(hinges) < len(edges)


def weld(positions, triangles):
    """Merges vertices whose float32 positions are equal; drops degenerate triangles and unused vertices."""
    _, inverse = np.unique(np.asarray(positions, np.float32), axis=0, return_inverse=True)
    triangles = inverse.ravel()[np.asarray(triangles)]
    a, b, c = triangles.T
    triangles = triangles[(a != b) & (b != c) & (c != a)]
    first = np.full(inverse.max() + 1, -1)
    first[inverse.ravel()[::-1]] = np.arange(len(positions))[::-1]
    used, compact = np.unique(triangles, return_inverse=True)
    return Mesh(np.asarray(positions, float)[first[used]], compact.reshape(-1, 3))


def read_obj(path):
    """Positions and triangles of an OBJ file; polygons become fans."""
    positions, triangles = [], []
    for line in open(path, encoding="utf-8", errors="replace"):
        words = line.split()
        if not words:
            continue
        if words[0] == "v":
            positions.append([float(x) for x in words[1:4]])
        elif words[0] == "f":
            face = [int(word.split("/")[0]) for word in words[1:]]
            face = [index - 1 if index > 0 else len(positions) + index for index in face]
            triangles += [(face[0], face[k - 1], face[k]) for k in range(2, len(face))]
    return weld(positions, triangles)


def write_obj(path, mesh):
    with open(path, "w", encoding="utf-8") as file:
        file.writelines(f"v {x:.9g} {y:.9g} {z:.9g}\n" for x, y, z in mesh.positions)
        file.writelines(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in mesh.triangles)


def largest_component(mesh):
    a, b, c = mesh.triangles.T
    ones = np.ones(2 * len(a))
    graph = coo_matrix((ones, (np.r_[a, b], np.r_[b, c])), shape=(len(mesh.positions),) * 2)
    labels = connected_components(graph, directed=False)[1]
    best = np.bincount(labels[a]).argmax()
    used, compact = np.unique(mesh.triangles[labels[a] == best], return_inverse=True)
    return Mesh(mesh.positions[used], compact.reshape(-1, 3))


def unit_scale(mesh):
    """The mesh with a diagonal of 1 m, its bounding box centred at the origin."""
    centre = (mesh.positions.min(axis=0) + mesh.positions.max(axis=0)) / 2
    return Mesh((mesh.positions - centre) / mesh.diagonal, mesh.triangles)


def renumbered(mesh, seed=1):
    """The same mesh with vertices and triangles in another order, and where each vertex went."""
    random = np.random.default_rng(seed)
    place = random.permutation(len(mesh.positions))
    positions = np.empty_like(mesh.positions)
    positions[place] = mesh.positions
    return Mesh(positions, random.permutation(place[mesh.triangles])), place


def bumpy_sphere(cells=6):
    """A closed body: an octahedron's edges divided by `cells`, its radius varied so that no mode is multiple."""
    vertices, triangles = {}, []

    def vertex(p):
        return vertices.setdefault(p, len(vertices))

    for sx in (1, -1):
        for sy in (1, -1):
            for sz in (1, -1):
                for i in range(cells):
                    for j in range(cells - i):
                        at = lambda a, b: vertex((sx * a, sy * b, sz * (cells - a - b)))
                        faces = [(at(i, j), at(i + 1, j), at(i, j + 1))]
                        if i + j + 1 < cells:
                            faces.append((at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)))
                        triangles += faces if sx * sy * sz > 0 else [face[::-1] for face in faces]
    points = np.array(list(vertices), float)
    points /= np.linalg.norm(points, axis=1)[:, None]
    x, y, z = points.T
    radius = 1 + 0.12 * np.sin(5 * x + 1) * np.sin(4 * y + 2) + 0.1 * np.sin(3 * z)
    return Mesh(points * radius[:, None] * [1, 0.8, 1.3], triangles)


def bent_strip(cells=(8, 16), bend=1.2):
    """An open sheet: a strip of 1 x 2 rolled over an angle of `bend`, slightly uneven."""
    rows, columns = cells
    u, v = np.meshgrid(np.linspace(0, 1, rows + 1), np.linspace(0, 1, columns + 1), indexing="ij")
    radius = 2 / bend
    x = u + 0.03 * np.sin(4 * v + u)
    points = np.stack([x, radius * np.sin(bend * v), radius * np.cos(bend * v) + 0.05 * u * v], -1)
    index = np.arange((rows + 1) * (columns + 1)).reshape(rows + 1, columns + 1)
    a, b, c, d = index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]
    odd = (np.add.outer(np.arange(rows), np.arange(columns)) % 2).astype(bool)[..., None]
    first = np.where(odd, np.stack([a, b, c], -1), np.stack([a, b, d], -1))
    second = np.where(odd, np.stack([a, c, d], -1), np.stack([b, c, d], -1))
    return Mesh(points.reshape(-1, 3), np.concatenate([first.reshape(-1, 3), second.reshape(-1, 3)]))


def closest_points(mesh, points, candidates=24):
    """(triangles, weights): for every point the triangle nearest to it and barycentric weights there.

    Candidates are triangles around the nearest centroids and vertices; distances to them are exact.
    """
    corners = mesh.positions[mesh.triangles]
    tree = cKDTree(corners.mean(axis=1))
    _, near = tree.query(points, k=min(candidates, len(mesh.triangles)))
    near = near.reshape(len(points), -1)
    best = np.full(len(points), np.inf)
    triangle = np.zeros(len(points), int)
    weights = np.zeros((len(points), 3))
    for k in range(near.shape[1]):
        bary = _nearest_barycentric(points, corners[near[:, k]])
        place = np.einsum("pk,pkc->pc", bary, corners[near[:, k]])
        distance = np.linalg.norm(place - points, axis=1)
        better = distance < best
        best[better], triangle[better], weights[better] = distance[better], near[better, k], bary[better]
    return triangle, weights


def _nearest_barycentric(points, corners):
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    e0, e1, d = b - a, c - a, points - a
    g00, g01, g11 = (np.einsum("pc,pc->p", *pair) for pair in ((e0, e0), (e0, e1), (e1, e1)))
    h0, h1 = np.einsum("pc,pc->p", e0, d), np.einsum("pc,pc->p", e1, d)
    determinant = np.maximum(g00 * g11 - g01**2, 1e-300)
    v, w = (g11 * h0 - g01 * h1) / determinant, (g00 * h1 - g01 * h0) / determinant
    best = np.column_stack([1 - v - w, v, w])
    outside = (best < 0).any(axis=1)
    choices, distances = [], []
    for i, j in ((0, 1), (1, 2), (2, 0)):
        p, q = corners[:, i], corners[:, j]
        t = np.einsum("pc,pc->p", points - p, q - p) / np.maximum(np.einsum("pc,pc->p", q - p, q - p), 1e-300)
        t = np.clip(t, 0, 1)
        bary = np.zeros((len(points), 3))
        bary[:, i], bary[:, j] = 1 - t, t
        choices.append(bary)
        distances.append(np.linalg.norm(p + t[:, None] * (q - p) - points, axis=1))
    edge = np.argmin(distances, axis=0)
    best[outside] = np.array(choices)[edge, np.arange(len(points))][outside]
    return best


def low_pins(mesh, percent=6, axis=None):
    """Vertices within the lowest `percent` along the longest axis of the bounding box (--pins low:6)."""
    axis = int(np.argmax(np.ptp(mesh.positions, axis=0))) if axis is None else axis
    x = mesh.positions[:, axis]
    return np.flatnonzero(x <= x.min() + percent / 100 * np.ptp(x))


def carried_pins(original, pins, coarse):
    """Vertices of the coarse mesh whose nearest point on the original is at least half pinned."""
    if len(pins) == 0:
        return np.zeros(0, int)
    pinned = np.zeros(len(original.positions))
    pinned[pins] = 1
    triangle, weights = closest_points(original, coarse.positions)
    share = (pinned[original.triangles[triangle]] * weights).sum(1)
    return np.flatnonzero(share >= 0.5)
