"""Says where the rooms of the house are not in order: folders that are too full, folders whose includes form a cycle,
headers of one name, and sources that do not begin with their own header.

    check_rooms.py SOURCE_FOLDER [--figures]
"""
import collections
import pathlib
import re
import shutil
import subprocess
import sys

TOPS = ("model", "solver", "widgets", "app")
MOST_FILES = 32  # headers and sources of a folder


def code_files(root):
    for top in TOPS:
        yield from sorted(p for p in (root / top).rglob("*") if p.suffix in (".h", ".cpp"))


def included_names(file):
    for line in file.read_text(encoding="utf-8").splitlines():
        if found := re.match(r'\s*#include "([^"]+)"', line):
            yield found.group(1).rsplit("/", 1)[-1]


def graph_of(root, files):
    """Folder -> folders it includes from -> one such include."""
    home = {file.name: file.parent for file in files if file.suffix == ".h"}
    graph = collections.defaultdict(dict)
    for file in files:
        for name in included_names(file):
            target = home.get(name, file.parent)
            if target != file.parent:
                graph[file.parent][target] = f"{file.relative_to(root)} includes {name}"
    return graph


def cycles(graph):
    """Groups of folders of which each can be reached from each (Tarjan)."""
    number, low, stack, found = {}, {}, [], []

    def visit(node):
        number[node] = low[node] = len(number)
        stack.append(node)
        for target in graph.get(node, ()):
            if target not in number:
                visit(target)
                low[node] = min(low[node], low[target])
            elif target in stack:
                low[node] = min(low[node], number[target])
        if low[node] == number[node]:
            group = []
            while not group or group[-1] != node:
                group.append(stack.pop())
            if len(group) > 1:
                found.append(group)

    for node in list(graph):
        if node not in number:
            visit(node)
    return found


def problems_of(root):
    files = list(code_files(root))
    for folder, count in sorted(collections.Counter(file.parent for file in files).items()):
        if count > MOST_FILES:
            yield f"{folder.relative_to(root)} has {count} files: at most {MOST_FILES}, else nobody finds anything"
    for name, count in sorted(collections.Counter(f.name for f in files if f.suffix == ".h").items()):
        if count > 1:
            yield f"{count} headers are called {name}: which one is included is a matter of luck"
    for file in files:
        if file.suffix == ".cpp" and file.with_suffix(".h").exists():
            first = next(included_names(file), "")
            if first != file.stem + ".h":
                yield f"{file.relative_to(root)} begins with {first}: whether its own header compiles alone is not seen"
    graph = graph_of(root, files)
    for group in cycles(graph):
        yield "These folders include each other in a circle: " + ", ".join(
            str(folder.relative_to(root)) for folder in sorted(group))
        for folder in sorted(group):
            for target in sorted(set(graph[folder]) & set(group)):
                yield "    " + graph[folder][target]


def print_figures(root):
    files = list(code_files(root))
    for folder, count in sorted(collections.Counter(file.parent for file in files).items()):
        print(f"{count:4} {folder.relative_to(root)}")
    print(f"{len(cycles(graph_of(root, files)))} cycles")
    lengths = [len(file.read_text(errors="replace").splitlines()) for file in files]
    print(f"{len(files)} headers and sources, {sum(lengths)} lines, {spread(lengths)}; over 300: {over(lengths, 300)}")
    functions = function_lengths(files)
    if functions:
        print(f"{len(functions)} functions of lines {spread(functions)}; over 30: {over(functions, 30)}")


def spread(lengths):
    ordered = sorted(lengths)
    return f"median {ordered[len(ordered) // 2]}, 90th percentile {ordered[len(ordered) * 9 // 10]}"


def over(lengths, most):
    return sum(length > most for length in lengths)


def function_lengths(files):
    """As universal-ctags sees them; none where it is not installed."""
    if not shutil.which("ctags"):
        return []
    tags = subprocess.run(["ctags", "-f", "-", "--languages=C++", "--langmap=C++:.cpp.h", "--kinds-C++=f", "--fields=ne", "-L", "-"],
                          input="\n".join(map(str, files)), capture_output=True, text=True, check=True).stdout
    found = re.findall(r"\bline:(\d+).*\bend:(\d+)", tags)
    return [int(end) - int(first) + 1 for first, end in found]


if __name__ == "__main__":
    source = pathlib.Path(sys.argv[1]).resolve()
    if "--figures" in sys.argv:
        print_figures(source)
    problems = list(problems_of(source))
    print("\n".join(problems))
    sys.exit(bool(problems))
