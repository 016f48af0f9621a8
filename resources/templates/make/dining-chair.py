#!/usr/bin/env python3
"""Dining chair: a seat with boxing and piping, a curved back of five channels on a shell of wood, a frame of wood."""

from math import cos, pi, sin

from common import Design, Mesh, Outline, length_of, rectangle, rounded, smooth, unroll

LOW, BOXING = 438, 44                      # underside and height of the seat's boxing
FRONT, REAR, DEPTH, RADIUS = 470, 410, 440, 38
SHELL, BOW, LEAN = 430, 620, 0.17          # width and radius of the back's shell, its lean
BACK_LOW, BACK_HIGH, PAD = 735, 930, 30
CHANNELS = 5

NOTCH, Y = 44, DEPTH / 2                   # corners cut out around the rear legs

# The seat's plan from the left rear leg round by the front to the right rear leg.
PLAN = [(-REAR / 2, Y - NOTCH), (-FRONT / 2, -Y), (FRONT / 2, -Y), (REAR / 2, Y - NOTCH)]
RADII = [RADIUS] * 2


def seat(d, fabric):
    half, high = REAR / 2 - NOTCH, LOW + BOXING
    outline = (Outline(half, Y).line("rear", -half, Y).line("notch left", *PLAN[0])
               .round("around", PLAN[1:], RADII).line("notch right", half, Y))
    plan = rounded(PLAN, RADII, 4)
    top = d.patch("Seat", outline, fabric, 0.08)
    front = d.patch("Boxing front", rectangle(length_of(plan), BOXING), fabric, 0.03)
    rear = d.patch("Boxing rear", rectangle(2 * half, BOXING), fabric, 0.03)
    piping = {"piping_radius_mm": 3.5}
    d.seam((top, "around"), (front, "rear"), piping)
    d.seam((top, "rear"), (rear, "rear"), piping)
    d.fix("Seat rail front", (front, "front"), [(*p, LOW) for p in plan], 44)
    d.fix("Seat rail rear", (rear, "front"), [(half, Y, LOW), (-half, Y, LOW)])
    for side, x in (("left", -1), ("right", 1)):
        a, b = (x * half, Y), (x * REAR / 2, Y - NOTCH)
        d.fix(f"Leg {side}, seat", (top, f"notch {side}"), [(*p, high) for p in ((a, b) if x < 0 else (b, a))])
        ends = [(*b, LOW), (*b, high)]
        d.fix(f"Leg {side}, front", (front, side), ends if x > 0 else ends[::-1])
        ends = [(*a, LOW), (*a, high)]
        d.fix(f"Leg {side}, rear", (rear, "left" if x > 0 else "right"), ends[::-1] if x > 0 else ends)
    for patch in (front, rear):
        d.add("edge_allowance", **d.stretch(patch, "front"), width_mm=35)
    return top, front, rear


def shell(angle, z, ahead):
    """A point of the back: so far ahead of the middle of its shell."""
    r = BOW - ahead
    return r * sin(angle), 266 + LEAN * (z - 740) - BOW + r * cos(angle), z


def channel_line(angle, deep=0):
    points = [(BACK_LOW, 6), (BACK_LOW + 22, 6 + PAD - deep), (BACK_HIGH - 14, 6 + PAD - deep), (BACK_HIGH, 6)]
    return [shell(angle, z, ahead) for z, ahead in rounded(points, [PAD] * 2, 3)]


def edge_line(angle):
    return [shell(angle, BACK_LOW + (BACK_HIGH - BACK_LOW) * k / 40, 6) for k in range(41)]


