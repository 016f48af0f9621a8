"""Reading and writing designs for the scripts that make the samples."""

import json
from pathlib import Path

SAMPLES = Path(__file__).resolve().parent.parent


def read(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def write(path, elements, edge_length):
    """One element a line, by id, so that differences can be read."""
    path = Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    lines = [json.dumps(e, ensure_ascii=False) for e in sorted(elements, key=lambda e: e["id"])]
    text = ('{"format": "bolster-design", "version": 1, "unit": "mm",\n'
            f' "settings": {{"edge_length": {edge_length}}},\n'
            ' "elements": [\n  ' + ",\n  ".join(lines) + "\n ]}\n")
    path.write_text(text, encoding="utf-8", newline="\n")


def polygon(*points):
    return {"degree": 1, "closed": True, "points": [list(p) for p in points]}


def rectangle(width, height):
    return polygon((0, 0), (width, 0), (width, height), (0, height))


def stretch(patch, start, end):
    return {"patch": patch, "from": start, "to": end}


def seam(number, a, b, reversed_=True):
    return {"id": number, "kind": "seam", "a": a, "b": b, "reversed": reversed_, "continuity": "C0"}


def tidy(value, digits=3):
    """Rounded, and a whole number without ".0"."""
    value = round(value, digits)
    return int(value) if value == int(value) else value


def tell_apart(elements):
    """Curves of the same name are called left or right as they lie for somebody who stands in front, and then numbered."""
    curves = [e for e in elements if e["kind"] == "fixation_curve"]
    for name in {c["name"] for c in curves}:
        same = [c for c in curves if c["name"] == name]
        for curve in same if len(same) > 1 else []:
            points = curve["curve"]["points"]
            side = "right" if sum(p[0] for p in points) > 0 else "left"
            curve["name"] = name.replace("the arm", f"the {side} arm") if "the arm" in name else f"{name} {side}"
    seen = {}
    for curve in curves:
        seen[curve["name"]] = seen.get(curve["name"], 0) + 1
        if seen[curve["name"]] > 1:
            curve["name"] += f" {seen[curve['name']]}"
