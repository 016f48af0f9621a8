#!/usr/bin/env python3
"""Makes the armchair sample: closes the rear of a cover of 17 patches and arranges its layout.

    make_armchair.py COVER.json FRAME.obj

COVER.json is the cover without its outside back. Its rear edges are fixed and lie nearly in one plane, so the
new patches are the loops of those edges, laid flat: each edge keeps its B-spline, and so its length.
"""

import shutil
import sys
from math import dist

from bspline import BSpline, part_of
from designfile import SAMPLES, read, stretch, tell_apart, tidy, write
from layout import GAP, Layout

REAR_UP = (0, 0.2164, 0.9763)  # in the rear plane, upward; the plane leans back
REAR_RIGHT = (-1, 0, 0)        # to the right for somebody who stands behind the chair

# The rear edges around each new patch, counter-clockwise from behind: a fixation seam of the cover whose stretch
# is sewn on (it runs the other way); one of which a part of the curve is shared, because its stretch is sewn
# already (the inner edges of the arms, down to the underside); or None for a straight side.
OUTSIDE_BACK = [(35, None), (39, None), None, (72, (0, 7)), None, (61, None), None, (88, (1, 8)), None, (43, None)]
ARM_RIGHT_REAR = [(72, None), (79, None), (68, None), (81, None)]
ARM_LEFT_REAR = [(97, None), (85, None), (95, None), (88, None)]


def to_plane(point):
    return [sum(a * p for a, p in zip(axis, point)) for axis in (REAR_RIGHT, REAR_UP)]


class Cover:
    """The elements of the design, and the next free id."""

    def __init__(self, form):
        self.edge_length = form["settings"]["edge_length"]
        self.elements = {e["id"]: e for e in form["elements"]}

    def add(self, element):
        element = {"id": max(self.elements) + 1, **element}
        self.elements[element["id"]] = element
        return element["id"]

    def close_rear(self, name, edges, gap_name=None, pressure=0):
        """Adds a patch bounded by these rear edges and joins it to them."""
        controls = [self.controls(edge) for edge in edges]
        for i, side in enumerate(controls):
            if side is None:
                a, b = controls[i - 1][-1], controls[(i + 1) % len(controls)][0]
                controls[i] = [[tidy(p + (q - p) * k / 3, 4) for p, q in zip(a, b)] for k in range(4)]

        flat, corners = [], []
        for side in controls:
            corners.append(len(flat))
            flat += [to_plane(p) for p in side[:-1]]
        left, low = min(p[0] for p in flat), min(p[1] for p in flat)
        points = [[tidy(p[0] - left), tidy(p[1] - low)] for p in flat]
        patch = self.add({"kind": "patch", "name": name, "fabric": 1, "pressure": pressure,
                          "outline": {"degree": 3, "closed": True, "points": points, "corners": corners}})
        for edge, side, start, end in zip(edges, controls, corners, corners[1:] + [len(points)]):
            self.join(patch, stretch(patch, start, end), edge, side, gap_name)

    def controls(self, edge):
        """The control points of a rear edge in 3D, in the direction in which the new outline walks."""
        if edge is None:
            return None
        number, part = edge
        curve = self.elements[self.elements[number]["curve"]]["curve"]
        return part_of(curve, *part) if part else curve["points"][::-1]

    def join(self, patch, own, edge, side, gap_name):
        if edge is None:
            curve = self.add({"kind": "fixation_curve", "name": gap_name,
                              "curve": {"degree": 3, "closed": False, "points": side}})
            self.add({"kind": "fixation_seam", **own, "curve": curve, "reversed": False})
            return
        number, part = edge
        neighbour = self.elements[number]
        if part:
            self.add({"kind": "fixation_seam", **own, "curve": neighbour["curve"], "curve_from": part[0],
                      "curve_to": part[1], "reversed": False})
        else:
            self.add({"kind": "seam", "a": own,
                      "b": stretch(neighbour["patch"], neighbour["from"], neighbour["to"]), "reversed": True,
                      "continuity": "C0"})


def arrange(cover):
    """Unfolded from the outside back down to the underside, with an arm on either side of the seat."""
    back = [[("Outside back", 0)], [("Top of back", 180)],
            [("Back side left", -90), ("Inside back", 180), ("Back side right", 90)]]
    seat = [[("Seat", 180)], [("Front band", 0)], [("Underside", 0)]]
    layout = Layout(cover.elements.values())
    seat_top = layout.stack(back, 0, 0) - GAP
    layout.stack(seat, 0, seat_top)

    def arm(side, outwards):
        front_and_rear = [(f"Arm {side} front", 0), (f"Arm {side} rear", 0)]
        return [[(f"Arm {side} top", outwards)], [(f"Arm {side} outer", outwards)], [(f"Arm {side} underside", outwards)],
                [(f"Arm {side} inner", -outwards)], front_and_rear if side == "right" else front_and_rear[::-1]]

    beside = layout.size("Front band", 0)[0] / 2 + 2 * GAP + layout.size("Arm right outer", 90)[0] / 2
    layout.stack(arm("right", 90), beside, seat_top)
    layout.stack(arm("left", -90), -beside, seat_top)


def report_ease(cover):
    """Every seam of a new patch joins stretches of nearly the same length."""
    for element in cover.elements.values():
        if element["kind"] != "seam":
            continue
        lengths = [BSpline(cover.elements[s["patch"]]["outline"]).stretch_length(s["from"], s["to"])
                   for s in (element["a"], element["b"])]
        ease = max(lengths) / min(lengths) - 1
        if ease > 0.02:
            print(f"seam {element['id']}: ease {100 * ease:.1f} %", file=sys.stderr)


def check_loop(cover, edges):
    for edge, following in zip(edges, edges[1:] + edges[:1]):
        if edge and following:
            gap = dist(cover.controls(edge)[-1], cover.controls(following)[0])
            assert gap < 0.01, (edge, following, gap)


def main():
    cover = Cover(read(sys.argv[1]))
    for edges in (OUTSIDE_BACK, ARM_RIGHT_REAR, ARM_LEFT_REAR):
        check_loop(cover, edges)
    cover.close_rear("Outside back", OUTSIDE_BACK, "Outside back at the arm", pressure=0.04)
    cover.close_rear("Arm right rear", ARM_RIGHT_REAR)
    cover.close_rear("Arm left rear", ARM_LEFT_REAR)
    tell_apart(cover.elements.values())
    for frame in (e for e in cover.elements.values() if e["kind"] == "frame"):
        frame["material"] = {"kind": "foam", "color": "#7d4a2e"}  # its lining, seen where arms and seat meet
    arrange(cover)
    report_ease(cover)
    folder = SAMPLES / "armchair"
    write(folder / "armchair.json", cover.elements.values(), cover.edge_length)
    shutil.copyfile(sys.argv[2], folder / "armchair.obj")


if __name__ == "__main__":
    main()
