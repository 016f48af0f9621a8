"""Reads a binary glTF as the specification says, and prints what is in it and what is wrong as JSON. Of a page for
customers, the one that is packed in it.

    check_glb.py FILE
"""
import base64
import json
import math
import re
import struct
import sys
import zlib

COMPONENTS = {5120: ("b", 1), 5121: ("B", 1), 5122: ("h", 2), 5123: ("H", 2), 5125: ("I", 4), 5126: ("f", 4)}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
KNOWN = {"KHR_materials_variants", "KHR_texture_transform", "KHR_materials_sheen", "KHR_mesh_quantization"}


class Glb:
    def __init__(self, data):
        self.errors = []
        magic, version, length = struct.unpack_from("<4sII", data)
        self.check(magic == b"glTF" and version == 2, "no glTF 2")
        self.check(length == len(data), f"length {length} of {len(data)}")
        chunks, at = [], 12
        while at < len(data):
            size, kind = struct.unpack_from("<I4s", data, at)
            self.check(size % 4 == 0, "a chunk is not a multiple of 4")
            chunks.append((kind, data[at + 8:at + 8 + size]))
            at += 8 + size
        self.check([kind for kind, _ in chunks] == [b"JSON", b"BIN\0"], "chunks")
        self.json = json.loads(chunks[0][1].decode("utf-8"))
        self.bin = chunks[1][1]
        self.check(chunks[0][1].rstrip(b" ").endswith(b"}"), "JSON is padded with other than blanks")

    def check(self, good, what):
        if not good:
            self.errors.append(what)
        return good

    def view(self, index, whose):
        view = self.json["bufferViews"][index]
        start, size = view.get("byteOffset", 0), view["byteLength"]
        self.check(size > 0 and start + size <= len(self.bin), f"{whose}: the view is beyond the buffer")
        return view, self.bin[start:start + size]

    def accessor(self, index, whose):
        accessor = self.json["accessors"][index]
        view, data = self.view(accessor["bufferView"], whose)
        letter, size = COMPONENTS[accessor["componentType"]]
        width, count = WIDTHS[accessor["type"]], accessor["count"]
        offset = accessor.get("byteOffset", 0)
        self.check(count > 0, f"{whose}: empty")
        self.check((view.get("byteOffset", 0) + offset) % size == 0, f"{whose}: not aligned")
        stride = view.get("byteStride", width * size)
        self.check(stride % 4 == 0 or "target" not in view or view["target"] == 34963, f"{whose}: stride {stride}")
        self.check(offset + (count - 1) * stride + width * size <= len(data), f"{whose}: beyond its view")
        rows = [struct.unpack_from(f"<{width}{letter}", data, offset + i * stride) for i in range(count)]
        if accessor.get("normalized"):
            rows = [tuple(max(n / 32767, -1) for n in row) for row in rows]
        self.check(all(math.isfinite(n) for row in rows for n in row), f"{whose}: not finite")
        if "min" in accessor:
            for name, of in (("min", min), ("max", max)):
                found = [of(row[k] for row in rows) for k in range(width)]
                self.check(accessor[name] == found, f"{whose}: {name} is {accessor[name]}, not {found}")
        return accessor, view, rows


def image_size(data):
    """Width and height by the file's own words."""
    if data[:8] == b"\x89PNG\r\n\x1a\n":
        return "image/png", struct.unpack(">II", data[16:24])
    if data[:3] != b"\xff\xd8\xff":
        return "?", (0, 0)
    at = 2
    while at < len(data):
        marker, size = data[at + 1], struct.unpack(">H", data[at + 2:at + 4])[0]
        if marker in (0xC0, 0xC1, 0xC2):
            height, width = struct.unpack(">HH", data[at + 5:at + 9])
            return "image/jpeg", (width, height)
        at += 2 + size
    return "image/jpeg", (0, 0)


def texture_infos(material):
    surface = material["pbrMetallicRoughness"]
    for holder, key in ((surface, "baseColorTexture"), (surface, "metallicRoughnessTexture"),
                        (material, "normalTexture")):
        if key in holder:
            yield holder[key]


def check_material(glb, index):
    material = glb.json["materials"][index]
    factor = material["pbrMetallicRoughness"]["baseColorFactor"]
    glb.check(len(factor) == 4 and all(0 <= n <= 1 for n in factor), f"material {index}: {factor}")
    for key in ("metallicFactor", "roughnessFactor"):
        glb.check(0 <= material["pbrMetallicRoughness"][key] <= 1, f"material {index}: {key}")
    for info in texture_infos(material):
        glb.check(0 <= info["index"] < len(glb.json.get("textures", [])), f"material {index}: texture")
    for name in material.get("extensions", {}):
        glb.check(name in glb.json["extensionsUsed"], f"{name} is used but not named")


