#!/usr/bin/env python3
"""Makes the car seat sample: arranges the layout of a finished design.

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
    folder = SAMPLES / "car-seat"
    write(folder / "car-seat.json", design["elements"], design["settings"]["edge_length"])
    shutil.copyfile(sys.argv[2], folder / "car-seat-frame.obj")


if __name__ == "__main__":
    main()
