#!/usr/bin/env python3
"""The index of the samples names every sample in all languages of the program, and each has its credit. Nothing in a sample has the
name of something else.

    check_index.py SAMPLES_FOLDER
"""

import json
import sys
from pathlib import Path


# As QLocale names them: without the country.
LANGUAGES = ("de", "es", "fr", "it", "ja", "pl", "zh")


def check_names(path):
    """Of a kind, no two elements have the same name."""
    elements = json.loads(path.read_text(encoding="utf-8"))["elements"]
    names = [(e["kind"], e["name"]) for e in elements if e.get("name")]
    assert len(set(names)) == len(names), (path, sorted(n for n in set(names) if names.count(n) > 1))


def main():
    folder = Path(sys.argv[1])
    index = json.loads((folder / "samples.json").read_text(encoding="utf-8"))
    listed = {entry["file"] for entry in index}
    present = {str(path.relative_to(folder)) for path in folder.glob("*/*.json")}
    assert listed == present, listed ^ present
    for entry in index:
        for texts in (entry, *(entry[language] for language in LANGUAGES)):
            assert texts["title"] and texts["description"], entry
        check_names(folder / entry["file"])
        assert (folder / entry["file"]).with_name("CREDIT.md").is_file(), entry["file"]


if __name__ == "__main__":
    main()
