"""Arranges the patches of a design on the layout, for the scripts that make the samples."""

from math import cos, radians, sin

from bspline import BSpline
from designfile import tidy

GAP = 40  # between neighbours, mm


def turned(point, degrees):
    c, s = cos(radians(degrees)), sin(radians(degrees))
    return c * point[0] - s * point[1], s * point[0] + c * point[1]


class Layout:
    def __init__(self, elements):
        self.patches = {e["name"]: e for e in elements if e["kind"] == "patch"}

    def box(self, name, rotation):
        """Lower left and upper right corner of a patch turned by so many degrees, its origin at (0, 0)."""
        outline = BSpline(self.patches[name]["outline"])
        points = [turned(p, rotation) for p in outline.sample(400)]
        return [min(c) for c in zip(*points)], [max(c) for c in zip(*points)]

    def size(self, name, rotation):
        low, high = self.box(name, rotation)
        return high[0] - low[0], high[1] - low[1]

    def place(self, name, rotation, x, y):
        """Turns a patch and puts the lower left corner of its box at (x, y); the grain stays upright."""
        low, _ = self.box(name, rotation)
        patch = self.patches[name]
        patch["position"] = [tidy(x - low[0], 1), tidy(y - low[1], 1)]
        patch["rotation"] = tidy(rotation, 1)
        patch["grain"] = tidy((90 - rotation) % 180, 1)

    def stack(self, rows, centre, top):
        """Rows of patches (name, rotation) below each other, each row centred; returns where it ends."""
        for row in rows:
            sizes = [self.size(name, rotation) for name, rotation in row]
            x = centre - (sum(size[0] for size in sizes) + GAP * (len(row) - 1)) / 2
            height = max(size[1] for size in sizes)
            for (name, rotation), size in zip(row, sizes):
                self.place(name, rotation, x, top - (height + size[1]) / 2)
                x += size[0] + GAP
            top -= height + GAP
        return top + GAP
