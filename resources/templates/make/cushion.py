#!/usr/bin/env python3
"""Box cushion of 500 x 500 x 100 mm: two panels, a boxing with a zip behind, piping on both seams."""

from common import Design, Outline, rectangle, ring
from math import pi

WIDTH, HEIGHT, RADIUS = 500, 100, 50
BACK = 60            # so far the zip reaches round the rear corners along the sides


def panel():
    """The sides are divided where the zip begins; the outline starts there, on the right, and runs by the rear."""
    x, r = WIDTH / 2, RADIUS
    y = x - r - BACK
    return (Outline(x, y).line("zip right", x, x - r).quarter("rear right", x - r, x).line("rear", r - x, x)
            .quarter("rear left", -x, x - r).line("zip left", -x, y)
            .line("left", -x, r - x).quarter("front left", r - x, -x).line("front", x - r, -x)
            .quarter("front right", x, r - x).line("right", x, y))


def strip(length):
    """The boxing, its ends divided where the zip is."""
    return (Outline(0, 0).line("front", length, 0).line("right lower", length, HEIGHT / 2)
            .line("right upper", length, HEIGHT).line("rear", 0, HEIGHT).line("left upper", 0, HEIGHT / 2)
            .line("left lower", 0, 0))


def main():
    d = Design("cushion", 16, notch_spacing=200)
    blue, sand = d.fabric("Weave, blue", 10), d.fabric("Weave, oatmeal", 10)
    cognac = d.fabric("Leather, cognac", 10)
    piping = {"piping_radius_mm": 4.5, "piping_fabric": sand}
    top = d.patch("Top panel", panel(), blue, 0.11)
    bottom = d.twin(top, "Bottom panel")

    corner = pi / 2 * RADIUS
    straight = WIDTH - 2 * RADIUS
    rear = straight + 2 * corner + 2 * BACK
    front = straight + 2 * corner + 2 * (straight - BACK)
    boxing = d.patch("Boxing front", strip(front), blue, 0.11)
    upper = d.patch("Boxing zip upper", rectangle(rear, HEIGHT / 2), blue, 0.11)
    lower = d.patch("Boxing zip lower", rectangle(rear, HEIGHT / 2), blue, 0.11)

    d.seam((top, "left", "right"), (boxing, "rear"), piping)
    d.seam((bottom, "left", "right"), (boxing, "front"), piping)
    d.seam((top, "zip right", "zip left"), (upper, "rear"), piping)
    d.seam((bottom, "zip right", "zip left"), (lower, "front"), piping)
    d.seam((upper, "front"), (lower, "rear"), {"stitch": "twin", "thread": "#9fb0c2"}, continuity="G1", zip=True)
    for zip_, half in ((upper, "upper"), (lower, "lower")):
        d.seam((boxing, f"right {half}"), (zip_, "left"))
        d.seam((boxing, f"left {half}"), (zip_, "right"))
    d.hold("Rest on the seat", bottom, ring(0, 0, 70), [(-x, y, 0) for x, y in ring(0, 0, 70)])
    d.layout([(top, 0), (bottom, 0)], [(boxing, 0)], [(upper, 0)], [(lower, 0)])
    d.colourway("Oatmeal", sand)
    d.colourway("Cognac leather", cognac)
    d.write()


if __name__ == "__main__":
    main()
