#!/usr/bin/env python3
"""Headrest of a car, 280 x 190 mm: front and rear panel, a gusset around them, open below, where a tray of plastic holds them and two posts."""

from common import Design, Mesh, Outline, rounded, rounded_rectangle, unroll, without_repeats

WIDTH, HEIGHT = 290, 185
FRONT, REAR = -52, 52         # at the bottom
LEAN_FRONT, LEAN_REAR = 22, 12  # so far both panels lean in at the top
TOP_RADIUS, LOW_RADIUS = 75, 17
ARCH = 20                     # of the top edge
POSTS, POST_RADIUS, POST_LENGTH = 70, 6, 190


# From the left end of the bottom edge up, over the top and down on the right: x and height.
X, LOW = WIDTH / 2, WIDTH / 2 - LOW_RADIUS
POINTS = [(-LOW, 0), (2 - X, 26), (-X - 3, 88), (13 - X, HEIGHT), (0, HEIGHT + ARCH),
          (X - 13, HEIGHT), (X + 3, 88), (X - 2, 26), (LOW, 0)]
RADII = [50, 250, TOP_RADIUS, 400, TOP_RADIUS, 250, 50]


def path(y, lean):
    return [(px, y + lean * z / HEIGHT, z) for px, z in rounded(POINTS, RADII, 3)]


def panel(lean):
    longer = (1 + (lean / HEIGHT) ** 2) ** 0.5
    points = [(x, z * longer) for x, z in POINTS]
    return Outline(*points[0]).line("bottom", *points[-1]).round("around", points[-2::-1], RADII)


def main():
    d = Design("headrest", 8, notch_spacing=60)
    cognac, graphite, cream = (d.fabric(name, 5) for name in
                               ("Leather, cognac", "Leather, graphite", "Leather, cream"))
    pressure = 0.05
    front, rear = path(FRONT, LEAN_FRONT), path(REAR, -LEAN_REAR)
    a = d.patch("Front panel", panel(LEAN_FRONT), cognac, pressure)
    b = d.patch("Rear panel", panel(LEAN_REAR), cognac, pressure)
    gusset = d.patch("Gusset", unroll(rear, front, (4, 20, 4, 20), 161), cognac, pressure)

    stitch = {"stitch": "single", "thread": "#d9b98c", "stitch_length_mm": 4}
    d.seam((a, "around"), (gusset, "b"), stitch)
    d.seam((b, "around"), (gusset, "a"), stitch)
    d.fix("Front rail", (a, "bottom"), [front[0], front[-1]])
    d.fix("Rear rail", (b, "bottom"), [rear[-1], rear[0]])
    d.fix("Left rail", (gusset, "start"), [rear[0], front[0]])
    d.fix("Right rail", (gusset, "end"), [front[-1], rear[-1]])

    posts, collars = Mesh(), Mesh()
    for x, name in ((-POSTS, "left"), (POSTS, "right")):
        posts.tube(f"Post {name}", [(x, 0, 60), (x, 0, 0), (x, 0, -POST_LENGTH)], POST_RADIUS, 28)
        collars.tube(f"Collar {name}", [(x, 0, 0), (x, 0, -9)], 15, 32, 2.5)
    d.frame("Posts", posts, "metal")
    plan = without_repeats(rounded_rectangle(2 * LOW - 2, 2 * REAR - 2, 8).filled(20))
    collars.foam("Tray", plan, -4, 8, radius=3)
    d.frame("Tray", collars, "plastic", "#26272a")
    d.layout([(b, 0)], [(gusset, 90, 0)], [(a, 0)])
    d.colourway("Graphite", graphite)
    d.colourway("Cream", cream)
    d.write()


if __name__ == "__main__":
    main()
