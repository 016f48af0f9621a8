#!/usr/bin/env python3
"""Makes the car seat samples: arranges the layout of a finished design; a second one with cushioning.

    make_car_seat.py DESIGN.json FRAME.obj
"""

import shutil
import sys

from designfile import SAMPLES, read, write
from layout import Layout

# Unfolded, as seen from the front: the back above the cushion, front down. The cushion's "right" is named by the
# sitter, that of the back by the viewer, so they lie on opposite sides.
ROWS = [
    [("Back top", 180)],
    [("Back side left", -26), ("Back bolster left", 0), ("Back insert", 0), ("Back bolster right", 0),
     ("Back side right", 26)],
    [("Back bottom", 0)],
    [("Cushion rear", 180)],
    [("Cushion side right", -90), ("Cushion bolster right", 180), ("Cushion insert", 180), ("Cushion bolster left", 180),
     ("Cushion side left", 90)],
    [("Cushion front", 0)],
]


def main():
    design = read(sys.argv[1])
    Layout(design["elements"]).stack(ROWS, 0, 0)
    elements = design["elements"]
    frame = next(e["id"] for e in elements if e["kind"] == "frame")
    # The frame lies 26 mm inside the foam.
    cushion = {"id": max(e["id"] for e in elements) + 1, "kind": "cushion", "name": "Padding", "frame": frame,
               "dilation_mm": 26}
    for name, more in [("car-seat", []), ("car-seat-cushioned", [cushion])]:
        write(SAMPLES / name / f"{name}.json", elements + more, design["settings"]["edge_length"])
        shutil.copyfile(sys.argv[2], SAMPLES / name / "car-seat-frame.obj")


if __name__ == "__main__":
    main()
