"""The meshes that are compared: ours and those of other simplifiers, at 25 % of the faces, kept on disk."""

import subprocess
from pathlib import Path

import numpy as np

from glb import read_glb
from meshes import read_obj, weld, write_obj
from product import CLI, ROOT

FOLDER = ROOT / "build" / "bench" / "engines" / "meshes"


def _ours(source, faces, pins, target, extra):
    binary = target.with_suffix(".glb")
    command = ["node", CLI, "optimize", str(source), str(binary),
               "--quiet", "--faces", str(faces), "--max-deviation", "0", *extra]
    subprocess.run(command + (["--pins", pins] if pins else []), check=True, capture_output=True)
    return read_glb(binary)


def _meshoptimizer(source, faces, pins, target, kind):
    script = Path(__file__).with_name("simplify.mjs")
    subprocess.run(["node", str(script), str(source), str(target), str(faces), kind], check=True)
    return read_obj(target)


def _pymeshlab(source, faces, pins, target, options):
    import pymeshlab

    mesh = read_obj(source)
    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.add_mesh(pymeshlab.Mesh(mesh.positions, mesh.triangles.astype(np.int32)))
    meshes.meshing_decimation_quadric_edge_collapse(targetfacenum=faces, **options)
    result = meshes.current_mesh()
    return weld(result.vertex_matrix(), result.face_matrix())


def _fast_simplification(source, faces, pins, target, options):
    import fast_simplification

    mesh = read_obj(source)
    points = mesh.positions.astype(np.float32)
    return weld(*fast_simplification.simplify(points, mesh.triangles.astype(np.int32), target_count=faces))


METHODS = {
    "limber": (_ours, []),
    "limber, fit off": (_ours, ["--fit", "off"]),
    "meshoptimizer": (_meshoptimizer, "plain"),
    "update + Regularize": (_meshoptimizer, "regularize"),
    # Its defaults, said all the same: it takes what a call before has said for the defaults of the next.
    "pymeshlab": (_pymeshlab, {"planarquadric": False, "qualitythr": 0.3}),
    "pymeshlab, planar": (_pymeshlab, {"planarquadric": True, "qualitythr": 0.5}),
    "fast-simplification": (_fast_simplification, {}),
}
OURS = ("limber", "limber, fit off")
# Those of docs/motions.md: ours, and the others that come nearest.
DOCUMENTED = ("limber", "update + Regularize", "pymeshlab", "pymeshlab, planar")


def mesh_file(name, method=None):
    """Where the original, or what a method made of it, is stored."""
    method = f"-{method.replace(' ', '-').replace(',', '')}" if method else ""
    return FOLDER / f"{name}{method}.obj"


def simplified(name, mesh, pins, method, ratio=0.25):
    """The coarse mesh, computed once."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    source, target = mesh_file(name), mesh_file(name, method)
    if not source.exists():
        write_obj(source, mesh)
    if not target.exists():
        run, options = METHODS[method]
        write_obj(target, run(source, int(ratio * len(mesh.triangles)), pins, target, options))
    return read_obj(target)
