"""A unity build compiles sources of a folder as one: a helper that shares its name with another source's helper,
or with what a header of the folder declares, may be called in its place without a word. No such pair may exist.

unity_names.py LOADER_DIR TESTS_DIR: folders of tests are those with the name of a folder of LOADER_DIR.
"""
import collections
import pathlib
import re
import sys

# Functions and constants that begin at the left margin, as all of ours do.
DEFINED = re.compile(r"^(?!return|else|case|using|namespace|template|struct|class|enum|static_assert|//|#)"
                     r"[A-Za-z_][\w:<>,&*\[\]\s]*?[\s&*](\w+)\s*(?:\(|=[^=]|\{|\[)", re.M)


def unnamed(text):
    """The text inside of unnamed namespaces."""
    return "".join(re.findall(r"^namespace \{\n(.*?)^\}  // namespace$", text, re.M | re.S))


def names(text):
    # Types and aliases of one name are a compile error, or the same.
    return set(DEFINED.findall(text)) - {"main"}  # GLSL in a string


faults = []
loader, tests = map(pathlib.Path, sys.argv[1:])
folders = sorted(path for path in loader.iterdir() if path.is_dir())
for folder in folders + [tests / path.name for path in folders]:
    helpers = collections.defaultdict(set)
    for source in sorted(folder.rglob("*.cpp")):
        if "codecs" in source.parts:
            continue  # a library of its own
        for name in names(unnamed(source.read_text())):
            helpers[name].add(source)
    declared = collections.defaultdict(set)
    for header in folder.rglob("*.h"):
        for name in names(header.read_text()):
            declared[name].add(header)
    for name, sources in sorted(helpers.items()):
        places = sorted(sources) + sorted(declared[name])
        if len(places) > 1:
            faults.append(f"{name}: " + ", ".join(str(p) for p in places))
print("\n".join(faults))
sys.exit(1 if faults else 0)
