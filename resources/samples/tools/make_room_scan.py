#!/usr/bin/env python3
"""Makes the sample room-scan: a sling cover on the cantilever chair of a scanned living room.

    make_room_scan.py livingroom_fragment_002.ply

The file is in metres, as the camera saw it: x to the right, y down, z away. Only what stands within 0.65 m of the
chair is kept, so that floor and wall remain to be cut away.
"""

import math
import re
import struct
import sys

from bspline import BSpline
from designfile import SAMPLES, rectangle, seam, stretch, tidy, write

MIDDLE = (0.13, 0.352, 1.3)  # on the floor below the chair, metres in the file
TURN = math.radians(17)      # of the chair about the vertical
LEFT, RIGHT = -280, 170      # the sling's rails, mm

# The chair's profile from the front lip to the crease and on to the top: depth and height, mm, read off the scan.
SEAT = [(-321, 320), (-344, 335), (-350, 365), (-336, 402), (-310, 420), (-265, 417), (-180, 405), (-60, 388), (60, 374)]
BACK = [(60, 374), (108, 386), (165, 424), (222, 482), (266, 545), (293, 620), (304, 700), (296, 780), (297, 838)]


def read_points(path):
    with open(path, "rb") as file:
        header, body = file.read().split(b"end_header\n", 1)
    count = int(re.search(rb"element vertex (\d+)", header).group(1))
    row = struct.Struct("<dddBBB")
    return [row.unpack_from(body, i * row.size)[:3] for i in range(count)]


def axes():
    """The chair's axes in the file: to the right, to the back, up."""
    c, s = math.cos(TURN), math.sin(TURN)
    return (c, 0, -s), (s, 0, c), (0, -1, 0)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def near(point):
    offset = [p - m for p, m in zip(point, MIDDLE)]
    right, back, up = (dot(axis, offset) for axis in axes())
    return abs(right) < 0.65 and abs(back) < 0.65 and up < 1.1


def write_points(path, points):
    header = ("ply\nformat binary_little_endian 1.0\ncomment metres; y down; a part of livingroom_fragment_002.ply\n"
              f"element vertex {len(points)}\nproperty float x\nproperty float y\nproperty float z\nend_header\n")
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(header.encode() + b"".join(struct.pack("<fff", *p) for p in points))


def placement():
    """Scale, position and rotation that bring the file's axes to the design's."""
    rows = axes()
    position = [tidy(-1000 * dot(row, MIDDLE), 2) for row in rows]
    w = 0.5 * math.sqrt(1 + rows[0][0] + rows[1][1] + rows[2][2])
    x, y, z = ((rows[2][1] - rows[1][2]) / (4 * w), (rows[0][2] - rows[2][0]) / (4 * w),
               (rows[1][0] - rows[0][1]) / (4 * w))
    return {"scale": 1000, "position": position, "rotation": [round(q, 12) for q in (w, x, y, z)]}


def cuts():
    """The floor, and everything outside a box around seat and back."""
    def plane(axis, side, distance):  # points with side * axis . (p - MIDDLE) <= distance
        normal = [side * a for a in axis]
        return [tidy(v, 6) for v in (*normal, distance + dot(normal, MIDDLE))]
    right, back, up = axes()
    box = [plane(right, 1, 0.175), plane(right, -1, 0.285), plane(back, 1, 0.33), plane(back, -1, 0.36),
           plane(up, 1, 0.86), plane(up, -1, -0.31)]
    return [{"planes": [plane(up, 1, 0.03)]}, {"planes": box, "keep": True}]


def rail(points, x):
    return {"degree": 3, "closed": False, "points": [[x, *p] for p in points]}


def across(point):
    return {"degree": 1, "closed": False, "points": [[LEFT, *point], [RIGHT, *point]]}


def length(points):
    line = BSpline({"degree": 3, "closed": False, "points": [list(p) for p in points]}).sample(2000)
    return sum(math.dist(a, b) for a, b in zip(line, line[1:]))


def elements():
    width, seat, back = RIGHT - LEFT, tidy(length(SEAT), 1), tidy(length(BACK), 1)
    curves = [("Front lip", across(SEAT[0])), ("Seat rail right", rail(SEAT, RIGHT)), ("Seat rail left", rail(SEAT, LEFT)),
              ("Back rail right", rail(BACK, RIGHT)), ("Back rail left", rail(BACK, LEFT)), ("Top", across(BACK[-1]))]
    made = [{"id": 1, "kind": "fabric", "name": "Canvas", "poisson": 0.2, "bending_length": 5, "color": "#8a8f6a"},
            {"id": 2, "kind": "patch", "name": "Seat", "fabric": 1, "position": [0, 0],
             "outline": rectangle(width, seat)},
            {"id": 3, "kind": "patch", "name": "Back", "fabric": 1, "position": [0, tidy(seat + 60)],
             "outline": rectangle(width, back)},
            seam(4, stretch(2, 2, 3), stretch(3, 0, 1))]
    made += [{"id": 10 + i, "kind": "fixation_curve", "name": name, "curve": curve}
             for i, (name, curve) in enumerate(curves)]
    fixed = [(2, 0, 10, False), (2, 1, 11, False), (2, 3, 12, True), (3, 1, 13, False), (3, 3, 14, True), (3, 2, 15, True)]
    for i, (patch, edge, curve, backwards) in enumerate(fixed):
        made.append({"id": 20 + i, "kind": "fixation_seam", "patch": patch, "from": edge, "to": edge + 1, "curve": curve,
                     "reversed": backwards})
    made.append({"id": 30, "kind": "scan", "name": "Living room", "file": "room.ply", **placement(),
                 "threshold_mm": 50, "cuts": cuts()})
    return made


def main():
    folder = SAMPLES / "room-scan"
    write_points(folder / "room.ply", [p for p in read_points(sys.argv[1]) if near(p)])
    write(folder / "room-scan.json", elements(), 12)


if __name__ == "__main__":
    main()
