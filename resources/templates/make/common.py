"""What the templates have in common: outlines, pieces unrolled from space, designs, and meshes for frames.

Python 3, nothing else needed. Lengths are millimetres, z points up, the front faces -y.
"""

import json
from math import acos, atan, ceil, cos, dist, hypot, pi, radians, sin, sqrt, tan
from pathlib import Path

FOLDER = Path(__file__).resolve().parent.parent
GAP = 60         # between patches in the layout
KAPPA = 0.55228  # control points of a quarter of a circle

FABRICS = {
    "Leather, cognac": ("#95532a", {"kind": "grained_leather", "roughness": 0.46, "scale_mm": 2.8}),
    "Leather, graphite": ("#33363b", {"kind": "grained_leather", "roughness": 0.42, "scale_mm": 2.4}),
    "Leather, cream": ("#ddd0b8", {"kind": "grained_leather", "second_color": "#a3937a", "roughness": 0.48,
                                   "scale_mm": 2.8}),
    "Weave, grey": ("#6f7378", {"kind": "woven", "second_color": "#9a9da1", "roughness": 0.88, "scale_mm": 3}),
    "Weave, blue": ("#2c4766", {"kind": "woven", "second_color": "#5b7694", "roughness": 0.88, "scale_mm": 3}),
    "Weave, terracotta": ("#8c4426", {"kind": "woven", "second_color": "#b06a42", "roughness": 0.9, "scale_mm": 3}),
    "Velvet, green": ("#1f5a41", {"kind": "velvet", "roughness": 0.9, "scale_mm": 5}),
    "Velvet, petrol": ("#15505c", {"kind": "velvet", "roughness": 0.9, "scale_mm": 5}),
    "Weave, oatmeal": ("#cbbfa9", {"kind": "woven", "second_color": "#e6dece", "roughness": 0.92, "scale_mm": 4}),
}


# ---- points

def tidy(value, digits=2):
    """Rounded, and a whole number without ".0"."""
    value = round(value, digits)
    return int(value) if value == int(value) else value


def add(a, b, scale=1):
    return tuple(p + scale * q for p, q in zip(a, b))


def sub(a, b):
    return tuple(p - q for p, q in zip(a, b))


