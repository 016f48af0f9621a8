#!/usr/bin/env python3
"""Wing chair: an inside back with wings, arms with facings, a seat cushion, outside pieces, legs of wood."""

from math import pi

from common import Design, Mesh, Outline, length_of, mirrored, rectangle, resample, rounded, smooth, unroll

LOW, DECK = 195, 345                       # lower edge of the cover, deck below the seat cushion
FRONT, REAR = -300, 318                    # of the arms
INNER, OUTER, ARM, SEAM = 250, 350, 648, 590   # the arms: from x to x, their top, the seam below the roll outside
SEAT = (496, 422, 106, 40)                 # seat cushion: width, depth, height, radius
CREASE = 598                               # there the wings begin

# The right half, upwards: crease of inside back and wing, front edge of the wing, rear edge of the chair.
BELOW = [(238, 112, 400), (237, 146, CREASE)]
TIE = [(237, 146, CREASE), (231, 205, 880), (222, 246, 1045), (212, 342, 1074)]
TIE_RADII = [600, 55]
WING = [(302, -24, CREASE + 30), (320, -50, 735), (324, -28, 890), (306, 62, 1010), (266, 200, 1074), (230, 342, 1074)]
REAR_LOW = [(OUTER, REAR, LOW), (OUTER, 329, SEAM), (OUTER, 330, CREASE + 22)]
REAR_EDGE = [(OUTER, 330, CREASE + 22), (342, 338, 880), (318, 342, 1010), (252, 342, 1074)]
REAR_RADII = [600, 110]
PIPING = {"piping_radius_mm": 4}
COUNT = 61


def back(d, fabric):
    below, tie = resample(BELOW, 20), resample(rounded(TIE, TIE_RADII, 4), COUNT)
    wing, edge = resample(smooth(WING), COUNT), resample(rounded(REAR_EDGE, REAR_RADII, 4), COUNT)
    low, post = resample(REAR_LOW[:2], 30), resample(REAR_LOW[1:], 5)
    whole, rear = below[:-1] + tie, low[:-1] + post[:-1] + edge

    inside = d.patch("Inside back", unroll(mirrored(whole), whole, (4, 12, 4, 12), None, [len(below) - 1]), fabric, 0.25)
    wings = {"right": d.patch("Inside wing right", unroll(tie, wing, (4, 12, 4, 16), None), fabric, 0.06)}
    wings["left"] = d.twin(wings["right"], "Inside wing left")
    sides = {"right": d.patch("Outside wing right", unroll(wing, edge, (4, 12, 4, 16), None), fabric, 0.03)}
    sides["left"] = d.twin(sides["right"], "Outside wing left")
    width, parts = 2 * rear[-1][0], (edge[-1][0] - wing[-1][0], edge[-1][0] - tie[-1][0])
    parts = [p / width for p in parts]
    outside = d.patch("Outside back", unroll(rear, mirrored(rear), (4, 12, 4, 12), None,
                      [len(low) - 1, len(low) + len(post) - 2], [*parts, *(1 - p for p in reversed(parts))]), fabric, 0.02)
    for s, i, o in (("right", "b 2", "a 3"), ("left", "a 2", "b 3")):
        d.seam((inside, i), (wings[s], "a"), {"allowance_mm": 6})
        d.seam((wings[s], "b"), (sides[s], "a"), PIPING)
        d.seam((sides[s], "b"), (outside, o), PIPING)
        ends = ("end 5", "end 4") if s == "right" else ("end 1", "end 2")
        d.seam((sides[s], "end"), (outside, ends[0]), PIPING)
        d.seam((wings[s], "end"), (outside, ends[1]), PIPING)
    d.seam((inside, "end"), (outside, "end 3"), PIPING)

    for k, line, number in ((1, below, 4), (2, tie, 18)):
        d.fix(f"Crease {k} right", (inside, f"b {k}"), line, number)
        d.fix(f"Crease {k} left", (inside, f"a {k}"), mirrored(line)[::-1], number)
    d.fix("Seat rail, back", (inside, "start"), [mirrored(whole)[0], whole[0]])
    d.fix("Top rail", (outside, "end"), [mirrored(rear)[-1], rear[-1]])
    for k, line, number in ((1, low, 4), (2, post, 4), (3, edge, 16)):
        d.fix(f"Rear post {k} right", (outside, f"a {k}"), line[::-1], number)
        d.fix(f"Rear post {k} left", (outside, f"b {k}"), mirrored(line), number)
    d.fix("Rear rail", (outside, "start"), [rear[0], mirrored(rear)[0]])
    for patch, kind, end, points in ((wings, "Wing", "start", [tie[0], wing[0]]), (wings, "Wing top", "b", wing),
                                     (sides, "Wing outside", "start", [wing[0], edge[0]])):
        fixed = d.fix(f"{kind} right", (patch["right"], end), points, 20)
        d.fix_twin(f"{kind} left", fixed, patch["left"])
    return inside, wings, sides, outside


