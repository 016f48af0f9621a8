#!/usr/bin/env python3
"""Neck roll of 160 x 450 mm: a body sewn into a tube, with a zip, and two round ends with piping."""

from math import cos, pi, sin

from common import Design, circle, rectangle

RADIUS, LENGTH = 80, 450


def main():
    d = Design("bolster", 10, notch_spacing=80)
    petrol, sand = d.fabric("Velvet, petrol", 8), d.fabric("Weave, oatmeal", 8)
    cognac = d.fabric("Leather, cognac", 8)
    around = 2 * pi * RADIUS
    body = d.patch("Body", rectangle(LENGTH, around), petrol, 0.18)
    left = d.patch("End left", circle(RADIUS), petrol, 0.18)
    right = d.twin(left, "End right")

    piping = {"piping_radius_mm": 4, "piping_fabric": sand}
    d.seam((body, "front"), (body, "rear"), zip=True)
    d.seam((body, "left"), (left, "all"), piping)
    d.seam((body, "right"), (right, "all"), piping)
    for name, side, x in (("left", "left", -LENGTH / 2), ("right", "right", LENGTH / 2)):
        angles = [2 * pi * k / 120 for k in range(121)]  # the zip lies below; from the zip round the outline's way
        way = 1 if name == "left" else -1
        rim = [(x, way * RADIUS * sin(a), RADIUS - RADIUS * cos(a)) for a in angles]
        d.fix(f"Rim {name}", (body, side), rim, 15)
    d.layout([(left, 0), (body, 0), (right, 0)])
    d.colourway("Oatmeal", sand)
    d.colourway("Cognac leather", cognac)
    d.write()


if __name__ == "__main__":
    main()
