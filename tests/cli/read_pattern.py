#!/usr/bin/env python3
"""What somebody else's library reads in a DXF that Bolster wrote, as JSON: errors that its audit finds, versions, blocks
with their layers, and what is in model space.   read_pattern.py FILE.dxf"""
import json
import sys

import ezdxf


def entities(space):
    found = []
    for e in space:
        row = {"kind": e.dxftype(), "layer": e.dxf.layer}
        if e.dxftype() == "POLYLINE":
            row["closed"] = bool(e.is_closed)
            row["points"] = [[v.dxf.location.x, v.dxf.location.y] for v in e.vertices]
        elif e.dxftype() == "LWPOLYLINE":
            row["closed"] = bool(e.closed)
            row["points"] = [[x, y] for x, y, *_ in e.get_points()]
        elif e.dxftype() == "SPLINE":
            row["degree"] = e.dxf.degree
            row["points"] = [list(p)[:2] for p in e.flattening(0.0005)]
        elif e.dxftype() == "POINT":
            row["at"] = list(e.dxf.location)
            row["angle"] = e.dxf.get("angle", 0)
            row["thickness"] = e.dxf.get("thickness", 0)
        elif e.dxftype() == "TEXT":
            row["text"] = e.dxf.text
        elif e.dxftype() == "LINE":
            row["points"] = [list(e.dxf.start)[:2], list(e.dxf.end)[:2]]
        elif e.dxftype() == "INSERT":
            row["block"] = e.dxf.name
        elif e.dxftype() == "CIRCLE":
            row["at"] = list(e.dxf.center)
            row["radius"] = e.dxf.radius
        found.append(row)
    return found


document = ezdxf.readfile(sys.argv[1])
audit = document.audit()
print(json.dumps({
    "errors": [str(e.message) for e in audit.errors],
    "fixes": [str(e.message) for e in audit.fixes],
    "version": document.dxfversion,
    "blocks": {b.name: entities(b) for b in document.blocks if not b.name.startswith(("*", "$"))},
    "space": entities(document.modelspace())}))
