#!/usr/bin/env python3
"""Turns designs and PLY files by half a turn about z, for the scripts that make the samples: data that face +y then
face the viewer of the view from the front.

    turn.py SURFACE.ply TURNED.ply
"""

import re
import struct
import sys
from pathlib import Path

from designfile import tidy


def half_turn(elements):
    """Curves and frames of a design; patches, which have no place of their own, go along with them."""
    def turned(point):
        return [tidy(-point[0], 6), tidy(-point[1], 6), point[2]]

    for element in elements:
        if element["kind"] == "fixation_curve":
            element["curve"]["points"] = [turned(p) for p in element["curve"]["points"]]
        elif element["kind"] == "frame":
            w, x, y, z = element["rotation"]
            element["rotation"] = [tidy(value, 8) for value in (-z, -y, x, w)]
            element["position"] = turned(element["position"])


def turn_ply(source, target):
    """Binary, with x, y and z as floats for its vertices and nothing else; a comment may name points."""
    data = Path(source).read_bytes()
    start = data.index(b"end_header\n") + len(b"end_header\n")
    header = data[:start].decode("ascii")
    header = re.sub(r"\((-?[\d.]+) (-?[\d.]+) (-?[\d.]+)\)",
                    lambda m: f"({tidy(-float(m[1]))} {tidy(-float(m[2]))} {m[3]})", header)
    count = int(re.search(r"element vertex (\d+)", header)[1])
    values = list(struct.unpack_from(f"<{3 * count}f", data, start))
    values[0::3] = [-x for x in values[0::3]]
    values[1::3] = [-y for y in values[1::3]]
    rest = data[start + 12 * count:]
    Path(target).write_bytes(header.encode("ascii") + struct.pack(f"<{3 * count}f", *values) + rest)


if __name__ == "__main__":
    turn_ply(sys.argv[1], sys.argv[2])
