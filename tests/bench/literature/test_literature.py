"""Tests of the two methods of the literature. Usage: python test_literature.py; prints one line for each test that passes."""

import numpy
import remeshing
import spectral
from laplacian import laplacian
from surface import Surface, is_manifold


def sphere(rings, bump=0.0):
    """A closed surface of latitudes and longitudes with poles."""
    points = [(0.0, 0.0, 1.0)]
    for i in range(1, rings):
        for j in range(2 * rings):
            theta, phi = numpy.pi * i / rings, numpy.pi * (j + i / 2) / rings
            points.append((numpy.sin(theta) * numpy.cos(phi), numpy.sin(theta) * numpy.sin(phi), numpy.cos(theta)))
    points.append((0.0, 0.0, -1.0))
    width, triangles = 2 * rings, []
    for j in range(width):
        triangles += [(0, 1 + j, 1 + (j + 1) % width)]
        last = 1 + (rings - 2) * width
        triangles += [(len(points) - 1, last + (j + 1) % width, last + j)]
    for i in range(rings - 2):
        for j in range(width):
            a, b = 1 + i * width + j, 1 + i * width + (j + 1) % width
            triangles += [(a, a + width, b), (b, a + width, b + width)]
    positions = numpy.array(points)
    positions *= (1 + bump * numpy.sin(4 * positions[:, :1]) * numpy.cos(3 * positions[:, 1:2]))
    return positions, numpy.array(triangles)


def sheet(cells):
    x, y = numpy.meshgrid(*[numpy.linspace(0, 1, cells + 1)] * 2, indexing="ij")
    positions = numpy.stack([x.ravel(), y.ravel(), 0.1 * numpy.sin(3 * x.ravel())], 1)
    at = lambda i, j: i * (cells + 1) + j
    quads = [(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)) for i in range(cells) for j in range(cells)]
    return positions, numpy.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])


def test_costs_are_the_growth_of_the_energy_of_the_whole_mesh():
    positions, triangles = sphere(6, 0.2)
    for u, v, share in [(5, 6, 0.0), (5, 6, 0.3), (20, 21, 1.0), (30, 31, 0.5)]:
        mesh = spectral.SpectralMesh(positions, triangles, 10)
        before, cost = mesh.energy(), mesh.cost_at(mesh.star(u, v), share)
        mesh.take(u, v, share)
        assert abs(mesh.energy() - before - cost) < 1e-9 * max(1, abs(cost))
        # The kept sums are those of the coarse mesh as a whole.
        used = sorted(v for v, around in enumerate(mesh.around) if around)
        whole, masses = laplacian(*mesh.arrays())
        assert numpy.abs(whole @ mesh.values[used] - mesh.sums[used]).max() < 1e-9
        assert numpy.abs(masses - mesh.masses[used]).max() < 1e-12


def test_the_energy_begins_at_zero():
    mesh = spectral.SpectralMesh(*sphere(6, 0.2), 10)
    assert mesh.energy() < 1e-12 * (mesh.wanted**2).sum()


def test_both_keep_a_manifold_and_its_topology():
    for simplify in (spectral.simplify, remeshing.simplify):
        for (positions, triangles), euler in ((sphere(8, 0.2), 2), (sheet(10), 1)):
            p, t = simplify(positions, triangles, len(triangles) // 2)
            assert len(t) <= len(triangles) // 2 and len(t) > len(triangles) // 8
            assert is_manifold(t)
            assert len(p) - len(Surface(p, t).edges()) + len(t) == euler


def test_the_order_of_spectral_simplification_costs_less_energy_than_that_of_lengths():
    positions, triangles = sphere(10, 0.2)
    target = len(triangles) // 2
    short = spectral.SpectralMesh(positions, triangles, 20)
    length = lambda edge: numpy.linalg.norm(short.positions[edge[0]] - short.positions[edge[1]])
    while len(short.triangles) > target:
        for u, v in sorted(short.edges(), key=length):
            if short.can_collapse(u, v, short.point(u, v, 0.5)):
                short.take(u, v, 0.5)
                break
    own = spectral.SpectralMesh(positions, triangles, 20)
    own.simplify(target)
    assert own.energy() < 0.9 * short.energy()


def test_remeshed_edges_have_the_length_of_the_sizing_field():
    original = remeshing.Original(*sphere(16))
    assert abs(numpy.median(original.curvature) - 1) < 0.05
    error = 0.02
    mesh = remeshing.Remesher(original, error, 0.01, 2.0).run()
    wanted = numpy.sqrt(6 * error - 3 * error**2)
    lengths = numpy.array([mesh.length(u, v) for u, v in mesh.edges()])
    assert 0.8 * wanted < lengths.mean() < 1.2 * wanted
    assert ((lengths > 0.6 * wanted) & (lengths < 1.5 * wanted)).mean() > 0.9


def test_projection_finds_the_closest_point():
    corners = [numpy.array([[0.0, 0, 0]]), numpy.array([[1.0, 0, 0]]), numpy.array([[0.0, 1, 0]])]
    for point, nearest in (((0.2, 0.3, 1), (0.2, 0.3, 0)), ((-1, -1, 0), (0, 0, 0)), ((1, 1, 0), (0.5, 0.5, 0)), ((0.5, -2, 3), (0.5, 0, 0))):
        weights, distance = remeshing.closest_on_triangles(numpy.array(point, float), *corners)
        found = sum(w * c[0] for w, c in zip(weights[0], corners))
        assert numpy.abs(found - nearest).max() < 1e-12
        assert abs(distance[0] - ((numpy.array(point) - nearest) ** 2).sum()) < 1e-12


if __name__ == "__main__":
    for name, test in list(globals().items()):
        if name.startswith("test_"):
            test()
            print(f"ok {name}")
