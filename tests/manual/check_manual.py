"""Checks the manual: links, anchors and pictures are there, every picture is used, pages are short, every command, window,
panel, form and tool has a place in it, every message of the program is explained, and the list of commands is up to date.

    check_manual.py SOURCE_FOLDER
"""
import importlib.machinery
import importlib.util
import pathlib
import re
import sys
import xml.etree.ElementTree

LONGEST = 300  # lines of a page
MENU_LIKE = re.compile(r"^class (\w+(?:Dialog|Window|Panel|Tool|Form|Section|Palette|Legend|Hint|Cube)) *(?:final *)?:", re.MULTILINE)
# What is no part of its own that somebody could ask about.
BASES = {"ElementForm", "DescribedForm", "PropertyForm", "ViewTool"}
# Names of edits in the history, which warn of nothing, begin with a verb and end without a full stop.
EDITS = set("Add Align Arrange Attach Change Create Cut Distribute Duplicate Fit Flip Give Hide Import Insert Lead Let Make Merge Mirror "
            "Move Paste Place Re-link Release Remove Rename Replace Reverse Rotate Saved Scale Sew Show Smooth Split Straighten "
            "Swap Switch Take Trim Turn Unlink".split())


def slug(heading):
    """The anchor of a heading, as GitHub makes it."""
    text = re.sub(r"[*`\[\]]|\(.*?\.md.*?\)", "", heading.strip()).lower()
    return re.sub(r"[^\w\- ]", "", text).replace(" ", "-")


def prose(text):
    return re.sub(r"```.*?```", "", text, flags=re.DOTALL)


def anchors(page):
    return {slug(line.lstrip("#")) for line in prose(page.read_text(encoding="utf-8")).splitlines() if line.startswith("#")}


class Manual:
    def __init__(self, root):
        self.root, self.folder = root, root / "docs" / "manual"
        self.pages = sorted(self.folder.glob("*.md"))
        self.anchors = {page.name: anchors(page) for page in self.pages}
        self.problems = []

    def say(self, text):
        self.problems.append(text)

    def target(self, where, page, anchor):
        if page not in self.anchors:
            self.say(f"{where}: there is no page {page}")
        elif anchor and anchor not in self.anchors[page]:
            self.say(f"{where}: {page} has no heading #{anchor}")

    def links(self):
        used = set()
        for page in self.pages:
            text = page.read_text(encoding="utf-8")
            for number, line in enumerate(text.splitlines(), 1):
                for picture, target in re.findall(r"(!?)\[[^\]]*\]\(([^)\s]+)\)", line):
                    where = f"{page.name}:{number}"
                    if picture:
                        used.add(target)
                        if not (self.folder / target).is_file():
                            self.say(f"{where}: there is no picture {target}")
                    elif not re.match(r"[a-z]+:", target):
                        name, _, anchor = target.partition("#")
                        self.target(where, name or page.name, anchor)
            if text.count("\n") > LONGEST:
                self.say(f"{page.name} has more than {LONGEST} lines")
            if not re.match(r"# ", text):
                self.say(f"{page.name} does not begin with a heading")
        for picture in sorted([*self.folder.glob("pictures/*"), *self.folder.glob("screens/*")]):
            if (name := picture.relative_to(self.folder).as_posix()) not in used:
                self.say(f"no page shows {name}")
        linked = {target.split("#")[0] for page in self.pages
                  for target in re.findall(r"\]\(([\w-]+\.md[^)]*)\)", page.read_text(encoding="utf-8"))}
        for page in self.pages:
            if page.name != "index.md" and page.name not in linked:
                self.say(f"nothing leads to {page.name}")

    def table(self, name):
        rows = {}
        for number, line in enumerate((self.folder / name).read_text(encoding="utf-8").splitlines(), 1):
            if not line or line.startswith("#"):
                continue
            key, _, target = line.partition("\t")
            page, _, anchor = target.partition("#")
            if key in rows:
                self.say(f"{name}:{number}: {key} is there twice")
            if not anchor:
                self.say(f"{name}:{number}: no heading is named")
            self.target(f"{name}:{number}", page, anchor)
            rows[key] = target
        return rows

    def places(self, commands):
        rows = self.table("places.tsv")
        wanted = dict.fromkeys(commands, "command")
        for top in ("app", "widgets"):
            for header in sorted((self.root / top).rglob("*.h")):
                for name in MENU_LIKE.findall(header.read_text(encoding="utf-8")):
                    if name not in BASES:
                        wanted[name] = "class"
        for name, kind in wanted.items():
            if name not in rows:
                self.say(f"places.tsv: the {kind} {name} has no line")

    def warnings(self):
        rows = self.table("warnings.tsv")
        tree = xml.etree.ElementTree.parse(self.root / "translations" / "bolster_de.ts").getroot()
        known = set()
        for context in tree.findall("context"):
            for message in context.findall("message"):
                if message.find("translation").get("type") in ("vanished", "obsolete"):
                    continue
                text = message.findtext("source").replace("\n", "\\n")
                known.add(text)
                edit = text.split()[0] in EDITS and not text.endswith(".")
                if context.findtext("name") == "Message" and not edit and text not in rows:
                    self.say(f"warnings.tsv: nothing explains \"{text}\"")
        for text in rows:
            if text not in known:
                self.say(f"warnings.tsv: the program does not say \"{text}\" any more")


def load(path):
    loader = importlib.machinery.SourceFileLoader("make_commands", str(path))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("make_commands", loader))
    sys.dont_write_bytecode = True
    loader.exec_module(module)
    return module


def main():
    manual = Manual(pathlib.Path(sys.argv[1]).resolve())
    maker = load(manual.folder / "make-commands")
    commands = maker.commands()
    declared = set()
    for source in sorted((manual.root / "app").rglob("*.cpp")):
        declared.update(re.findall(r'\.id = "([a-z]+\.[a-z0-9-]+)"', source.read_text(encoding="utf-8")))
    for name in sorted(declared - set(commands)):
        manual.say(f"make-commands does not find the command {name}")
    for name in sorted(set(maker.keys()) - set(commands)):
        manual.say(f"make-commands does not find the command {name} of docs/keys.md")
    manual.links()
    manual.places(commands)
    manual.warnings()
    if (manual.folder / "commands.md").read_text(encoding="utf-8") != maker.page():
        manual.say("commands.md is not what docs/manual/make-commands writes: run it")
    for problem in manual.problems:
        print(problem, file=sys.stderr)
    return 1 if manual.problems else 0


if __name__ == "__main__":
    sys.exit(main())
