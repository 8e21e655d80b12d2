"""Runs a peer once: peer.py PEER MESH FACES RESULT. Prints {"seconds", "version"}; times only the decimation.

Meshes are files of tests/bench/bench_meshes.mjs: two uint32 counts, float32 positions, uint32 triangles.
"""

import json
import sys
import time
from importlib.metadata import version
from pathlib import Path

import numpy


def read_mesh(path):
    vertex_count, triangle_count = numpy.fromfile(path, numpy.uint32, 2)
    positions = numpy.fromfile(path, numpy.float32, 3 * vertex_count, offset=8)
    triangles = numpy.fromfile(path, numpy.uint32, 3 * triangle_count, offset=8 + positions.nbytes)
    return positions.reshape(-1, 3), triangles.reshape(-1, 3)


def write_mesh(path, positions, triangles):
    with open(path, "wb") as file:
        numpy.array([len(positions), len(triangles)], numpy.uint32).tofile(file)
        positions.astype(numpy.float32).tofile(file)
        triangles.astype(numpy.uint32).tofile(file)


def run_pymeshlab(positions, triangles, faces, **options):
    import pymeshlab

    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.add_mesh(pymeshlab.Mesh(positions.astype(numpy.float64), triangles.astype(numpy.int32)))
    started = time.perf_counter()
    meshes.meshing_decimation_quadric_edge_collapse(targetfacenum=faces, **options)
    seconds = time.perf_counter() - started
    result = meshes.current_mesh()
    return result.vertex_matrix(), result.face_matrix(), seconds


def run_fast_simplification(positions, triangles, faces):
    import fast_simplification

    triangles = triangles.astype(numpy.int32)
    started = time.perf_counter()
    result = fast_simplification.simplify(positions, triangles, target_count=faces)
    return *result, time.perf_counter() - started


def run_literature(name, positions, triangles, faces):
    """A method of tests/bench/literature."""
    sys.path.insert(0, str(Path(__file__).parent.parent / "literature"))
    method = __import__(name)
    started = time.perf_counter()
    result = method.simplify(positions, triangles, faces)
    return *result, time.perf_counter() - started


LITERATURE = {"Lescoat 2020": "spectral", "Dunyach 2013": "remeshing"}


def main():
    peer, source, faces, target = sys.argv[1:]
    positions, triangles = read_mesh(source)
    if peer == "pymeshlab":
        result = run_pymeshlab(positions, triangles, int(faces), preservetopology=True, preserveboundary=True)
    elif peer in LITERATURE:
        result = run_literature(LITERATURE[peer], positions, triangles, int(faces))
    else:
        result = run_fast_simplification(positions, triangles, int(faces))
    write_mesh(target, *result[:2])
    print(json.dumps({"seconds": result[2], "version": version("scipy" if peer in LITERATURE else peer)}))


main()
