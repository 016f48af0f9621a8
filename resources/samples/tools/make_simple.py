#!/usr/bin/env python3
"""Makes the samples that are drawn from a few numbers: trapezoid, trapezoid-cushion, cylinder, box-cushion."""

from math import cos, pi, sin, sqrt

from bspline import BSpline
from designfile import SAMPLES, polygon, rectangle, seam, stretch, tidy, write


def trapezoid():
    """The paper's Figure 10: a square sewn to a trapezoid, so that the cloth folds below."""
    size, lower = 400, 240
    slant = (size - lower) / 2
    height = sqrt(size**2 - slant**2)  # the slanted sides keep the length of the cloth
    corners = [(-lower / 2, 0, 0), (lower / 2, 0, 0), (size / 2, 0, height), (-size / 2, 0, height)]
    corners = [[tidy(c) for c in corner] for corner in corners]
    elements = [
        {"id": 1, "kind": "fabric", "name": "Soft leather", "poisson": 0.3, "stiffness": 1, "bending_length": 2,
         "color": "#a8743f"},
        {"id": 2, "kind": "patch", "name": "Square", "fabric": 1, "outline": rectangle(size, size)},
        {"id": 3, "kind": "fixation_curve", "name": "Trapezoid", "curve": polygon(*corners)},
    ]
    for side in range(4):
        elements.append({"id": 4 + side, "kind": "fixation_seam", **stretch(2, side, side + 1), "curve": 3,
                         "curve_from": side, "curve_to": side + 1})
    write(SAMPLES / "trapezoid" / "trapezoid.json", elements, 5)
    trapezoid_cushion(elements, height)


def trapezoid_cushion(elements, height):
    """The same, bolstered by a cube. The cloth hangs in front of the cube's middle: there is no way out of that."""
    size, offset = 180, 40
    half = size / 2
    low, high = [-half, offset - half, height / 2 - half + 20], [half, offset + half, height / 2 + half + 20]
    corners = [[(low, high)[n >> axis & 1][axis] for axis in range(3)] for n in range(8)]
    faces = [(1, 5, 7, 3), (2, 4, 8, 6), (1, 2, 6, 5), (3, 7, 8, 4), (1, 3, 4, 2), (5, 6, 8, 7)]
    text = "g Cube\n" + "".join(f"v {tidy(x)} {tidy(y)} {tidy(z)}\n" for x, y, z in corners)
    text += "".join("f " + " ".join(map(str, face)) + "\n" for face in faces)
    folder = SAMPLES / "trapezoid-cushion"
    write(folder / "trapezoid-cushion.json", elements + [
        {"id": 8, "kind": "frame", "name": "Cube", "file": "cube.obj"},
        {"id": 9, "kind": "cushion", "name": "Padding", "frame": 8, "dilation_mm": 20},
    ], 5)
    (folder / "cube.obj").write_text(text, encoding="utf-8", newline="\n")


def circle(circumference, height, count=24):
    """A closed uniform cubic that is a circle within a micrometre, from the rear, counter-clockwise from above."""
    def curve(radius):
        angles = [pi / 2 + 2 * pi * i / count for i in range(count)]
        return {"degree": 3, "closed": True,
                "points": [[tidy(radius * cos(a), 6), tidy(radius * sin(a), 6), height] for a in angles]}

    radius = circumference / (2 * pi) * 6 / (4 + 2 * cos(2 * pi / count))
    reached = BSpline(curve(radius)).stretch_length(0, 0)
    return curve(radius * circumference / reached)


def cylinder():
    """A rectangle sewn into a tube and fixed at both rims, the right side outside."""
    width, height = 600, 400
    write(SAMPLES / "cylinder" / "cylinder.json", [
        {"id": 1, "kind": "fabric", "name": "Canvas", "poisson": 0.3, "stiffness": 1, "bending_length": 5,
         "color": "#5f7386"},
        {"id": 2, "kind": "patch", "name": "Tube", "fabric": 1, "outline": rectangle(width, height)},
        seam(3, stretch(2, 1, 2), stretch(2, 3, 4)),
        {"id": 4, "kind": "fixation_curve", "name": "Lower rim", "curve": circle(width, 0)},
        {"id": 5, "kind": "fixation_seam", **stretch(2, 0, 1), "curve": 4},
        {"id": 6, "kind": "fixation_curve", "name": "Upper rim", "curve": circle(width, height)},
        {"id": 7, "kind": "fixation_seam", **stretch(2, 2, 3), "curve": 6, "reversed": True},
    ], 8)


def box_cushion():
    """A top and four sides, laid out unfolded; the bottom is open and fixed along its edge."""
    size, height, gap, pressure = 500, 100, 40, 0.3
    half = size / 2
    sides = [("Front", (0, -gap - height), 0), ("Right", (size + gap + height, 0), 90),
             ("Rear", (size, size + gap + height), 180), ("Left", (-gap - height, size), -90)]
    elements = [
        {"id": 1, "kind": "fabric", "name": "Upholstery fabric", "poisson": 0.3, "stiffness": 1, "bending_length": 12,
         "color": "#8a4b3c"},
        {"id": 2, "kind": "patch", "name": "Top", "fabric": 1, "position": [0, 0], "pressure": pressure,
         "outline": rectangle(size, size)},
    ]
    bottom = [(-half, -half, 0), (half, -half, 0), (half, half, 0), (-half, half, 0)]
    elements.append({"id": 7, "kind": "fixation_curve", "name": "Bottom edge",
                     "curve": polygon(*[[tidy(c) for c in p] for p in bottom])})
    for i, (name, position, rotation) in enumerate(sides):
        patch, following = 3 + i, 3 + (i + 1) % 4
        elements += [
            {"id": patch, "kind": "patch", "name": name, "fabric": 1, "position": list(position), "rotation": rotation,
             "pressure": pressure, "outline": rectangle(size, height)},
            {"id": 8 + i, "kind": "fixation_seam", **stretch(patch, 0, 1), "curve": 7, "curve_from": i,
             "curve_to": i + 1},
            seam(12 + i, stretch(2, i, i + 1), stretch(patch, 2, 3)),
            seam(16 + i, stretch(patch, 1, 2), stretch(following, 3, 4)),
        ]
    write(SAMPLES / "box-cushion" / "box-cushion.json", elements, 12)


if __name__ == "__main__":
    trapezoid()
    cylinder()
    box_cushion()
