#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes a tetrahedron of 1 x 2 x 3 m, volume 1 m^3, in each format of lr_bake, to test all readers of a packaged baker.

    write_meshes.py FOLDER
"""
import struct
import sys
from pathlib import Path

VERTICES = [(0, 0, 0), (1, 0, 0), (0, 2, 0), (0, 0, 3)]
FACES = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
FLAT = " ".join(str(x) for v in VERTICES for x in v)


def obj() -> bytes:
    return ("".join("v %g %g %g\n" % v for v in VERTICES)
            + "".join("f %d %d %d\n" % tuple(i + 1 for i in f) for f in FACES)).encode()


def ply() -> bytes:
    return (f"ply\nformat ascii 1.0\nelement vertex {len(VERTICES)}\nproperty float x\nproperty float y\nproperty float z\n"
            f"element face {len(FACES)}\nproperty list uchar int vertex_indices\nend_header\n"
            + "".join("%g %g %g\n" % v for v in VERTICES) + "".join("3 %d %d %d\n" % f for f in FACES)).encode()


def stl() -> bytes:
    facets = b"".join(struct.pack("<12fH", 0, 0, 0, *(x for i in f for x in VERTICES[i]), 0) for f in FACES)
    return bytes(80) + struct.pack("<I", len(FACES)) + facets


def glb() -> bytes:
    positions = b"".join(struct.pack("<3f", *v) for v in VERTICES)
    indices = b"".join(struct.pack("<3I", *f) for f in FACES)
    json = ('{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"name":"body","mesh":0}],'
            '"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],'
            f'"buffers":[{{"byteLength":{len(positions + indices)}}}],"bufferViews":[{{"buffer":0,"byteLength":{len(positions)}}},'
            f'{{"buffer":0,"byteOffset":{len(positions)},"byteLength":{len(indices)}}}],"accessors":[{{"bufferView":0,'
            f'"componentType":5126,"count":{len(VERTICES)},"type":"VEC3","min":[0,0,0],"max":[1,2,3]}},'
            f'{{"bufferView":1,"componentType":5125,"count":{3 * len(FACES)},"type":"SCALAR"}}]}}').encode()
    json += b" " * (-len(json) % 4)
    body = positions + indices
    return (struct.pack("<4sII", b"glTF", 2, 28 + len(json) + len(body)) + struct.pack("<I4s", len(json), b"JSON") + json
            + struct.pack("<I4s", len(body), b"BIN\0") + body)


def dae() -> bytes:
    triangles = " ".join(str(i) for f in FACES for i in f)
    return f"""<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><unit name="meter" meter="1"/></asset>
<library_geometries><geometry id="g" name="g"><mesh><source id="p"><float_array id="a" count="{3 * len(VERTICES)}">{FLAT}</float_array>
<technique_common><accessor source="#a" count="{len(VERTICES)}" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="{len(FACES)}"><input semantic="VERTEX" source="#v" offset="0"/><p>{triangles}</p></triangles></mesh></geometry>
</library_geometries><library_visual_scenes><visual_scene id="s"><node id="n" name="body"><instance_geometry url="#g"/></node>
</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>
""".encode()


def fbx() -> bytes:
    corners = ",".join(f"{f[0]},{f[1]},-{f[2] + 1}" for f in FACES)
    return f"""; FBX 7.3.0 project file
FBXHeaderExtension:  {{
\tFBXHeaderVersion: 1003
\tFBXVersion: 7300
}}
GlobalSettings:  {{
\tVersion: 1000
\tProperties70:  {{
\t\tP: "UnitScaleFactor", "double", "Number", "",100
\t}}
}}
Objects:  {{
\tGeometry: 1000, "Geometry::body", "Mesh" {{
\t\tVertices: *{3 * len(VERTICES)} {{
\t\t\ta: {FLAT.replace(" ", ",")}
\t\t}}
\t\tPolygonVertexIndex: *{3 * len(FACES)} {{
\t\t\ta: {corners}
\t\t}}
\t\tGeometryVersion: 124
\t}}
\tModel: 2000, "Model::body", "Mesh" {{
\t\tVersion: 232
\t}}
}}
Connections:  {{
\tC: "OO",2000,0
\tC: "OO",1000,2000
}}
""".encode()


def main() -> None:
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for write in (obj, ply, stl, glb, dae, fbx):
        (folder / f"tetrahedron.{write.__name__}").write_bytes(write())


if __name__ == "__main__":
    main()
