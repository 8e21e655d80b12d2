"""Positions and triangles of an uncompressed GLB with one mesh, as the command line writes it."""

import json
import struct

import numpy as np

from meshes import weld

COMPONENTS = {5121: np.uint8, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}
WIDTH = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


def read_glb(path):
    data = open(path, "rb").read()
    length = struct.unpack_from("<I", data, 12)[0]
    document = json.loads(data[20 : 20 + length])
    binary = data[20 + length + 8 :]

    def array(index):
        accessor = document["accessors"][index]
        view = document["bufferViews"][accessor["bufferView"]]
        kind, width = np.dtype(COMPONENTS[accessor["componentType"]]), WIDTH[accessor["type"]]
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        stride = view.get("byteStride", kind.itemsize * width)
        rows = np.ndarray((accessor["count"], width), kind, binary, start, (stride, kind.itemsize))
        return rows.copy()

    positions, triangles, first = [], [], 0
    for mesh in document["meshes"]:
        for primitive in mesh["primitives"]:
            points = array(primitive["attributes"]["POSITION"])
            positions.append(points)
            triangles.append(first + array(primitive["indices"]).reshape(-1, 3).astype(np.int64))
            first += len(points)
    return weld(np.concatenate(positions), np.concatenate(triangles))
