"""Reads a mesh with the Python package `trimesh` and prints what it finds of it as JSON.

Nothing here is Brooklet's own code, so what this prints is what any other program sees.

    python read_mesh.py mesh.ply
"""

import json
import sys

import numpy as np
import trimesh
from trimesh.exchange.obj import load_obj
from trimesh.exchange.ply import load_ply


def normals(path: str) -> np.ndarray:
    """The file's own normals: a loaded mesh computes others from its triangles."""
    with open(path, "rb") as file:
        loaded = load_ply(file) if path.endswith(".ply") else next(iter(load_obj(file)["geometry"].values()))
    return np.asarray(loaded["vertex_normals"])


def main(path: str) -> None:
    # As it is, and as it comes by default: vertices in one place are then one.
    mesh = trimesh.load_mesh(path, process=False)
    merged = trimesh.load_mesh(path)
    own = normals(path)
    outward = (own[mesh.faces] * mesh.face_normals[:, None, :]).sum(axis=2)
    json.dump(
        {
            "vertices": len(mesh.vertices),
            "triangles": len(mesh.faces),
            "is_watertight": bool(mesh.is_watertight),
            "is_winding_consistent": bool(mesh.is_winding_consistent),
            "is_volume": bool(mesh.is_volume),
            "euler_number": int(mesh.euler_number),
            "volume_m3": float(mesh.volume),
            "min_m": mesh.bounds[0].tolist(),
            "max_m": mesh.bounds[1].tolist(),
            "merged_vertices": len(merged.vertices),
            "merged_is_watertight": bool(merged.is_watertight),
            "outward_normals": float((outward > 0.0).mean()),
            "normal_length_error": float(np.abs(np.linalg.norm(own, axis=1) - 1.0).max()),
        },
        sys.stdout,
    )


if __name__ == "__main__":
    main(sys.argv[1])