def arms(d, fabric, outside_back):
    profile = [(INNER, DECK), (INNER, ARM), (OUTER, ARM), (OUTER, SEAM)]
    radii = [49, 49]
    roll = rounded(profile, radii, 4)
    top = REAR_LOW[1][1]
    depth = top - FRONT
    x = length_of(roll)
    arm = {"right": d.patch("Arm right", rectangle(x, depth), fabric, 0.1)}     # from the deck over the roll
    face = (Outline(INNER, LOW).line("bottom", OUTER, LOW).line("outer", *profile[-1])
            .round("roll", profile[-2::-1], radii).line("inner", INNER, LOW))
    facing = {"right": d.patch("Arm facing right", face, fabric, 0.02)}
    flat = (Outline(FRONT, LOW).line("bottom", REAR, LOW).line("rear", top, SEAM).line("top", FRONT, SEAM)
            .line("front", FRONT, LOW))
    outside = {"right": d.patch("Outside arm right", flat, fabric, 0.02)}
    for piece, name in ((arm, "Arm"), (facing, "Arm facing"), (outside, "Outside arm")):
        piece["left"] = d.twin(piece["right"], f"{name} left")
    border = d.patch("Front border", rectangle(2 * INNER, DECK - LOW), fabric, 0.02)
    for s, way in (("right", 1), ("left", -1)):
        middle = way * (ARM - 49 - DECK + 49 * pi / 2)  # along the top of the roll it is tied to the arm's rail
        d.hold_line(f"Arm top {s}", arm[s], (middle, 30), (middle, depth - 30),
                    (way * (INNER + OUTER) / 2, FRONT + 30, ARM), (way * (INNER + OUTER) / 2, FRONT + depth - 30, ARM))
        d.seam((arm[s], "front"), (facing[s], "roll"), PIPING)
        d.seam((facing[s], "outer"), (outside[s], "front"), PIPING)
        d.seam((facing[s], "inner"), (border, s))
        d.seam((arm[s], "right"), (outside[s], "top"))
        d.seam((outside[s], "rear"), (outside_back, "a 1" if s == "right" else "b 1"), PIPING)

    def both(name, piece, edge, points, controls=4):
        fixed = d.fix(f"{name} right", (piece["right"], edge), points, controls)
        d.fix_twin(f"{name} left", fixed, piece["left"])

    def at(y):
        return [(px, y, z) for px, z in roll]

    both("Arm front", arm, "front", at(FRONT), 36)
    both("Arm rear", arm, "rear", at(FRONT + depth)[::-1], 36)
    both("Arm deck", arm, "left", [(INNER, FRONT + depth, DECK), (INNER, FRONT, DECK)])
    both("Arm outside", arm, "right", [(OUTER, FRONT, SEAM), (OUTER, FRONT + depth, SEAM)])
    both("Facing below", facing, "bottom", [(INNER, FRONT, LOW), (OUTER, FRONT, LOW)])
    both("Facing outside", facing, "outer", [(OUTER, FRONT, LOW), (OUTER, FRONT, SEAM)])
    both("Side rail", outside, "bottom", [(OUTER, FRONT, LOW), (OUTER, REAR, LOW)])
    corners = [(-INNER, FRONT, LOW), (INNER, FRONT, LOW), (INNER, FRONT, DECK), (-INNER, FRONT, DECK)]
    for k, edge in enumerate(("front", "right", "rear", "left")):
        d.fix(f"Front rail {k + 1}", (border, edge), [corners[k], corners[(k + 1) % 4]])
    return arm, facing, outside, border


def seat(d, fabric):
    width, depth, height, radius = SEAT
    x, y, middle = width / 2, depth / 2, FRONT + 3 + depth / 2
    half = x - radius - 10
    around = [(-half, y), (-x, y), (-x, -y), (x, -y), (x, y), (half, y)]
    top = d.patch("Seat", Outline(half, y).line("rear", -half, y).round("around", around[1:], [radius] * 4), fabric, 0.08)
    plan = rounded(around, [radius] * 4, 4)
    front = d.patch("Boxing front", rectangle(length_of(plan), height), fabric, 0.03)
    rear = d.patch("Boxing zip", rectangle(2 * half, height), fabric, 0.03)
    d.seam((top, "around"), (front, "rear"), PIPING)
    d.seam((top, "rear"), (rear, "rear"), PIPING)
    d.seam((front, "right"), (rear, "left"))
    d.seam((front, "left"), (rear, "right"))
    d.fix("Deck front", (front, "front"), [(px, py + middle, DECK) for px, py in plan], 44)
    d.fix("Deck rear", (rear, "front"), [(half, y + middle, DECK), (-half, y + middle, DECK)])
    return top, front, rear


def frame(d):
    wood, body = Mesh(), Mesh()
    wood.tube("Leg front left", [(-300, -262, LOW), (-302, -265, 120), (-305, -270, 0)], lambda t: 26 - 12 * t, 28, 2.5)
    rear = smooth([(-300, 280, LOW), (-302, 296, 110), (-306, 335, 0)], 16)
    wood.tube("Leg rear left", rear, lambda t: 24 - 10 * t, 28, 2.5)
    wood.mirror()
    body.block("Base", (0, 8, LOW + 22), (2 * OUTER - 24, REAR - FRONT - 24, 36), 4)
    body.block("Deck", (0, -20, DECK - 12), (2 * INNER - 10, REAR - FRONT - 80, 20), 4)
    d.frame("Legs", wood, "wood", "#5a3a24")
    d.frame("Body", body, "wood", "#3b2f26")


def main():
    d = Design("wing-chair", 21, notch_spacing=150, symmetric=True)
    terracotta, petrol, cognac = (d.fabric(name, 8) for name in ("Weave, terracotta", "Velvet, petrol", "Leather, cognac"))
    inside, wings, sides, outside = back(d, terracotta)
    arm, facing, outer, border = arms(d, terracotta, outside)
    top, front, rear = seat(d, terracotta)
    frame(d)
    d.layout([(sides["left"], 0), (wings["left"], 0), (inside, 0), (wings["right"], 0), (sides["right"], 0), (outside, 0)],
             [(outer["left"], 0), (arm["left"], 0), (top, 0), (arm["right"], 0), (outer["right"], 0)],
             [(facing["left"], 0), (border, 0), (facing["right"], 0), (rear, 0)],
             [(front, 0)])
    d.colourway("Petrol velvet", petrol)
    d.colourway("Cognac leather", cognac)
    d.write()


if __name__ == "__main__":
    main()