def back(d, fabric):
    half = SHELL / 2 / BOW - 0.006
    angles = [half * (2 * k / CHANNELS - 1) for k in range(CHANNELS + 1)]
    lines = [edge_line(angles[0])] + [channel_line(a, 5) for a in angles[1:-1]] + [edge_line(angles[-1])]
    names = ["outer left", "inner left", "middle", "inner right", "outer right"]
    panels = {}
    for k in (2, 3, 4):
        panels[k] = d.patch(f"Channel {names[k]}", unroll(lines[k], lines[k + 1], (4, 18, 4, 18)), fabric, 0.06)
        panels[4 - k] = panels[k] if k == 2 else d.twin(panels[k], f"Channel {names[4 - k]}")
    stitch = {"stitch": "none", "allowance_mm": 5}
    for k in (2, 3):
        d.seam((panels[k], "b"), (panels[k + 1], "a"), stitch)
        other = (panels[2], "a") if k == 2 else (panels[4 - k], "b")
        d.seam(other, (panels[3 - k], "a"), stitch)
        tie = d.fix(f"Tie {k - 1} right", (panels[k + 1], "a"), lines[k + 1][::-1], 24)
        d.fix_twin(f"Tie {k - 1} left", tie, panels[3 - k])
    edge = d.fix("Shell edge right", (panels[4], "b"), lines[5], 6)
    d.fix_twin("Shell edge left", edge, panels[0])
    for k in (2, 3, 4):
        for name, end, where in (("lower", "start", 0), ("upper", "end", -1)):
            points = [lines[k][where], lines[k + 1][where]][::1 if where == 0 else -1]
            part = f" {names[k].split()[0]}"
            fixed = d.fix(f"Shell {name}{part}" + (" right" if k > 2 else ""), (panels[k], end), points)
            if k > 2:
                d.fix_twin(f"Shell {name}{part} left", fixed, panels[4 - k])
    for panel in panels.values():
        d.add("outline_trim", **d.stretch(panel, "start"), trim={"piping_radius_mm": 3})
        d.add("outline_trim", **d.stretch(panel, "end"), trim={"piping_radius_mm": 3})
    for k in (0, 4):
        d.add("outline_trim", **d.stretch(panels[k], "b"), trim={"piping_radius_mm": 3})
    return [panels[k] for k in range(CHANNELS)]


def frame(d):
    wood = Mesh()
    front = [(205, -190, LOW), (207, -193, 330), (211, -198, 120), (214, -202, 0)]
    wood.tube("Leg front left", [(-x, y, z) for x, y, z in front], lambda t: 21 - 8 * t, 28, 2.5)
    top = BACK_HIGH - 15
    path = smooth([(206, 304, 0), (200, 245, 230), (196, 223, 440), (192, 230, 570), (182, 260, 745),
                   (170, 260 + LEAN * (top - 740), top)], 40)
    wood.tube("Leg rear left", [(-x, y, z) for x, y, z in path], lambda t: 12 + 8 * sin(pi * t), 28, 2.5)
    wood.bar("Rail left", [((-204, -180, LOW - 32), (9, 0, 0), (0, 0, 26)), ((-194, 214, LOW - 32), (9, 0, 0), (0, 0, 26))], 3)
    x, y, h = NOTCH / 2 - REAR / 2 + 9, Y - NOTCH / 2 - 9, 0.7071  # a block closes the cut-out corner
    wood.bar("Corner left", [((x, y, z), (h * 29, h * 29, 0), (-h * 11, h * 11, 0)) for z in (LOW, LOW + BOXING - 4)], 2)
    wood.mirror()
    wood.bar("Rail front", [((-204, -192, LOW - 32), (0, 9, 0), (0, 0, 26)), ((204, -192, LOW - 32), (0, 9, 0), (0, 0, 26))], 3)
    wood.bar("Rail rear", [((-192, 219, LOW - 32), (0, 9, 0), (0, 0, 26)), ((192, 219, LOW - 32), (0, 9, 0), (0, 0, 26))], 3)
    half, middle, tall = SHELL / 2 / BOW + 0.006, (BACK_LOW + BACK_HIGH) / 2, (BACK_HIGH - BACK_LOW) / 2 + 5
    sections = []
    for k in range(25):
        a = half * (k / 12 - 1)
        sections.append((shell(a, middle, 0), (0, LEAN * tall, tall), (6 * sin(a), 6 * cos(a), 0)))
    wood.bar("Shell", sections, 4)
    plan = rounded(PLAN, RADII, 6) + [(REAR / 2 - NOTCH, Y), (NOTCH - REAR / 2, Y)]
    board = Mesh().foam("Board", [(x * 0.97, y * 0.97) for x, y in plan], LOW - 6, LOW + 8, radius=3)
    d.frame("Wood", wood, "wood", "#7d5636")
    d.frame("Board", board, "wood", "#c9ab80")


def main():
    d = Design("dining-chair", 11, notch_spacing=100, symmetric=True)
    green, cognac, oatmeal = (d.fabric(name, 5) for name in ("Velvet, green", "Leather, cognac", "Weave, oatmeal"))
    top, front, rear = seat(d, green)
    channels = back(d, green)
    frame(d)
    d.layout([(channel, 0) for channel in channels], [(rear, 180)], [(top, 0)], [(front, 0)])
    d.colourway("Cognac leather", cognac)
    d.colourway("Oatmeal", oatmeal)
    d.write()


if __name__ == "__main__":
    main()
