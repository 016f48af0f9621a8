"""Reads a STEP file of curves or of flat faces: every reference leads somewhere, every B-spline has the knots that it
needs, and bodies are closed.

    check_step.py FILE
"""
import collections
import json
import re
import sys

TOKEN = re.compile(r"\s*('(?:[^']|'')*'|#\d+|\.[A-Z_0-9]+\.|[-+]?\d+\.\d*(?:E[-+]?\d+)?|[-+]?\d+|[A-Z][A-Z_0-9]*|[(),*$])")


def tokens_of(text):
    at = 0
    while at < len(text):
        found = TOKEN.match(text, at)
        if not found:
            raise SystemExit(f"not to be read: {text[at:at + 40]!r}")
        yield found.group(1)
        at = found.end()


def parsed(tokens):
    """A list of values up to the closing bracket; keywords with their arguments are pairs."""
    values = []
    for token in tokens:
        if token == ")":
            return values
        if token == "(":
            inner = parsed(tokens)
            if values and isinstance(values[-1], str) and values[-1][0].isalpha():
                values[-1] = (values[-1], inner)
            else:
                values.append(inner)
        elif token != ",":
            values.append(token)
    return values


def references(value):
    if isinstance(value, (list, tuple)):
        for each in value:
            yield from references(each)
    elif value.startswith("#"):
        yield value


def volume_of(entities, kinds, errors):
    """Of all closed shells together; those of voids, which are turned around when they are used, count against it."""
    def place(point):
        return [float(n) for n in entities[point][0][1][1]]

    turned = {shell for _, _, shell, way in kinds("ORIENTED_CLOSED_SHELL") if way == ".F."}
    six = 0
    for shell, value in entities.items():
        if not isinstance(value[0], tuple) or value[0][0] != "CLOSED_SHELL":
            continue
        edges = collections.Counter()
        for face in value[0][1][1]:
            _, bounds, plane, _ = entities[face][0][1]
            loop = entities[entities[bounds[0]][0][1][1]][0][1][1]
            a, b, c = (place(point) for point in loop)
            axis = [float(n) for n in entities[entities[entities[plane][0][1][1]][0][1][2]][0][1][1]]
            u, v = [b[k] - a[k] for k in range(3)], [c[k] - a[k] for k in range(3)]
            normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
            if sum(normal[k] * axis[k] for k in range(3)) < 0:
                errors.append(f"{face} lies on a plane that faces the other way")
            for k in range(3):
                edges[(loop[k], loop[(k + 1) % 3])] += 1
            six += (-1 if shell in turned else 1) * (
                a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
                + a[2] * (b[0] * c[1] - b[1] * c[0]))
        if any(n != edges[(b, a)] for (a, b), n in edges.items()):
            errors.append(f"{shell} is not closed")
    return six / 6


def main(path):
    errors = []
    with open(path, encoding="ascii") as file:
        text = file.read()
    if not (text.startswith("ISO-10303-21;\nHEADER;") and text.endswith("ENDSEC;\nEND-ISO-10303-21;\n")):
        errors.append("no exchange structure")
    if "FILE_SCHEMA(('AUTOMOTIVE_DESIGN" not in text:
        errors.append("schema")
    entities = {}
    for name, body in re.findall(r"^(#\d+)=(.*);$", text.split("DATA;\n")[1], re.M):
        if name in entities:
            errors.append(f"{name} twice")
        entities[name] = parsed(tokens_of(body))
    for name, value in entities.items():
        errors += [f"{name} refers to {r}, which is not there" for r in references(value) if r not in entities]

    def kinds(kind):
        return [v[0][1] for v in entities.values() if isinstance(v[0], tuple) and v[0][0] == kind]

    curves = []
    for name, degree, points, form, closed, crossing, counts, knots, spec in kinds("B_SPLINE_CURVE_WITH_KNOTS"):
        degree, counts, knots = int(degree), [int(n) for n in counts], [float(k) for k in knots]
        if sum(counts) != len(points) + degree + 1 or len(counts) != len(knots):
            errors.append(f"{name}: knots do not fit the points")
        if sorted(set(knots)) != knots or counts[0] != degree + 1 or counts[-1] != degree + 1:
            errors.append(f"{name}: knots")
        places = [[float(n) for n in entities[p][0][1][1]] for p in points]
        curves.append({"name": name[1:-1], "degree": degree, "closed": closed == ".T.", "points": places})
    sets = {s[0][1:-1]: len(s[1]) for s in kinds("GEOMETRIC_CURVE_SET")}
    bodies = kinds("CLOSED_SHELL")
    for needed in ("PRODUCT", "PRODUCT_DEFINITION_SHAPE", "SHAPE_DEFINITION_REPRESENTATION",
                   "SHAPE_REPRESENTATION" if kinds("BREP_WITH_VOIDS") else
                   "FACETED_BREP_SHAPE_REPRESENTATION" if bodies else
                   "GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION"):
        if len(kinds(needed)) != 1:
            errors.append(needed)
    if "SI_UNIT(.MILLI.,.METRE.)" not in text:
        errors.append("no millimetres")
    volume = volume_of(entities, kinds, errors)
    print(json.dumps({"errors": errors[:20], "sets": sets, "curves": curves,
                      "faces": len(kinds("FACE_SURFACE")), "volume": volume}))


main(sys.argv[1])
