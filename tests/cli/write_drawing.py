#!/usr/bin/env python3
"""Writes outlines with somebody else's library, of all entities that its version of DXF has, and prints how many they are
and their area as JSON.   write_drawing.py VERSION FILE.dxf [binary]"""
import json
import math
import sys

import ezdxf

version, file = sys.argv[1:3]
document = ezdxf.new(version)
if version != "R12":
    document.header["$INSUNITS"] = 4
space = document.modelspace()
cut = {"layer": "cut"}

block = document.blocks.new("ROUND")
block.add_line((0, 0), (300, 0))
block.add_arc((300, 100), 100, -90, 90)
block.add_line((300, 200), (0, 200))
block.add_line((0, 200), (0, 0))
space.add_blockref("ROUND", (1000, 0), dxfattribs=cut)
space.add_blockref("ROUND", (3000, 0), dxfattribs=cut | {"xscale": -1, "yscale": 1})
space.add_blockref("ROUND", (4000, 0), dxfattribs=cut | {"xscale": 2, "yscale": 2, "rotation": 30})
areas = [factor * (300 * 200 + math.pi * 100**2 / 2) for factor in (1, 1, 4)]

bulged = [(0, 0, 0), (200, 0, 0.5), (200, 200, 0), (0, 200, 0)]
if version == "R12":
    space.add_polyline2d(bulged, format="xyb", close=True, dxfattribs=cut)
else:
    space.add_lwpolyline(bulged, format="xyb", close=True, dxfattribs=cut)
angle = 4 * math.atan(0.5)
areas.append(200 * 200 + 125**2 / 2 * (angle - math.sin(angle)))

space.add_circle((600, 900), 80, dxfattribs=cut)
space.add_circle((600, 900), 4, dxfattribs={"layer": "drill"})
space.add_text("R\u00fccken", dxfattribs={"insert": (600, 930), "layer": "text"})
areas.append(math.pi * 80**2)

if version != "R12":
    space.add_ellipse((600, 500), (150, 0), 0.5, dxfattribs=cut)
    areas.append(math.pi * 150 * 75)
    spline = space.add_spline(dxfattribs=cut)
    spline.set_closed([(0, 600, 0), (200, 600, 0), (250, 800, 0), (100, 900, 0), (-50, 800, 0)], degree=3)
    points = list(spline.flattening(0.001))
    areas.append(abs(sum(a.x * b.y - a.y * b.x for a, b in zip(points, points[1:] + points[:1]))) / 2)
    space.add_mtext("Sitz \u03a9\\Pcut 2", dxfattribs={"insert": (80, 720), "layer": "text"})

document.saveas(file, fmt="bin" if "binary" in sys.argv else "asc")
print(json.dumps({"pieces": len(areas), "area": sum(areas)}))
