"""Reads an STL or 3MF, looks whether it is a closed body, and prints what it found as JSON.

    check_solid.py FILE
"""
import collections
import json
import struct
import sys
import xml.etree.ElementTree as ElementTree
import zipfile

CORE = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"


def read_stl(data, errors):
    count = struct.unpack_from("<I", data, 80)[0]
    if len(data) != 84 + 50 * count:
        errors.append("the size is not that of so many triangles")
    points, index, triangles = [], {}, []
    for t in range(count):
        numbers = struct.unpack_from("<12fH", data, 84 + 50 * t)
        corners = []
        for c in range(3):
            place = numbers[3 + 3 * c:6 + 3 * c]
            if place not in index:
                index[place] = len(points)
                points.append(place)
            corners.append(index[place])
        triangles.append(corners)
    return points, triangles


def read_3mf(path, errors):
    with zipfile.ZipFile(path) as archive:
        if archive.testzip():
            errors.append("a checksum is wrong")
        if not {"[Content_Types].xml", "_rels/.rels", "3D/3dmodel.model"} <= set(archive.namelist()):
            errors.append("parts of the package are missing")
        model = ElementTree.fromstring(archive.read("3D/3dmodel.model"))
        ElementTree.fromstring(archive.read("[Content_Types].xml"))
        relation = ElementTree.fromstring(archive.read("_rels/.rels"))[0]
        if relation.get("Target") != "/3D/3dmodel.model":
            errors.append("the model is not named")
    if model.tag != CORE + "model" or model.get("unit") != "millimeter":
        errors.append("no model in millimetres")
    objects = model.findall(f"{CORE}resources/{CORE}object")
    items = [item.get("objectid") for item in model.findall(f"{CORE}build/{CORE}item")]
    if items != [o.get("id") for o in objects] or not objects:
        errors.append("not each object is built once")
    points, triangles = [], []
    for body in objects:
        first = len(points)
        points += [tuple(float(v.get(k)) for k in "xyz") for v in body.iter(CORE + "vertex")]
        triangles += [[first + int(t.get(k)) for k in ("v1", "v2", "v3")] for t in body.iter(CORE + "triangle")]
    return points, triangles


def look_at(points, triangles, errors):
    edges = collections.Counter()
    for t in triangles:
        if len(set(t)) != 3:
            errors.append(f"a triangle without three corners: {t}")
        if max(t) >= len(points):
            errors.append("an index is out of range")
            return 0
        for k in range(3):
            edges[(t[k], t[(k + 1) % 3])] += 1
    twice = sum(1 for n in edges.values() if n != 1)
    alone = sum(1 for a, b in edges if (b, a) not in edges)
    if twice or alone:
        errors.append(f"{twice} edges more than once in one direction, {alone} without a partner")
    used = {i for t in triangles for i in t}
    if len(used) != len(points):
        errors.append("points that nobody needs")
    six = 0
    o = points[0]
    for t in triangles:
        a, b, c = ([points[i][k] - o[k] for k in range(3)] for i in t)
        six += (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
                + a[2] * (b[0] * c[1] - b[1] * c[0]))
    return six / 6


def main(path):
    errors = []
    with open(path, "rb") as file:
        data = file.read()
    points, triangles = read_3mf(path, errors) if data[:2] == b"PK" else read_stl(data, errors)
    volume = look_at(points, triangles, errors)
    print(json.dumps({"errors": errors[:20], "triangles": len(triangles), "points": len(points), "volume": volume,
                      "low": [min(p[k] for p in points) for k in range(3)],
                      "high": [max(p[k] for p in points) for k in range(3)]}))


main(sys.argv[1])
