#!/usr/bin/env python3
"""Makes the pillow sample: two patches sewn all round and inflated, beside a real pillow.

    make_pillow.py aws_Pillow_01_visual.DAE
"""

import subprocess
import sys
from math import cos, radians, sin
from pathlib import Path

from designfile import SAMPLES, seam, stretch, tidy, write
from layout import GAP

COMMENT = """One of four pillows of aws_Pillow_01_visual.DAE, converted to millimetres and z up.
aws-robomaker-small-house-world, Copyright 2019 Amazon.com, Inc. or its affiliates. Licence: MIT-0"""
LEAN = -57.8  # degrees about x: the real pillow leans against a sofa, here it lies
BESIDE = 680  # mm to the right of the sewn one


def outline(width, height, hollow):
    """A rectangle whose sides are a little hollow, so that the inflated corners do not stick out."""
    corners = [(0, 0), (width, 0), (width, height), (0, height)]
    inwards = [(0, 1), (-1, 0), (0, -1), (1, 0)]
    points = []
    for (a, b), (dx, dy) in zip(zip(corners, corners[1:] + corners[:1]), inwards):
        depth = 4 / 3 * hollow  # of the inner control points: the curve reaches three quarters of it
        points.append(list(a))
        for k in (1, 2):
            points.append([tidy(a[0] + (b[0] - a[0]) * k / 3 + dx * depth),
                           tidy(a[1] + (b[1] - a[1]) * k / 3 + dy * depth)])
    return {"degree": 3, "closed": True, "points": points, "corners": [0, 3, 6, 9]}


def lying_frame(path):
    """Position that centres the turned mesh beside the cover, and its rotation."""
    points = [[float(x) for x in line.split()[1:]] for line in path.read_text(encoding="utf-8").splitlines()
              if line.startswith("v ")]
    c, s = cos(radians(LEAN)), sin(radians(LEAN))
    turned = [(x, c * y - s * z, s * y + c * z) for x, y, z in points]
    centre = [(min(axis) + max(axis)) / 2 for axis in zip(*turned)]
    rotation = [tidy(cos(radians(LEAN / 2)), 8), tidy(sin(radians(LEAN / 2)), 8), 0, 0]
    return [tidy(BESIDE - centre[0], 1), tidy(-centre[1], 1), tidy(-centre[2], 1)], rotation


def main():
    folder = SAMPLES / "pillow"
    folder.mkdir(exist_ok=True)
    mesh = folder / "pillow.obj"
    subprocess.run([sys.executable, Path(__file__).with_name("dae_to_obj.py"), sys.argv[1], mesh, "--part", "1",
                    "--comment", COMMENT], check=True)
    position, rotation = lying_frame(mesh)

    width, height, pressure = 600, 375, 0.35
    elements = [
        {"id": 1, "kind": "fabric", "name": "Linen", "poisson": 0.3, "stiffness": 1, "bending_length": 5,
         "color": "#b9a27c"},
        {"id": 2, "kind": "patch", "name": "Front", "fabric": 1, "position": [0, 0], "pressure": pressure,
         "outline": outline(width, height, 15)},
        {"id": 3, "kind": "patch", "name": "Back", "fabric": 1, "position": [width + GAP, 0], "pressure": pressure,
         "outline": outline(width, height, 15)},
    ]
    # The back is seen from behind: its left edge belongs to the right edge of the front.
    corner = [0, 3, 6, 9, 12]
    for i, k in enumerate((0, 3, 2, 1)):
        elements.append(seam(4 + i, stretch(2, corner[i], corner[i + 1]), stretch(3, corner[k], corner[k + 1])))
    elements.append({"id": 8, "kind": "frame", "name": "Real pillow", "file": mesh.name, "scale": 1,
                     "position": position, "rotation": rotation,
                     "material": {"kind": "foam", "color": "#d9cfbd"}})
    write(folder / "pillow.json", elements, 12)


if __name__ == "__main__":
    main()
