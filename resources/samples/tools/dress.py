#!/usr/bin/env python3
"""Dresses the finished samples: fabrics that look like something, stitches and piping, colourways. Run it after the
scripts that make them; running it again changes nothing.

    dress.py
"""

from designfile import SAMPLES, read, write

LOOKS = {
    "Leather, graphite": ("#33363b", {"kind": "grained_leather", "roughness": 0.42, "scale_mm": 2.4}),
    "Leather, cognac": ("#95532a", {"kind": "grained_leather", "roughness": 0.46, "scale_mm": 2.8}),
    "Leather, cream": ("#ddd0b8", {"kind": "grained_leather", "second_color": "#a3937a", "roughness": 0.48,
                                   "scale_mm": 2.8}),
    "Leather, dark brown": ("#4a2c1c", {"kind": "smooth_leather", "roughness": 0.36, "scale_mm": 1.5}),
    "Weave, grey": ("#6f7378", {"kind": "woven", "second_color": "#9a9da1", "roughness": 0.88, "scale_mm": 3}),
    "Weave, blue": ("#2c4766", {"kind": "woven", "second_color": "#5b7694", "roughness": 0.88, "scale_mm": 3}),
    "Weave, sand": ("#b7a283", {"kind": "woven", "second_color": "#d8c9ae", "roughness": 0.9, "scale_mm": 4}),
    "Velvet, green": ("#1f5a41", {"kind": "velvet", "roughness": 0.9, "scale_mm": 5}),
}
ADDED = ("colourway",)


class Dresser:
    """The elements of one design; new ones get the ids after the largest one."""

    def __init__(self, elements):
        own = next(e for e in elements if e["kind"] == "fabric")
        self.elements = [e for e in elements
                         if e["kind"] not in ADDED and (e["kind"] != "fabric" or e["id"] == own["id"])]
        self.own = own
        self.names = {e["id"]: e["name"] for e in self.elements if e["kind"] == "patch"}
        self.fabrics = {}

    def add(self, element):
        number = max(e["id"] for e in self.elements) + 1
        self.elements.append({"id": number, **element})
        return number

    def made_of(self, name):
        color, look = LOOKS[name]
        self.own.update(name=name, color=color, look=look)
        self.fabrics[name] = self.own["id"]

    def fabric(self, name):
        if name not in self.fabrics:
            color, look = LOOKS[name]
            behaviour = {key: value for key, value in self.own.items() if key not in ("id", "name", "color", "look")}
            self.fabrics[name] = self.add({**behaviour, "name": name, "color": color, "look": look})
        return self.fabrics[name]

    def colourway(self, name, fabric, **others):
        """`others`: fabrics of the patches that have this word in their names."""
        entries = []
        for patch, words in self.names.items():
            shown = next((other for word, other in others.items() if word in words.split()), fabric)
            entries.append({"patch": patch, "fabric": self.fabric(shown)})
        self.add({"kind": "colourway", "name": name, "fabrics": entries})

    def trim(self, trim_of):
        """`trim_of`: from the words in the names of a seam's two patches to its trim, or None."""
        for seam in (e for e in self.elements if e["kind"] == "seam"):
            words = [set(self.names[seam[side]["patch"]].split()) for side in "ab"]
            seam.pop("trim", None)
            trim = trim_of(*words)
            if trim:
                seam["trim"] = trim


def car_seat_trim(a, b):
    words = a | b
    if {"insert", "bolster"} <= words:
        return {"stitch": "twin", "thread": "#b4aea2"}
    if {"bolster", "side"} <= words or {"insert", "front"} <= words or {"insert", "top"} <= words:
        return {"stitch": "single", "thread": "#b4aea2"}
    return None


def armchair_trim(a, b):
    words = a | b
    if "front" in words and "Arm" in words:
        return {"piping_radius_mm": 4}
    if "Underside" in words or "underside" in words or "rear" in words:
        return None
    return {"stitch": "single", "thread": "#d9b98c", "stitch_length_mm": 6, "stitch_distance_mm": 5}


def box_cushion_trim(a, b):
    return {"piping_radius_mm": 4.5} if "Top" in a | b else None


def dress(name, made_of, trim_of, colourways):
    path = SAMPLES / name
    design = read(path)
    dresser = Dresser(design["elements"])
    dresser.made_of(made_of)
    dresser.trim(trim_of)
    for title, fabric, others in colourways:
        dresser.colourway(title, fabric, **others)
    write(path, dresser.elements, design["settings"]["edge_length"])


def main():
    for name in ("car-seat/car-seat.json", "car-seat/car-seat-g1.json", "car-seat-cushioned/car-seat-cushioned.json"):
        dress(name, "Leather, graphite", car_seat_trim,
              [("Cognac", "Leather, cognac", {}), ("Sport", "Leather, graphite", {"insert": "Weave, grey"}),
               ("Cream", "Leather, cream", {})])
    dress("armchair/armchair.json", "Leather, cognac", armchair_trim,
          [("Blue weave", "Weave, blue", {}), ("Green velvet", "Velvet, green", {}),
           ("Dark brown leather", "Leather, dark brown", {})])
    dress("box-cushion/box-cushion.json", "Weave, sand", box_cushion_trim,
          [("Blue", "Weave, blue", {}), ("Cognac leather", "Leather, cognac", {})])


if __name__ == "__main__":
    main()
