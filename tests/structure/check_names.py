"""Says which types there are twice: two definitions of one qualified name in two files. To the linker they are one type,
and the program does whatever it likes; no compiler sees both. (The preset odr asks GCC's link-time optimiser, which knows
templates and macros too, and takes ten minutes for it.)

    check_names.py SOURCE_FOLDER
"""
import collections
import pathlib
import re
import sys

TOPS = ("model", "solver", "widgets", "app", "tests")
# Everything whose braces are not code.
NOISE = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'|^[ \t]*#(?:\\\n|[^\n])*',
                   re.DOTALL | re.MULTILINE)
DIGITS = re.compile(r"(?<=\d)'(?=\d)")
# What opens a brace: the text since the last brace or semicolon.
NAMESPACE = re.compile(r"namespace(?:\s+([\w:]+))?\s*$")
TYPE = re.compile(r"\b(?:struct|class|union|enum(?:\s+(?:class|struct))?)\s+(?:\[\[\w+\]\]\s*)?"
                  r"([A-Za-z_][\w:]*(?:<[^{}()]*>)?)(?:\s+final)?\s*(?::[^{}()]*(?:\([^{}]*\)[^{}()]*)*)?$")


def types_of(text):
    """The qualified names of the types that are defined at the level of namespaces; nothing of unnamed ones."""
    text = NOISE.sub(" ", DIGITS.sub("", text))
    scopes = []  # a name for each namespace that is open; None inside of which nothing is looked at
    begin = 0
    for place in re.finditer(r"[{};]", text):
        head, begin = text[begin:place.start()].strip(), place.end()
        if place.group() == "}":
            if scopes:
                scopes.pop()
        elif place.group() == "{":
            if None in scopes:
                scopes.append(None)
            elif found := NAMESPACE.search(head):
                scopes.append(found.group(1))
            else:
                if found := TYPE.search(head):
                    yield "::".join([*scopes, re.sub(r"\s+", " ", found.group(1))])
                scopes.append(None)


def problems_of(root):
    homes = collections.defaultdict(set)
    for top in TOPS:
        for file in sorted((root / top).rglob("*")):
            if file.suffix in (".h", ".cpp"):
                for name in types_of(file.read_text(encoding="utf-8")):
                    homes[name].add(str(file.relative_to(root)))
    if len(homes) < 500:
        yield f"Only {len(homes)} types were found: this check is broken"
    for name, files in sorted(homes.items()):
        if len(files) > 1:
            yield f"{name} is defined in " + " and in ".join(sorted(files))


if __name__ == "__main__":
    problems = list(problems_of(pathlib.Path(sys.argv[1]).resolve()))
    print("\n".join(problems))
    sys.exit(bool(problems))