def check_primitive(glb, name, primitive, variants):
    attributes, rows = primitive["attributes"], {}
    for key, index in attributes.items():
        accessor, view, rows[key] = glb.accessor(index, f"{name} {key}")
        glb.check(view["target"] == 34962, f"{name} {key}: target")
        small = key == "NORMAL" and "KHR_mesh_quantization" in glb.json.get("extensionsRequired", [])
        glb.check((accessor["componentType"], accessor.get("normalized", False)) ==
                  ((5122, True) if small else (5126, False)), f"{name} {key}: kind of numbers")
        if key == "POSITION":
            glb.check("min" in accessor and "max" in accessor, f"{name}: no bounds")
    glb.check(len({len(list(r)) for r in rows.values()}) == 1, f"{name}: attributes differ in number")
    off = [n for n in rows["NORMAL"] if abs(math.hypot(*n) - 1) > 5e-4]
    glb.check(not off, f"{name}: {len(off)} normals are no unit vectors")
    accessor, view, indices = glb.accessor(primitive["indices"], f"{name} indices")
    flat = [row[0] for row in indices]
    glb.check(view["target"] == 34963 and accessor["componentType"] in (5123, 5125), f"{name}: indices")
    glb.check(len(flat) % 3 == 0 and max(flat) < len(rows["POSITION"]), f"{name}: an index is out of range")
    glb.check(accessor["componentType"] != 5123 or max(flat) < 65535, f"{name}: restarts a strip")
    glb.check(set(flat) == set(range(len(rows["POSITION"]))), f"{name}: vertices that nobody needs")
    used = [primitive["material"]]
    mappings = primitive.get("extensions", {}).get("KHR_materials_variants", {}).get("mappings", [])
    if variants:
        glb.check(sorted(v for m in mappings for v in m["variants"]) == list(range(len(variants))),
                  f"{name}: not each variant once")
        used += [m["material"] for m in mappings]
    for material in used:
        if not glb.check(0 <= material < len(glb.json["materials"]), f"{name}: material {material}"):
            continue
        for info in texture_infos(glb.json["materials"][material]):
            glb.check(f"TEXCOORD_{info.get('texCoord', 0)}" in attributes, f"{name}: no coordinates for its texture")
    return rows, flat


def facing_in(rows, flat):
    """The share of triangles whose normals look the other way."""
    wrong = 0
    points, normals = rows["POSITION"], rows["NORMAL"]
    for t in range(0, len(flat), 3):
        a, b, c = (points[i] for i in flat[t:t + 3])
        u, v = [b[k] - a[k] for k in range(3)], [c[k] - a[k] for k in range(3)]
        cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
        mean = [sum(normals[i][k] for i in flat[t:t + 3]) for k in range(3)]
        wrong += sum(cross[k] * mean[k] for k in range(3)) < 0
    return wrong / max(1, len(flat) // 3)


def flat_places(rows, flat):
    """How many triangles have texture coordinates on a line: there is no direction for their slopes."""
    found = 0
    for key, places in rows.items():
        for t in range(0, len(flat), 3) if key.startswith("TEXCOORD") else ():
            a, b, c = (places[i] for i in flat[t:t + 3])
            area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
            found += abs(area) < 1e-9
    return found


def turned(q, p):
    """By a quaternion x, y, z, w."""
    x, y, z, w = q
    t = [2 * (y * p[2] - z * p[1]), 2 * (z * p[0] - x * p[2]), 2 * (x * p[1] - y * p[0])]
    return [p[0] + w * t[0] + y * t[2] - z * t[1], p[1] + w * t[1] + z * t[0] - x * t[2],
            p[2] + w * t[2] + x * t[1] - y * t[0]]


def main(path):
    with open(path, "rb") as file:
        data = file.read()
    if packed := re.search(rb'<script id="model"[^>]*>([^<]*)</script>', data):
        data = zlib.decompress(base64.b64decode(packed.group(1)))
    glb = Glb(data)
    doc = glb.json
    glb.check(doc["asset"]["version"] == "2.0", "asset.version")
    used = doc.get("extensionsUsed", [])
    glb.check(set(used) <= KNOWN and len(used) == len(set(used)), f"extensions {used}")
    glb.check(doc["buffers"] == [{"byteLength": len(glb.bin)}], "buffers")
    variants = [v["name"] for v in doc.get("extensions", {}).get("KHR_materials_variants", {}).get("variants", [])]
    glb.check(bool(variants) == ("KHR_materials_variants" in used), "variants")
    images = []
    for image in doc.get("images", []):
        _, data = glb.view(image["bufferView"], "image")
        kind, size = image_size(data)
        glb.check(kind == image["mimeType"] and min(size) > 0, f"image {image['name']} is {kind} {size}")
        images.append({"name": image["name"], "bytes": len(data), "size": size})
    for texture in doc.get("textures", []):
        glb.check(texture["source"] < len(images) and texture["sampler"] < len(doc["samplers"]), "texture")
    for index in range(len(doc["materials"])):
        check_material(glb, index)
    names = [m["name"] for m in doc["materials"]]
    glb.check(len(names) == len(set(names)), "materials of one name")

    root = doc["nodes"][doc["scenes"][doc["scene"]]["nodes"][0]]
    glb.check(sorted(root["children"]) == list(range(len(doc["nodes"]) - 1)), "nodes")
    meshes, low, high = [], [math.inf] * 3, [-math.inf] * 3
    for node in root["children"]:
        mesh = doc["meshes"][doc["nodes"][node]["mesh"]]
        rows, flat = check_primitive(glb, mesh["name"], mesh["primitives"][0], variants)
        for p in rows["POSITION"]:
            p = turned(root.get("rotation", [0, 0, 0, 1]), p)
            low = [min(low[k], p[k] + root["translation"][k]) for k in range(3)]
            high = [max(high[k], p[k] + root["translation"][k]) for k in range(3)]
        places = rows.get("TEXCOORD_0")
        meshes.append({"name": mesh["name"], "kind": mesh["extras"]["kind"], "triangles": len(flat) // 3,
                       "vertices": len(rows["POSITION"]), "facing_in": facing_in(rows, flat),
                       "flat_places": flat_places(rows, flat),
                       "sets": sum(key.startswith("TEXCOORD") for key in rows),
                       "tiles": [max(p[k] for p in places) - min(p[k] for p in places) for k in range(2)]
                       if places else None})
    print(json.dumps({"errors": glb.errors, "meshes": meshes, "variants": variants, "images": images,
                      "materials": doc["materials"], "extensions": used, "low": low, "high": high}))


main(sys.argv[1])
