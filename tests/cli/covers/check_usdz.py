"""Unpacks a USDZ, reads its USD text, and prints what is in it and what is wrong as JSON.

    check_usdz.py FILE
"""
import json
import re
import struct
import sys
import zipfile

TOKEN = re.compile(r"\s*(?:#[^\n]*\s*)*(\"(?:[^\"\\]|\\.)*\"|@[^@]*@|<[^>]*>|[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
                   r"|[A-Za-z_][\w:.]*(?:\[\])?|[(){}\[\]=,])")


class Reader:
    def __init__(self, text):
        self.tokens, at = [], 0
        text = text.rstrip()
        while at < len(text):
            found = TOKEN.match(text, at)
            if not found:
                raise SystemExit(f"not to be read: {text[at:at + 60]!r}")
            self.tokens.append(found.group(1))
            at = found.end()
        self.at = 0

    def peek(self):
        return self.tokens[self.at] if self.at < len(self.tokens) else None

    def take(self, expected=None):
        token = self.tokens[self.at]
        if expected and token != expected:
            raise SystemExit(f"{expected} expected, not {token} ({' '.join(self.tokens[self.at - 8:self.at + 4])})")
        self.at += 1
        return token

    def value(self):
        token = self.take()
        closing = {"(": ")", "[": "]"}.get(token)
        if closing:
            values = []
            while self.peek() != closing:
                values.append(self.value())
                if self.peek() == ",":
                    self.take()
            self.take()
            return values
        if token == "{":
            values = {}
            while self.peek() != "}":
                self.take()  # the type
                name = self.take()
                self.take("=")
                values[name] = self.value()
            self.take()
            return values
        return token[1:-1] if token[0] in "\"@<" else float(token) if re.match(r"[-+.\d]", token) else token

    def metadata(self):
        values = {}
        if self.peek() != "(":
            return values
        self.take()
        while self.peek() != ")":
            words = [self.take()]
            while self.peek() != "=":
                words.append(self.take())
            self.take()
            values[words[-1]] = self.value()
        self.take()
        return values

    def body(self, prim):
        self.take("{")
        while self.peek() != "}":
            if self.peek() in ("def", "over"):
                child = self.prim()
                prim["children"][child["name"]] = child
            elif self.peek() == "variantSet":
                self.take()
                name = self.value()
                self.take("=")
                self.take("{")
                variants = prim["variants"].setdefault(name, {})
                while self.peek() != "}":
                    variant = variants.setdefault(self.value(), {"children": {}, "values": {}, "variants": {}})
                    self.body(variant)
                self.take()
            else:
                words = [self.take()]
                while self.peek() not in ("=", "}", "(") and len(words) < 4 and not (
                        len(words) >= 2 and words[-1].startswith("outputs:")):
                    words.append(self.take())
                value = None
                if self.peek() == "=":
                    self.take()
                    value = self.value()
                self.metadata()
                prim["values"][words[-1]] = value
        self.take()

    def prim(self):
        how = self.take()
        kind = self.take() if not self.peek().startswith("\"") else None
        prim = {"how": how, "kind": kind, "name": self.value(), "children": {}, "values": {}, "variants": {}}
        prim["about"] = self.metadata()
        self.body(prim)
        return prim


def paths(prim, at=""):
    at += "/" + prim["name"]
    yield at, prim
    for child in prim["children"].values():
        yield from paths(child, at)


def check_zip(data, archive, errors):
    for info in archive.infolist():
        if info.compress_type != zipfile.ZIP_STORED:
            errors.append(f"{info.filename} is compressed")
        name, extra = struct.unpack_from("<HH", data, info.header_offset + 26)
        if (info.header_offset + 30 + name + extra) % 64:
            errors.append(f"{info.filename} does not begin at a multiple of 64")
    if archive.testzip():
        errors.append("a checksum is wrong")
    if not archive.namelist()[0].endswith(".usda"):
        errors.append("the first file is no USD")


def check_mesh(path, mesh, errors):
    values = mesh["values"]
    points, indices = values["points"], values["faceVertexIndices"]
    if len(values["faceVertexCounts"]) * 3 != len(indices) or set(values["faceVertexCounts"]) != {3.0}:
        errors.append(f"{path}: counts")
    if max(indices) >= len(points) or min(indices) < 0:
        errors.append(f"{path}: an index is out of range")
    for name, value in values.items():
        if (name == "normals" or name.startswith("primvars:")) and len(value) != len(points):
            errors.append(f"{path}: {name} are not as many as points")
    low, high = values["extent"]
    for k in range(3):
        if low[k] != min(p[k] for p in points) or high[k] != max(p[k] for p in points):
            errors.append(f"{path}: extent")


def main(path):
    errors = []
    with open(path, "rb") as file:
        data = file.read()
    with zipfile.ZipFile(path) as archive:
        check_zip(data, archive, errors)
        names = archive.namelist()
        text = archive.read(names[0]).decode("utf-8")
    if not text.startswith("#usda 1.0\n"):
        errors.append("no USD text")
    reader = Reader(text)
    layer = reader.metadata()
    root = reader.prim()
    everything = dict(paths(root))
    if layer.get("upAxis") != "Y" or layer.get("metersPerUnit") != 1 or layer.get("defaultPrim") != root["name"]:
        errors.append(f"layer: {layer}")
    textures, meshes = set(), []
    for at, prim in everything.items():
        if prim["kind"] == "Mesh":
            check_mesh(at, prim, errors)
            meshes.append(at)
        for name, value in prim["values"].items():
            if name.endswith(".connect"):
                target, _, output = value.partition(".")
                if target not in everything or output not in everything[target]["values"]:
                    errors.append(f"{at} {name} leads to {value}, which is not there")
            if name == "inputs:file":
                textures.add(value)
    errors += [f"{t} is missing" for t in textures if t not in names]
    errors += [f"{n} is used by nobody" for n in names[1:] if n not in textures]
    variants = root["variants"].get("colourway", {})
    bindings = {at: [everything[at]["values"].get("material:binding")] for at in meshes}
    for variant in variants.values():
        for name, over in variant["children"].items():
            bindings[f"/{root['name']}/{name}"].append(over["values"]["material:binding"])
    for at, found in bindings.items():
        found = [b for b in found if b]
        if len(found) != max(1, len(variants)) or any(b not in everything for b in found):
            errors.append(f"{at}: bindings {found}")
    if variants and root["about"].get("variants", {}).get("colourway") not in variants:
        errors.append("no variant is chosen")
    print(json.dumps({"errors": errors[:20], "meshes": len(meshes), "variants": list(variants),
                      "textures": sorted(textures)}))


main(sys.argv[1])
