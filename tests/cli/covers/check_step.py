"""Reads a STEP file of curves: every reference leads somewhere, every B-spline has the knots that it needs.

    check_step.py FILE
"""
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
    for needed in ("PRODUCT", "PRODUCT_DEFINITION_SHAPE", "SHAPE_DEFINITION_REPRESENTATION",
                   "GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION"):
        if len(kinds(needed)) != 1:
            errors.append(needed)
    if "SI_UNIT(.MILLI.,.METRE.)" not in text:
        errors.append("no millimetres")
    print(json.dumps({"errors": errors[:20], "sets": sets, "curves": curves}))


main(sys.argv[1])
