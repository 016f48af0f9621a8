#!/usr/bin/env python3
"""Makes the samples armchair-scan and car-seat-scan: finished designs, fitted to scans of their true surfaces.

    make_scans.py ARMCHAIR_BODY.json ARMCHAIR.obj ARMCHAIR_SCAN.ply CAR_SEAT_SCAN.ply

Run make_car_seat.py first: its layout is used.
"""

import shutil
import sys

from designfile import SAMPLES, read, tell_apart, write
from layout import Layout
from turn import turn_ply

# Unfolded, as seen from the front.
ROWS = [
    [("Top of back", 180)],
    [("Back side left", -90), ("Inside back", 180), ("Back side right", 90)],
    [("Seat", 180)],
    [("Front band", 0)],
    [("Underside", 0)],
]


def add_scan(elements, file):
    number = max(e["id"] for e in elements) + 1
    elements.append({"id": number, "kind": "scan", "name": "Scan", "file": file})


def make(name, elements, edge_length, *files):
    write(SAMPLES / name / f"{name}.json", elements, edge_length)
    for file, target in files:
        shutil.copyfile(file, SAMPLES / name / target)


def main():
    body, frame, armchair_scan, car_seat_scan = sys.argv[1:5]
    design = read(body)
    tell_apart(design["elements"])
    Layout(design["elements"]).stack(ROWS, 0, 0)
    add_scan(design["elements"], "armchair-scan.ply")
    make("armchair-scan", design["elements"], 12, (frame, "armchair.obj"), (armchair_scan, "armchair-scan.ply"))

    seat = read(SAMPLES / "car-seat" / "car-seat.json")["elements"]
    elements = [e for e in seat if e["kind"] != "frame"]  # the cover hides it
    add_scan(elements, "car-seat-scan.ply")
    make("car-seat-scan", elements, 12)
    turn_ply(car_seat_scan, SAMPLES / "car-seat-scan" / "car-seat-scan.ply")  # as the design was


if __name__ == "__main__":
    main()
