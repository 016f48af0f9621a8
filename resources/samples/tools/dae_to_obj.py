#!/usr/bin/env python3
"""Takes one connected part out of a COLLADA file and writes it as OBJ, in millimetres and z-up.

    dae_to_obj.py IN.DAE OUT.obj --part N [--ignore-node-matrix] [--comment TEXT]

Parts are numbered by falling number of polygons. Standard library only; reads what modelling programs
export: polylist and triangles with a POSITION source.
"""

import argparse
import xml.etree.ElementTree as ElementTree

IDENTITY = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]


def read_mesh(root):
    """Positions and polygons (lists of position indices) of the file's first geometry."""
    mesh = root.find(".//{*}geometry/{*}mesh")
    source_id = mesh.find("{*}vertices/{*}input[@semantic='POSITION']").get("source")[1:]
    numbers = [float(x) for x in mesh.find(f"{{*}}source[@id='{source_id}']/{{*}}float_array").text.split()]
    positions = [numbers[i:i + 3] for i in range(0, len(numbers), 3)]
    polygons = []
    for group in list(mesh.iter()):
        if group.tag.split("}")[1] not in ("polylist", "triangles"):
            continue
        inputs = group.findall("{*}input")
        stride = 1 + max(int(i.get("offset")) for i in inputs)
        offset = next(int(i.get("offset")) for i in inputs if i.get("semantic") == "VERTEX")
        indices = [int(x) for x in group.find("{*}p").text.split()][offset::stride]
        counts = group.find("{*}vcount")
        sizes = [int(x) for x in counts.text.split()] if counts is not None else [3] * int(group.get("count"))
        at = 0
        for size in sizes:
            polygons.append(indices[at:at + size])
            at += size
    return positions, polygons


def node_matrix(root):
    text = root.find(".//{*}visual_scene/{*}node/{*}matrix")
    if text is None:
        return IDENTITY
    m = [float(x) for x in text.text.split()]
    return [m[i:i + 4] for i in range(0, 16, 4)]


def to_millimetres_z_up(root, positions, matrix):
    unit = root.find("{*}asset/{*}unit")
    scale = 1000 * float(unit.get("meter", 1)) if unit is not None else 1000.0
    axis = root.find("{*}asset/{*}up_axis")
    y_up = axis is not None and axis.text.strip() == "Y_UP"
    result = []
    for p in positions:
        x, y, z = (scale * sum(row[k] * c for k, c in enumerate([*p, 1])) for row in matrix[:3])
        result.append((x, -z, y) if y_up else (x, y, z))
    return result


def parts(count, polygons):
    """The polygons of each connected part, largest part first."""
    parent = list(range(count))

    def find(i):
        while parent[i] != i:
            parent[i] = parent[parent[i]]
            i = parent[i]
        return i

    for polygon in polygons:
        for i in polygon[1:]:
            parent[find(i)] = find(polygon[0])
    groups = {}
    for polygon in polygons:
        groups.setdefault(find(polygon[0]), []).append(polygon)
    return sorted(groups.values(), key=lambda g: (-len(g), min(g)))


def write_obj(path, comment, positions, polygons):
    used = sorted({i for polygon in polygons for i in polygon})
    number = {old: new + 1 for new, old in enumerate(used)}
    with open(path, "w", encoding="utf-8", newline="\n") as out:
        out.writelines(f"# {line}\n" for line in comment.split("\n"))
        out.writelines("v {:.3f} {:.3f} {:.3f}\n".format(*positions[i]) for i in used)
        out.writelines("f " + " ".join(str(number[i]) for i in polygon) + "\n" for polygon in polygons)


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("input")
    arguments.add_argument("output")
    arguments.add_argument("--part", type=int, default=0)
    arguments.add_argument("--ignore-node-matrix", action="store_true")
    arguments.add_argument("--comment", default="converted from COLLADA, mm, z up")
    options = arguments.parse_args()

    root = ElementTree.parse(options.input).getroot()
    positions, polygons = read_mesh(root)
    matrix = IDENTITY if options.ignore_node_matrix else node_matrix(root)
    positions = to_millimetres_z_up(root, positions, matrix)
    part = parts(len(positions), polygons)[options.part]
    write_obj(options.output, options.comment, positions, part)


if __name__ == "__main__":
    main()
