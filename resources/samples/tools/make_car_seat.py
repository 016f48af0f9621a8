#!/usr/bin/env python3
"""Makes the car seat samples: arranges the layout of a finished design; a second one with rounded seams and fancy
seams on the inserts; a third one with cushioning.

    make_car_seat.py DESIGN.json FRAME.obj

DESIGN.json faces +y. It is turned to face -y, as everything does that is looked at from the front.
"""

import shutil
import sys

from designfile import SAMPLES, read, tell_apart, write
from layout import Layout
from turn import half_turn

# Unfolded, as seen from the front: the back above the cushion, front down.
ROWS = [
    [("Back top", 180)],
    [("Back side left", -26), ("Back bolster left", 0), ("Back insert", 0), ("Back bolster right", 0),
     ("Back side right", 26)],
    [("Back bottom", 0)],
    [("Cushion rear", 180)],
    [("Cushion side left", -90), ("Cushion bolster left", 180), ("Cushion insert", 180), ("Cushion bolster right", 180),
     ("Cushion side right", 90)],
    [("Cushion front", 0)],
]


FANCY_SEAMS = [  # patch, name, middle and half distance of the two, length of the insert: mm in the pattern
    ("Cushion insert", "Cushion pipe", 143, 46, 499),
    ("Back insert", "Back pipe", 131.5, 43, 590),
]


def name_as_seen(elements):
    """The design calls the cushion's sides as the sitter does, those of the back as one who looks at it: now all do."""
    other = {"left": "right", "right": "left"}
    for element in elements:
        words = element.get("name", "").split()
        if words[:1] == ["Cushion"]:
            element["name"] = " ".join(other.get(word, word) for word in words)


def round_seams(elements):
    """Where a bolster meets its side the cover is round."""
    names = {e["id"]: e["name"] for e in elements if e["kind"] == "patch"}
    for seam in (e for e in elements if e["kind"] == "seam"):
        sides = sorted(names[seam[side]["patch"]].split()[1] for side in "ab")
        if sides == ["bolster", "side"]:
            seam["continuity"] = "G1"


def add_fancy_seams(elements):
    patches = {e["name"]: e["id"] for e in elements if e["kind"] == "patch"}
    number = max(e["id"] for e in elements)
    for patch, name, middle, apart, length in FANCY_SEAMS:
        for side, x in (("left", middle - apart), ("right", middle + apart)):
            number += 1
            elements.append({
                "id": number, "kind": "fancy_seam", "name": f"{name} {side}", "patch": patches[patch],
                "curve": {"degree": 1, "closed": False, "points": [[x, -10], [x, length + 10]]},
                "width": 18, "depth": 6, "profile": "sharp"})


def main():
    design = read(sys.argv[1])
    elements = design["elements"]
    name_as_seen(elements)
    half_turn(elements)
    tell_apart(elements)
    Layout(elements).stack(ROWS, 0, 0)
    edge_length = design["settings"]["edge_length"]
    shell = next(e for e in elements if e["kind"] == "frame")
    shell["material"] = {"kind": "plastic"}
    frame = shell["id"]
    # The frame lies 26 mm inside the foam.
    cushion = {"id": max(e["id"] for e in elements) + 1, "kind": "cushion", "name": "Padding", "frame": frame,
               "dilation_mm": 26}
    for name, more in [("car-seat", []), ("car-seat-cushioned", [cushion])]:
        write(SAMPLES / name / f"{name}.json", elements + more, edge_length)
        shutil.copyfile(sys.argv[2], SAMPLES / name / "car-seat-frame.obj")
    round_seams(elements)
    add_fancy_seams(elements)
    write(SAMPLES / "car-seat" / "car-seat-g1.json", elements, edge_length)


if __name__ == "__main__":
    main()
