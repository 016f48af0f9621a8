#!/usr/bin/env python3
"""Bench of 1200 x 400 mm: a seat of three panels over foam with a round front edge, two sides with piping, stapled below."""

from common import Design, Mesh, Outline, length_of, mirrored, rectangle, rounded

LENGTH, DEPTH = 1200, 400
LOW, TOP = 378, 458            # lower edge of the board, upper edge of the foam
CROWN, FRONT_RADIUS, REAR_RADIUS = 12, 48, 22
STAPLED = 40                   # mm of cloth that are turned under the board


# From the rear lower edge over the seat to the front lower edge: y and z.
PROFILE = [(DEPTH / 2, LOW), (DEPTH / 2, TOP), (0, TOP + CROWN), (-DEPTH / 2, TOP), (-DEPTH / 2, LOW)]
RADII = [REAR_RADIUS, 900, FRONT_RADIUS]


def frame(d):
    wood = Mesh()
    for name, y in (("front", -1), ("rear", 1)):
        for side, x in (("left", -1), ("right", 1)):
            top, foot = (x * 505, y * 142, LOW - 2), (x * 528, y * 160, 0)
            path = [tuple(a + (b - a) * t for a, b in zip(top, foot)) for t in (0, 0.12, 0.3, 0.6, 0.85, 1)]
            wood.tube(f"Leg {name} {side}", path, lambda t: 23 - 10 * t, 28, 2.5)
        wood.block(f"Rail {name}", (0, y * 146, LOW - 30), (980, 20, 50), 3)
    for side, x in (("left", -1), ("right", 1)):
        wood.block(f"Rail {side}", (x * 509, 0, LOW - 30), (20, 250, 50), 3)
    wood.block("Board", (0, 0, LOW + 9), (LENGTH - 8, DEPTH - 8, 17), 2)
    foam, inset = Mesh(), 2
    line = [(y * (1 - 2 * inset / DEPTH), max(z - inset, LOW + 19)) for y, z in rounded(PROFILE, RADII, 6)]
    foam.loft("Foam", [[(x, y, z) for y, z in reversed(line)] for x in (inset - LENGTH / 2, LENGTH / 2 - inset)])
    d.frame("Wood", wood, "wood", "#b58a5c")
    d.frame("Foam", foam, "foam")


def main():
    d = Design("bench", 14, notch_spacing=200, symmetric=True)
    grey, petrol, cognac = (d.fabric(name, 5) for name in ("Weave, grey", "Velvet, petrol", "Leather, cognac"))
    line = rounded(PROFILE, RADII, 4)
    x = LENGTH / 2
    girth, third, pressure = length_of(line), LENGTH / 3, 0.01
    middle = d.patch("Seat middle", rectangle(third, girth), grey, pressure)
    seat = {"right": d.patch("Seat right", rectangle(third, girth), grey, pressure)}
    seat["left"] = d.twin(seat["right"], "Seat left")
    # Seen from the right, where the rear lies to the right.
    side = Outline(*PROFILE[-1]).line("bottom", *PROFILE[0]).round("around", PROFILE[1:], RADII)
    end = {"right": d.patch("Side right", side, grey, pressure)}
    end["left"] = d.twin(end["right"], "Side left")

    stitched = {"stitch": "twin", "thread": "#c3c5c7", "stitch_distance_mm": 5}
    for s in ("right", "left"):
        d.seam((middle, s), (seat[s], "left"), stitched)
        d.seam((seat[s], "right"), (end[s], "around"), {"piping_radius_mm": 4})
    for edge, (y, z), way in (("front", line[-1], 1), ("rear", line[0], -1)):
        d.fix(f"Board {edge} middle", (middle, edge), [(-way * third / 2, y, z), (way * third / 2, y, z)])
        right = d.fix(f"Board {edge} right", (seat["right"], edge), [(x - third, y, z), (x, y, z)][::way])
        d.fix_twin(f"Board {edge} left", right, seat["left"])
    tied = [(third / 2, y, z) for y, z in line]  # seams lie in channels of the foam
    d.fix("Channel right", (middle, "right"), tied[::-1], 36)
    d.fix("Channel left", (middle, "left"), mirrored(tied), 36)
    edge = d.fix("Edge right", (seat["right"], "right"), [(x, y, z) for y, z in reversed(line)], 36)
    d.fix_twin("Edge left", edge, seat["left"])
    right = d.fix("Board right", (end["right"], "bottom"), [(x, *line[-1]), (x, *line[0])])
    d.fix_twin("Board left", right, end["left"])
    for patch in (middle, *seat.values()):
        for edge in ("front", "rear"):
            d.add("edge_allowance", **d.stretch(patch, edge), width_mm=STAPLED)
    for patch in end.values():
        d.add("edge_allowance", **d.stretch(patch, "bottom"), width_mm=STAPLED)
    frame(d)
    d.layout([(end["left"], 90), (seat["left"], 0), (middle, 0), (seat["right"], 0), (end["right"], -90)])
    d.colourway("Petrol velvet", petrol)
    d.colourway("Cognac leather", cognac)
    d.write()


if __name__ == "__main__":
    main()