def mix(a, b, t):
    return tuple(p + (q - p) * t for p, q in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = hypot(*a)
    return tuple(p / length for p in a)


def mirrored(points):
    return [(-p[0], *p[1:]) for p in points]


def turned(point, degrees):
    c, s = cos(radians(degrees)), sin(radians(degrees))
    return c * point[0] - s * point[1], s * point[0] + c * point[1]


def length_of(points):
    return sum(dist(a, b) for a, b in zip(points, points[1:]))


def resample(points, count):
    """So many points at equal distances along a polyline."""
    done, total, result, i = 0, length_of(points), [], 0
    for k in range(count):
        goal = total * k / (count - 1)
        while i < len(points) - 2 and done + dist(points[i], points[i + 1]) < goal:
            done += dist(points[i], points[i + 1])
            i += 1
        step = dist(points[i], points[i + 1])
        result.append(mix(points[i], points[i + 1], min(1, (goal - done) / step) if step else 0))
    return result


def rounded(points, radii, step=6):
    """An open polyline with its corners rounded; radii has one number for each inner corner."""
    assert len(radii) == len(points) - 2
    result = [tuple(points[0])]
    for before, corner, after, radius in zip(points, points[1:], points[2:], radii):
        u, v = unit(sub(before, corner)), unit(sub(after, corner))
        cosine = sum(p * q for p, q in zip(u, v))
        if radius <= 0 or cosine < -0.99999:
            result.append(tuple(corner))
            continue
        half_tan = sqrt((1 - cosine) / (1 + cosine))      # of half the angle between both sides
        along = radius / half_tan
        middle = unit(add(u, v))
        centre = add(corner, middle, sqrt(radius ** 2 + along ** 2))
        start, end = sub(add(corner, u, along), centre), sub(add(corner, v, along), centre)
        angle = 2 * (pi / 2 - atan(half_tan))
        count = max(4, ceil(radius * angle / step))
        for k in range(count + 1):
            a, b = sin(angle * (1 - k / count)), sin(angle * k / count)
            result.append(add(add(centre, start, a / sin(angle)), end, b / sin(angle)))
    return result + [tuple(points[-1])]


def smooth(points, count=60):
    """A curve through points (natural parameters by distance, Catmull-Rom tangents), as a polyline."""
    t = [0.0]
    for a, b in zip(points, points[1:]):
        t.append(t[-1] + dist(a, b))
    slope = []
    for i in range(len(points)):
        if 0 < i < len(points) - 1:
            h, g = t[i] - t[i - 1], t[i + 1] - t[i]
            left, right = [(q - p) / h for p, q in zip(points[i - 1], points[i])], \
                          [(q - p) / g for p, q in zip(points[i], points[i + 1])]
            slope.append([(g * a + h * b) / (g + h) for a, b in zip(left, right)])
        else:
            slope.append(None)
    for i, j in ((0, 1), (-1, -2)):
        chord = [(q - p) / (t[j] - t[i]) for p, q in zip(points[i], points[j])]
        slope[i] = [1.5 * c - 0.5 * s for c, s in zip(chord, slope[j])] if slope[j] else chord
    result, i = [], 0
    for k in range(count + 1):
        x = t[-1] * k / count
        while i < len(points) - 2 and t[i + 1] < x:
            i += 1
        h = t[i + 1] - t[i]
        u = (x - t[i]) / h
        result.append(tuple(
            (2 * u**3 - 3 * u**2 + 1) * p + (u**3 - 2 * u**2 + u) * h * m + (3 * u**2 - 2 * u**3) * q + (u**3 - u**2) * h * n
            for p, q, m, n in zip(points[i], points[i + 1], slope[i], slope[i + 1])))
    return result


# ---- curves of the design

def fit(points, controls):
    """Control points of the clamped uniform cubic that comes nearest to a polyline; its ends stay."""
    if len(points) == 2:
        return [mix(*points, k / 3) for k in range(4)]
    n = controls
    points = resample(points, max(8 * n, len(points)))
    t = [0.0]
    for a, b in zip(points, points[1:]):
        t.append(t[-1] + dist(a, b))
    knots = [0] * 4 + [(i + 1) / (n - 3) for i in range(n - 4)] + [1] * 4
    rows = []
    for value in t:
        u = min(value / t[-1], 1 - 1e-12)
        basis = [1.0 if knots[i] <= u < knots[i + 1] else 0.0 for i in range(n + 3)]
        for d in range(1, 4):
            basis = [(basis[i] * (u - knots[i]) / (knots[i + d] - knots[i]) if knots[i + d] > knots[i] else 0)
                     + (basis[i + 1] * (knots[i + d + 1] - u) / (knots[i + d + 1] - knots[i + 1])
                        if knots[i + d + 1] > knots[i + 1] else 0) for i in range(n + 3 - d)]
        rows.append(basis)
    first, last = points[0], points[-1]
    size = n - 2
    matrix = [[sum(r[i + 1] * r[j + 1] for r in rows) + (1e-9 if i == j else 0) for j in range(size)]
              + [sum(r[i + 1] * (p[k] - r[0] * first[k] - r[-1] * last[k]) for r, p in zip(rows, points))
                 for k in range(len(first))] for i in range(size)]
    for i in range(size):
        for j in range(i + 1, size):
            factor = matrix[j][i] / matrix[i][i]
            matrix[j] = [a - factor * b for a, b in zip(matrix[j], matrix[i])]
    solved = [None] * size
    for i in reversed(range(size)):
        solved[i] = tuple((matrix[i][size + k] - sum(matrix[i][j] * solved[j][k] for j in range(i + 1, size)))
                          / matrix[i][i] for k in range(len(first)))
    return [tuple(first)] + solved + [tuple(last)]


class Outline:
    """A closed cubic of edges with names; each edge begins at a corner."""

    def __init__(self, *start):
        self.points, self.corners, self.edges, self.sampled = [tuple(start)], [], {}, []

    def _edge(self, name, controls, samples):
        self.corners.append(len(self.points) - 1)
        self.points += controls[1:]
        self.edges[name] = (self.corners[-1], len(self.points) - 1)
        self.sampled += samples
        return self

    def line(self, name, *end):
        a = self.points[-1]
        return self._edge(name, [mix(a, end, k / 3) for k in range(4)], [a, end])

    def quarter(self, name, *end):
        """A quarter of a circle or ellipse that turns to the left: where it begins it runs along the side before."""
        a = self.points[-1]
        dx, dy = end[0] - a[0], end[1] - a[1]
        middle = (end[0], a[1]) if dx * dy > 0 else (a[0], end[1])
        controls = [a, mix(a, middle, KAPPA), mix(end, middle, KAPPA), end]
        samples = [tuple(sum(w * p[k] for w, p in zip(((1 - u)**3, 3 * u * (1 - u)**2, 3 * u**2 * (1 - u), u**3), controls))
                         for k in (0, 1)) for u in [i / 12 for i in range(13)]]
        return self._edge(name, controls, samples)

    def round(self, name, points, radii):
        """A polyline from where the outline is, its corners rounded by exact lines and arcs; one edge by name."""
        begin = len(self.points) - 1
        a = self.points[-1]
        points = [a, *points]
        for before, corner, after, radius in zip(points, points[1:], points[2:], radii):
            arc = rounded([before, corner, after], [radius], 3)[1:-1]
            u, v = unit(sub(corner, before)), unit(sub(after, corner))
            angle = acos(max(-1, min(1, sum(p * q for p, q in zip(u, v)))))
            reach = 4 / 3 * tan(angle / 4) * radius
            self.line(name, *arc[0])
            self._edge(name, [arc[0], add(arc[0], u, reach), add(arc[-1], v, -reach), arc[-1]], arc)
        self.line(name, *points[-1])
        self.edges[name] = (begin, len(self.points) - 1)
        return self

    def curve(self, name, samples, controls=6):
        """Along a polyline from where the outline is."""
        return self._edge(name, fit(samples, controls), list(samples))

    def filled(self, step):
        """Its samples, with more on long sides."""
        result = []
        for a, b in zip(self.sampled, self.sampled[1:]):
            count = max(1, round(dist(a, b) / step))
            result += [mix(a, b, k / count) for k in range(count)]
        return result + [self.sampled[-1]]

    def form(self):
        return {"degree": 3, "closed": True, "corners": self.corners,
                "points": [[tidy(x), tidy(y)] for x, y in self.points[:-1]]}


def rectangle(width, height):
    return Outline(0, 0).line("front", width, 0).line("right", width, height).line("rear", 0, height).line("left", 0, 0)


def rounded_rectangle(width, height, r):
    """About the origin, from the left end of its straight front edge."""
    x, y = width / 2, height / 2
    return (Outline(-x + r, -y).line("front", x - r, -y).quarter("front right", x, -y + r)
            .line("right", x, y - r).quarter("rear right", x - r, y)
            .line("rear", -x + r, y).quarter("rear left", -x, y - r)
            .line("left", -x, -y + r).quarter("front left", -x + r, -y))


def without_repeats(points, least=0.01):
    """A closed polyline from samples of an outline."""
    result = []
    for p in points:
        if not result or dist(p, result[-1]) > least:
            result.append(tuple(p))
    return result[:-1] if dist(result[0], result[-1]) <= least else result


def ring(x, y, radius, count=8):
    """Control points of a uniform cubic that is nearly a circle."""
    r = radius * 3 / (2 + cos(2 * pi / count))
    return [(x + r * cos(2 * pi * k / count), y + r * sin(2 * pi * k / count)) for k in range(count)]


def circle(radius):
    names = ("first", "second", "third", "fourth")
    outline = Outline(radius, 0)
    for name, end in zip(names, ((0, radius), (-radius, 0), (0, -radius), (radius, 0))):
        outline.quarter(name, *end)
    return outline


def unroll(a, b, controls=(4, 6, 4, 6), count=61, cuts=(), end_cuts=()):
    """The flat piece of the ruled surface between two polylines; edges start, b, end, a.

    Seen from outside, b lies to the right of a when both are walked upwards. Without a count the points of both belong
    together as they are. `cuts`: numbers of points at which a and b are divided, as "a 1", "a 2" and so on from the start;
    `end_cuts`: fractions of the end's length.
    """
    if count:
        a, b = resample(a, count), resample(b, count)
    count = len(a)
    low, high = [(0.0, 0.0)], [(dist(a[0], b[0]), 0.0)]

    def third(p, q, to_p, to_q):  # to the left of the way from p to q
        base = dist(p, q)
        x = (base**2 + to_p**2 - to_q**2) / (2 * base)
        y = sqrt(max(0.0, to_p**2 - x**2))
        ex, ey = (q[0] - p[0]) / base, (q[1] - p[1]) / base
        return p[0] + x * ex - y * ey, p[1] + x * ey + y * ex

    for i in range(count - 1):  # both diagonals, so that twisted strips bend to neither side
        p, q = low[-1], high[-1]
        a1 = third(p, q, dist(a[i], a[i + 1]), dist(b[i], a[i + 1]))
        b1 = third(p, q, dist(a[i], b[i + 1]), dist(b[i], b[i + 1]))
        off = dist(a[i + 1], b[i + 1]) / dist(a1, b1)
        centre = mix(a1, b1, 0.5)
        low.append(mix(centre, a1, off))
        high.append(mix(centre, b1, off))
    outline = Outline(0, 0)
    outline.rulings = list(zip(low, high))
    start, right, end, left = controls
    for name, points, number in (("start", [low[0], high[0]], start), ("b", high, right),
                                 ("end", [high[-1], low[-1]], end), ("a", low[::-1], left)):
        first = len(outline.points) - 1
        if name == "end" and end_cuts:
            for k, t in enumerate([*end_cuts, 1]):
                outline.line(f"end {k + 1}", *mix(*points, t))
            outline.edges[name] = (first, len(outline.points) - 1)
        elif len(points) == 2:
            outline.line(name, *points[-1])
        elif not cuts:
            outline.curve(name, points, number)
        else:
            at = [0, *cuts, count - 1]
            parts = [(k + 1, p, q) for k, (p, q) in enumerate(zip(at, at[1:]))]
            if name == "a":
                parts = [(k, count - 1 - q, count - 1 - p) for k, p, q in reversed(parts)]
            for k, p, q in parts:
                some = points[p:q + 1]
                outline.curve(f"{name} {k}", some, number if len(some) > 20 else 4)
            outline.edges[name] = (first, len(outline.points) - 1)
    return outline


# ---- designs

class Design:
    def __init__(self, name, edge, allowance=10, notch_spacing=150, symmetric=False):
        self.name, self.elements, self.outlines = name, [], {}
        self.settings = {"edge_length": edge}
        if symmetric:
            self.settings["symmetry"] = {"plane": {"point": [0, 0, 0], "normal": [1, 0, 0]},
                                         "axis": {"point": [0, 0], "direction": [0, 1]}}
        self.settings["cutting"] = {"allowance": {"width_mm": allowance},
                                    "notches": {"shape": {"kind": "v"}, "spacing_mm": notch_spacing},
                                    "style": name.replace("-", " ").capitalize()}

    def add(self, kind, **keys):
        self.elements.append({"id": len(self.elements) + 1, "kind": kind, **keys})
        return len(self.elements)

    def element(self, number):
        return self.elements[number - 1]

    def fabric(self, name, bending=6, stiffness=1, limits=None):
        color, look = FABRICS[name]
        more = {"limits": dict(zip(("along", "across", "shear"), limits))} if limits else {}
        return self.add("fabric", name=name, poisson=0.3, stiffness=stiffness, bending_length=bending, color=color,
                        look=look, **more)

    def patch(self, name, outline, fabric, pressure=0, **keys):
        number = self.add("patch", name=name, fabric=fabric, position=[0, 0], pressure=pressure, outline=outline.form(),
                          **keys)
        self.outlines[number] = outline
        return number

    def twin(self, number, name):
        """The mirror twin of a patch."""
        original, outline = self.element(number), self.outlines[number]
        keys = {k: v for k, v in original.items() if k not in ("id", "kind", "name", "outline")}
        form = dict(original["outline"], points=[[-x if x else 0, y] for x, y in original["outline"]["points"]])
        twin = self.add("patch", name=name, **keys, outline=form, twin={"of": number})
        copy = Outline(0, 0)
        copy.edges, copy.corners, copy.sampled = outline.edges, outline.corners, mirrored(outline.sampled)
        self.outlines[twin] = copy
        return twin

    def stretch(self, patch, first, last=None):
        edges = self.outlines[patch].edges
        if first == "all":
            return {"patch": patch, "from": 0, "to": 0}
        return {"patch": patch, "from": edges[first][0], "to": edges[last or first][1]}

    def clockwise(self, patch):
        points = self.outlines[patch].sampled
        return sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(points, points[1:] + points[:1])) < 0

    def seam(self, a, b, trim=None, continuity="C0", **keys):
        """a and b: patch and edge, or patch, first and last edge."""
        a = a if isinstance(a, dict) else self.stretch(*a)
        b = b if isinstance(b, dict) else self.stretch(*b)
        same = self.clockwise(a["patch"]) == self.clockwise(b["patch"])
        more = {"trim": trim} if trim else {}
        return self.add("seam", a=a, b=b, reversed=same, continuity=continuity, **more, **keys)

    def curve(self, name, points, controls=4, closed=False, twin_of=None):
        if closed:
            form = {"degree": 3, "closed": True, "points": points}
        else:
            form = {"degree": 3, "closed": False, "points": fit(points, controls) if controls else points}
        form["points"] = [[tidy(c) for c in p] for p in form["points"]]
        more = {"twin": {"of": twin_of}} if twin_of else {}
        return self.add("fixation_curve", name=name, **more, curve=form)

    def fix(self, name, stretch, points, controls=4, **keys):
        """Fixes an edge along a polyline that runs as the outline does."""
        curve = self.curve(name, points, controls)
        stretch = stretch if isinstance(stretch, dict) else self.stretch(*stretch)
        return self.add("fixation_seam", **stretch, curve=curve, **keys)

    def fix_twin(self, name, fixation, patch):
        """Fixes the twin of a patch as its original is."""
        original = self.element(fixation)
        curve = self.element(original["curve"])["curve"]
        twin = self.add("fixation_curve", name=name, twin={"of": original["curve"]},
                        curve=dict(curve, points=[[-p[0] if p[0] else 0, *p[1:]] for p in curve["points"]]))
        keys = {k: v for k, v in original.items() if k not in ("id", "kind", "patch", "curve")}
        return self.add("fixation_seam", patch=patch, curve=twin, **keys)

    def hold(self, name, patch, curve, target):
        """A closed handle: points of a uniform cubic in the pattern and where they lie in space."""
        forms = [{"degree": 3, "closed": True, "points": [[tidy(c) for c in p] for p in points]}
                 for points in (curve, target)]
        return self.add("handle_curve", name=name, patch=patch, curve=forms[0], target=forms[1])

    def hold_line(self, name, patch, a, b, target_a, target_b, **keys):
        """A straight handle."""
        line, target = ({"degree": 1, "closed": False, "points": [[tidy(c) for c in p] for p in points]}
                        for points in ((a, b), (target_a, target_b)))
        return self.add("handle_curve", name=name, patch=patch, curve=line, target=target, **keys)

    def colourway(self, name, fabric, **others):
        """`others`: fabrics of the patches that have this word in their names."""
        entries = []
        for e in self.elements:
            if e["kind"] == "patch":
                words = e["name"].lower().split()
                entries.append({"patch": e["id"],
                                "fabric": next((f for word, f in others.items() if word in words), fabric)})
        return self.add("colourway", name=name, fabrics=entries)

    def frame(self, name, mesh, material, color=None, contact=None):
        file = f"{self.name}-{name.lower().replace(' ', '-')}.obj"
        mesh.write(FOLDER / file, f"{self.name}: {name}, mm")
        more = {"contact": True, "contact_gap": contact} if contact is not None else {}
        return self.add("frame", name=name, file=file, **more,
                        material={"kind": material, **({"color": color} if color else {})})

    def layout(self, *rows):
        """Rows of (patch, rotation), from above, each centred; the grain stays upright unless given as a third."""
        top = 0
        for row in rows:
            boxes = []
            for patch, rotation, *_ in row:
                points = [turned(p, rotation) for p in self.outlines[patch].sampled]
                boxes.append(([min(c) for c in zip(*points)], [max(c) for c in zip(*points)]))
            x = -(sum(high[0] - low[0] for low, high in boxes) + GAP * (len(row) - 1)) / 2
            height = max(high[1] - low[1] for low, high in boxes)
            for (patch, rotation, *grain), (low, high) in zip(row, boxes):
                y = top - (height + high[1] - low[1]) / 2
                element = self.element(patch)
                element["position"] = [tidy(x - low[0], 1), tidy(y - low[1], 1)]
                element["rotation"] = rotation
                element["grain"] = ((grain[0] if grain else 90) - rotation) % 180
                x += high[0] - low[0] + GAP
            top -= height + GAP

    def write(self):
        lines = [json.dumps(e, ensure_ascii=False) for e in self.elements]
        (FOLDER / f"{self.name}.json").write_text(
            '{"format": "bolster-design", "version": 1, "unit": "mm",\n'
            f' "settings": {json.dumps(self.settings)},\n'
            ' "elements": [\n  ' + ",\n  ".join(lines) + "\n ]}\n", encoding="utf-8", newline="\n")


