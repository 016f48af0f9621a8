#!/usr/bin/env python3
"""Fails when a string of the sources has no finished translation, or one with other placeholders.

    check_translations.py FILE.ts LUPDATE OPTION...

A copy of the file is brought up to date, so the committed translations stay as they are.
"""

import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path


def placeholders(text):
    return sorted(re.findall(r"%(?:L?\d+|n)", text))


def problems_of(context, message):
    source = message.findtext("source")
    translation = message.find("translation")
    if message.get("numerus") == "yes":
        forms = [form.text or "" for form in translation.findall("numerusform")]
    else:
        forms = [translation.text or ""]
    if translation.get("type") == "unfinished" or not all(forms):
        return ["no translation"]
    found = [] if context else ["no context: call tr() by the name of its class"]
    if any(placeholders(form) != placeholders(source) for form in forms):
        found.append("other placeholders")
    if any(form.endswith("...") != source.endswith("...") for form in forms):
        found.append("'...' at one end only")
    return found


# Words of these are translated by such a name: tables, and helpers that declare it.
BY_NAME = {"ContextMenus", "CoverSelectTool", "ElementsModel", "SweepWindow"}


def strays(names):
    """Contexts of functions outside of a class that call its tr(): at run time it has the namespace in its name."""
    return sorted(name for name in names if f"bolster::{name}" in names and name not in BY_NAME)


def check(ts_file, lupdate):
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / ts_file.name
        shutil.copyfile(ts_file, copy)
        subprocess.run([*lupdate, "-ts", copy], check=True)
        root = ElementTree.parse(copy).getroot()
    count = bad = 0
    for name in strays({context.findtext("name") for context in root.iter("context")}):
        bad += 1
        print(f"{ts_file.name}: {name}: write bolster::{name}::tr() outside of the class")
    for context in root.iter("context"):
        name = context.findtext("name")
        for message in context.iter("message"):
            count += 1
            for problem in problems_of(name, message):
                bad += 1
                print(f"{ts_file.name}: {name}: {problem}: {message.findtext('source')!r}")
    print(f"{ts_file.name}: {count} strings, {bad} problems")
    return count > 0 and bad == 0


def main():
    return 0 if check(Path(sys.argv[1]), sys.argv[2:]) else 1


if __name__ == "__main__":
    sys.exit(main())
