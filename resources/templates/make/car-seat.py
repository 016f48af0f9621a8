#!/usr/bin/env python3
"""Car seat: cushion and back with an insert, bolsters and sides each; seams along the inserts are tied down."""

from math import cos, pi, sin

from common import (Design, Mesh, mirrored, mix, resample, rounded, rounded_rectangle, unroll, without_repeats)

COUNT = 81
# Lines of the right half, from the front over the cushion to the rear, and up the back and over its top.
CUSHION = {
    "tie": ([(146, -478, 288), (143, -440, 388), (138, -220, 352), (130, -10, 352)], [48, 500]),
    "ridge": ([(188, -479, 288), (204, -440, 418), (214, -220, 408), (190, -10, 392)], [55, 500]),
    "lower": ([(203, -479, 287), (231, -477, 285), (244, -150, 276), (234, -5, 276)], [25, 400]),
}
BACK = {
    "tie": ([(130, -6, 335), (128, 36, 500), (126, 102, 650), (120, 166, 800), (100, 222, 940), (84, 254, 1075),
             (80, 326, 1060)], [300, 600, 600, 400, 36]),
    "ridge": ([(184, -32, 350), (208, -30, 500), (213, 36, 650), (208, 112, 775), (140, 196, 900), (124, 222, 980),
               (108, 252, 1062), (104, 326, 1042)], [250, 400, 160, 160, 300, 40]),
    "lower": ([(214, 96, 335), (242, 130, 500), (242, 200, 650), (236, 246, 775), (170, 286, 900), (150, 300, 980),
               (138, 328, 1030), (118, 328, 1038)], [400, 500, 120, 160, 80, 12]),
}
CROSS = {"Cushion": (0.48, 0.74), "Back": (0.24, 0.43, 0.62)}   # where the inserts are tied across


def lines_of(part):
    return {name: resample(rounded(points, radii, 4), COUNT) for name, (points, radii) in part.items()}


def cover(d, name, part, insert_fabric, fabric, where):
    tie, ridge, lower = (lines_of(part)[key] for key in ("tie", "ridge", "lower"))
    across = unroll(mirrored(tie), tie, (4, 16, 4, 16), COUNT)
    insert = d.patch(f"{name} insert", across, insert_fabric, 0.2)
    bolster = {"right": d.patch(f"{name} bolster right", unroll(tie, ridge, (4, 16, 4, 16), COUNT), fabric, 0.15)}
    side = {"right": d.patch(f"{name} side right", unroll(ridge, lower, (4, 16, 4, 16), COUNT), fabric, 0.08)}
    bolster["left"] = d.twin(bolster["right"], f"{name} bolster left")
    side["left"] = d.twin(side["right"], f"{name} side left")

    thread = "#c8503f"
    for s, edge in (("right", "b"), ("left", "a")):
        d.seam((insert, edge), (bolster[s], "a"), {"allowance_mm": 6})
        d.seam((bolster[s], "b"), (side[s], "a"), {"stitch": "twin", "thread": thread, "thread_width_mm": 1.2})
    d.fix(f"{name} tie right", (insert, "b"), tie, 16)
    d.fix(f"{name} tie left", (insert, "a"), mirrored(tie)[::-1], 16)
    low, high = where
    d.fix(f"{name} insert, {low}", (insert, "start"), [mirrored(tie)[0], tie[0]])
    d.fix(f"{name} insert, {high}", (insert, "end"), [tie[-1], mirrored(tie)[-1]])
    for piece, kind, a, b in ((bolster, "bolster", tie, ridge), (side, "side", ridge, lower)):
        for end, place, points in ((low, "start", [a[0], b[0]]), (high, "end", [b[-1], a[-1]])):
            if points[0] != points[1]:
                fixed = d.fix(f"{name} {kind} right, {end}", (piece["right"], place), points)
                d.fix_twin(f"{name} {kind} left, {end}", fixed, piece["left"])
    fixed = d.fix(f"{name} lower edge right", (side["right"], "b"), lower, 16)
    d.fix_twin(f"{name} lower edge left", fixed, side["left"])
    for k, t in enumerate(CROSS[name]):
        i = round(t * (COUNT - 1))
        left, right = (-tie[i][0], *tie[i][1:]), tie[i]
        ends = [mix(*pair, 0.07 + 0.86 * u) for pair in (across.rulings[i], (left, right)) for u in (0, 1)]
        d.hold_line(f"{name} tie across {k + 1}", insert, *ends)
    return insert, bolster, side