# ---- meshes of frames

class Mesh:
    def __init__(self):
        self.groups = []  # name, points, faces

    def part(self, name, points, faces):
        self.groups.append((name, points, faces))
        return self

    def loft(self, name, rings):
        """Rings of equally many points, counter-clockwise seen from the last one; both ends are closed."""
        n = len(rings[0])
        points = [p for ring in rings for p in ring]
        faces = []
        for i in range(len(rings) - 1):
            for j in range(n):
                k = (j + 1) % n
                faces.append((i * n + j, i * n + k, (i + 1) * n + k, (i + 1) * n + j))
        for ring, base, order in ((rings[0], 0, 1), (rings[-1], (len(rings) - 1) * n, 0)):
            middle = len(points)
            points.append(tuple(sum(c) / n for c in zip(*ring)))
            for j in range(n):
                a, b = base + j, base + (j + 1) % n
                faces.append((b, a, middle) if order else (a, b, middle))
        return self.part(name, points, faces)

    def tube(self, name, path, radius, sides=20, bevel=2, squash=1, across=None):
        """A round bar along a polyline, its ends bevelled; radius is a number or a function of 0 to 1."""
        of = radius if callable(radius) else lambda t: radius
        total, done, rings = length_of(path), 0, []
        tangents = [unit(sub(path[min(i + 1, len(path) - 1)], path[max(i - 1, 0)])) for i in range(len(path))]
        side = across or (cross(tangents[0], (0, 0, 1)) if abs(tangents[0][2]) < 0.9 else (1, 0, 0))
        for i, (p, t) in enumerate(zip(path, tangents)):
            u = unit(sub(side, tuple(c * sum(a * b for a, b in zip(side, t)) for c in t)))
            side, v = u, cross(t, u)
            r = of(done / total)
            ring = [add(add(p, u, r * cos(2 * pi * k / sides)), v, squash * r * sin(2 * pi * k / sides))
                    for k in range(sides)]
            if bevel and i in (0, len(path) - 1):
                inner = [mix(q, p, bevel / r) for q in ring]
                near = [add(q, t, bevel if i == 0 else -bevel) for q in ring]
                rings += [inner, near] if i == 0 else [near, inner]
            else:
                rings.append(ring)
            if i + 1 < len(path):
                done += dist(p, path[i + 1])
        return self.loft(name, rings)

    def bar(self, name, sections, bevel=4, n=3):
        """A bar of wood: sections (centre, half width vector, half depth vector) with rounded edges and ends."""
        def ring(centre, u, v, inset=0):
            a, b = hypot(*u), hypot(*v)
            r = min(bevel, a * 0.98, b * 0.98)
            result = []
            for sx, sy, begin in ((1, 1, 0), (-1, 1, 90), (-1, -1, 180), (1, -1, 270)):
                for k in range(n + 1):
                    angle = radians(begin + 90 * k / n)
                    x = sx * (a - r) + (r - inset) * cos(angle)
                    y = sy * (b - r) + (r - inset) * sin(angle)
                    result.append(add(add(centre, u, x / a), v, y / b))
            return result

        rings = []
        for i, (centre, u, v) in enumerate(sections):
            if i in (0, len(sections) - 1):
                other = sections[1 if i == 0 else -2][0]
                inwards = unit(sub(other, centre))
                ends = [ring(add(centre, inwards, bevel * (1 - sin(radians(90 * k / n)))), u, v,
                             bevel * (1 - cos(radians(90 * k / n))) * 0.98) for k in range(n + 1)]
                rings += ends[::-1] if i == 0 else ends
            else:
                rings.append(ring(centre, u, v))
        normal = cross(sections[0][1], sections[0][2])
        if sum(a * b for a, b in zip(normal, sub(sections[-1][0], sections[0][0]))) < 0:
            rings = rings[::-1]
        return self.loft(name, rings)

    def block(self, name, centre, size, bevel=4, n=3):
        x, y, z = (s / 2 for s in size)
        return self.bar(name, [(add(centre, (0, 0, -z)), (x, 0, 0), (0, y, 0)),
                               (add(centre, (0, 0, z)), (x, 0, 0), (0, y, 0))], bevel, n)

    def foam(self, name, plan, low, high, crown=0, radius=15, belly=0, n=5, lid=10):
        """A body over a closed plan (polyline), rounded above and below, its top crowned, its bottom by `belly`."""
        cx, cy = (sum(p[k] for p in plan) / len(plan) for k in (0, 1))
        reach = min(hypot(p[0] - cx, p[1] - cy) for p in plan)

        def ring(scale, z):
            return [(cx + scale * (p[0] - cx), cy + scale * (p[1] - cy), z) for p in plan]

        edge = 1 - radius / reach
        rise = lambda s: (1 - (s / edge) ** 2) ** 1.2 if s < edge else 0
        rings = [ring(edge * (k + 0.3) / lid, low - belly * rise(edge * (k + 0.3) / lid)) for k in range(lid)]
        rings += [ring(1 - radius / reach * (1 - sin(radians(90 * k / n))), low + radius * (1 - cos(radians(90 * k / n))))
                  for k in range(n + 1)]
        rings += [ring(1 - radius / reach * (1 - cos(radians(90 * k / n))), high - radius * (1 - sin(radians(90 * k / n))))
                  for k in range(n + 1)]
        rings += [ring(edge * (k + 0.3) / lid, high + crown * rise(edge * (k + 0.3) / lid)) for k in reversed(range(lid))]
        return self.loft(name, rings)

    def mirror(self, *names):
        """Mirrors of the groups of these names (all without): " left" becomes " right"."""
        for name, points, faces in list(self.groups):
            if not names or name in names:
                self.part(name.replace("left", "right"), mirrored(points), [f[::-1] for f in faces])
        return self

    def write(self, path, comment):
        lines, base = [f"# {comment}"], 1
        for name, points, faces in self.groups:
            lines.append(f"g {name.replace(' ', '_')}")
            lines += ["v " + " ".join(str(tidy(c)) for c in p) for p in points]
            lines += ["f " + " ".join(str(base + i) for i in f) for f in faces]
            base += len(points)
        path.write_text("\n".join(lines) + "\n", encoding="utf-8", newline="\n")
