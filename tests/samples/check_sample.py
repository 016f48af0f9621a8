#!/usr/bin/env python3
"""Checks and solves one sample with the command line, and looks at what came out.

    check_sample.py BOLSTER SAMPLE.json
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

SIZES = {  # width, depth, height of the cover in mm, and how far it may be off
    "armchair": ((822, 917, 873), 0.05),
    "box-cushion": ((500, 500, 170), 0.05),
    "pillow": ((575, 370, 185), 0.08),
}

SEATS = ("armchair", "armchair-scan", "car-seat", "car-seat-g1", "car-seat-cushioned", "car-seat-scan")


def run(*command):
    result = subprocess.run(command, capture_output=True, text=True)
    assert result.returncode == 0, f"{command} ended with {result.returncode}:\n{result.stdout}{result.stderr}"
    assert "warning:" not in result.stderr, f"{command} warns:\n{result.stderr}"


def check_report(report, design):
    patches = sum(e["kind"] == "patch" for e in design["elements"])
    assert report["status"] == "solved", report
    assert report["left_out"] == [], report["left_out"]
    assert report["patches"] == patches, report["patches"]
    assert report["seam_gap_mm"]["max"] == 0, report["seam_gap_mm"]
    assert report["fixation_error_mm"]["max"] < 1e-6, report["fixation_error_mm"]
    cushions = [e["id"] for e in design["elements"] if e["kind"] == "cushion"]
    assert [c["element"] for c in report["cushions"]] == cushions, report["cushions"]
    assert all(c["voxels"] > 0 and c["vertices"] > 0 for c in report["cushions"]), report["cushions"]
    assert report["flipped_triangles"] == 0, report["flipped_triangles"]
    assert report["strain"]["rms"] < 0.1, report["strain"]
    assert abs(report["area_mm2"] / report["rest_area_mm2"] - 1) < 0.05, report["area_mm2"]


def read_obj(path):
    """Points, and the set of points of each group."""
    points, groups, group = [], {}, None
    for line in path.read_text(encoding="utf-8").splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            points.append([float(w) for w in words[1:4]])
        elif words[:1] == ["g"]:
            group = groups.setdefault(" ".join(words[1:]), set())
        elif words[:1] == ["f"]:
            group.update(int(w.split("/")[0]) - 1 for w in words[1:])
    return points, groups


def check_size(name, points):
    if name not in SIZES:
        return
    expected, tolerance = SIZES[name]
    size = [max(axis) - min(axis) for axis in zip(*points)]
    assert all(abs(s / e - 1) < tolerance for s, e in zip(size, expected)), (size, expected)


def check_front(name, points):
    """Who looks from the front (-y) sees the seat before its back, the highest part."""
    if name not in SEATS:
        return
    low, high = min(p[2] for p in points), max(p[2] for p in points)
    back = [p[1] for p in points if p[2] > low + 0.75 * (high - low)]
    assert sum(back) / len(back) > sum(p[1] for p in points) / len(points) + 50, "its back is in front"


def main():
    bolster, sample = sys.argv[1], Path(sys.argv[2])
    design = json.loads(sample.read_text(encoding="utf-8"))
    run(bolster, "check", sample)
    with tempfile.TemporaryDirectory() as folder:
        obj, report = Path(folder) / "cover.obj", Path(folder) / "report.json"
        run(bolster, "solve", sample, "--obj", obj, "--report", report)
        check_report(json.loads(report.read_text(encoding="utf-8")), design)
        points, groups = read_obj(obj)
        assert len(groups) == sum(e["kind"] == "patch" for e in design["elements"]), list(groups)
        check_size(sample.stem, points)
        check_front(sample.stem, points)


if __name__ == "__main__":
    main()