def frame(d):
    shell = Mesh()
    edge = resample(rounded(*BACK["lower"], 4), 17)[:-1] + [(92, 318, 1058)]
    rings = []
    for k, (x, y, z) in enumerate(edge):
        bulge = 30 * min(1, (len(edge) - 1 - k) / 3 + 0.3, k / 3 + 0.5)
        angles = [2 * pi * i / 40 for i in range(40)]
        rings.append([((x - 5) * cos(a), y - 4 + (bulge if sin(a) > 0 else 14) * sin(a), z) for a in angles])
    shell.loft("Back shell", rings)
    pan = [(x, y - 234) for x, y in without_repeats(rounded_rectangle(470, 462, 40).filled(25))]
    shell.foam("Seat pan", pan, 236, 292, radius=14)
    shell.block("Rear wall", (0, -10, 300), (400, 16, 60), 6)
    rails = Mesh()
    for side, x in (("left", -1), ("right", 1)):
        shell.bar(f"Hinge {side}", [((x * 176, -30, 262), (10, 0, 0), (0, 8, 24)), ((x * 176, 60, 296), (10, 0, 0), (0, -14, 28)),
                                    ((x * 176, 118, 400), (10, 0, 0), (0, -26, 10))], 4)
        rails.bar(f"Rail {side}", [((x * 186, -440, 196), (16, 0, 0), (0, 0, 13)), ((x * 186, 70, 196), (16, 0, 0), (0, 0, 13))], 3)
        for end, y in (("front", -380), ("rear", -30)):
            rails.block(f"Foot {end} {side}", (x * 186, y, 222), (26, 60, 40), 4)
    wires(rails)
    d.frame("Shell", shell, "plastic", "#26272a")
    d.frame("Rails", rails, "metal")


def wires(rails):
    """What the seams along the inserts are tied to lies under the cloth, and so do the ends at the rear of the cushion."""
    for part, lines, (back, down) in (("Cushion", CUSHION, (8, 9)), ("Back", BACK, (9, 0))):
        tie = [(x, y + back, z - down) for x, y, z in resample(lines_of(lines)["tie"], 24)[1:-1]]
        for side, line in (("right", tie), ("left", mirrored(tie))):
            rails.tube(f"{part} tie wire {side}", line, 2.5, 10, 1)
    ends = [lines_of(CUSHION)[key][-1] for key in ("tie", "ridge", "lower")]
    rear = [(x - 6, y - 8, z - 18) for x, y, z in resample(ends, 12)]
    for side, line in (("right", rear), ("left", mirrored(rear))):
        rails.tube(f"Rear wire {side}", line, 2.5, 10, 1)


def main():
    d = Design("car-seat", 12, notch_spacing=120, symmetric=True)
    graphite, grey = d.fabric("Leather, graphite", 4.5), d.fabric("Weave, grey", 4.5)
    cognac, cream = d.fabric("Leather, cognac", 4.5), d.fabric("Leather, cream", 4.5)
    cushion = cover(d, "Cushion", CUSHION, grey, graphite, ("front", "rear"))
    back = cover(d, "Back", BACK, grey, graphite, ("below", "top"))
    frame(d)
    rows = [[(side["left"], 0), (bolster["left"], 0), (insert, 0), (bolster["right"], 0), (side["right"], 0)]
            for insert, bolster, side in (back, cushion)]
    d.layout(*rows)
    d.colourway("Graphite", graphite)
    d.colourway("Cognac", cognac)
    d.colourway("Cream", graphite, insert=cream)
    d.write()


if __name__ == "__main__":
    main()
