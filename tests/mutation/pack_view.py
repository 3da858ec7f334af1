"""What the faults need to know of a pack: its lines, which of them reach a driver, its options."""
import json
import os
import re
import shutil
import subprocess
import tempfile
from bisect import bisect_left
from collections import Counter
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

TEXT_SUFFIXES = (".vsh", ".fsh", ".gsh", ".csh", ".tcs", ".tes", ".glsl", ".inc", ".h", ".settings",
                 ".properties", ".lang", ".txt", ".json", ".mcmeta")
GLSL_SUFFIXES = TEXT_SUFFIXES[:10]
TIMEOUT = 120


@dataclass(frozen=True)
class Fault:
    """One line replaced, so that no other line changes its number.

    `also` are further lines of the same edit (a name changed throughout a file); `ends` are lines
    that name the same place as well (the other brace, the other #endif), or pairs of file and line
    elsewhere; `options` are settings under which the fault shows; `moved` is a new name of the file.
    """
    kind: str
    file: str
    line: int
    text: str
    also: tuple = ()
    ends: tuple = ()
    options: tuple = ()
    moved: str = ""


class Orris:
    """The program under test."""

    def __init__(self, path):
        self.path = str(Path(path).resolve())

    def options(self, pack):
        done = subprocess.run([self.path, "options", str(pack), "--json"], capture_output=True,
                              timeout=TIMEOUT)
        return json.loads(done.stdout).get("options", [])

    def validate(self, pack, settings=(), folder=None, patched=None):
        """The diagnostics of all folders or of one, in the order of the report; None: no answer."""
        command = [self.path, "validate", str(pack), "--json", "--jobs", "1"]
        for setting in settings:
            command += ["--set", setting]
        if folder:
            command += ["--dimensions", folder]
        if patched:
            command += ["--patched", str(patched)]
        try:
            done = subprocess.run(command, capture_output=True, timeout=TIMEOUT)
            return [diagnostic for pack in json.loads(done.stdout)["packs"]
                    for diagnostic in pack["diagnostics"]]
        except (subprocess.TimeoutExpired, ValueError, KeyError):
            return None


def temporary_folder():
    """What a killed child of `orris` still writes must not stop the run."""
    return tempfile.TemporaryDirectory(prefix="orris-mutation-", ignore_cleanup_errors=True)


def find_packs(folder):
    """Name -> folder that holds `shaders`, of each pack in `folder` or one level below."""
    found = {}
    for entry in sorted(Path(folder).iterdir()):
        if (entry / "shaders").is_dir():
            found[entry.name] = entry
        elif entry.is_dir():
            for inner in sorted(entry.iterdir()):
                if (inner / "shaders").is_dir():
                    found[f"{entry.name}/{inner.name}"] = inner
    return found


def copy_pack(source, target):
    """Any file may be included, so that any may hold the fault: none is shared with the source."""
    shutil.copytree(source / "shaders", Path(target) / "shaders", copy_function=shutil.copyfile)


def read_lines(path):
    """The lines without their ends; bytes survive whatever they mean."""
    return path.read_bytes().decode("latin-1").split("\n")


def blank_comments(lines):
    """The lines with comments replaced by blanks, columns kept."""
    result, inside = [], False
    for line in lines:
        out, i = [], 0
        while i < len(line):
            pair = line[i:i + 2]
            if inside:
                inside = pair != "*/"
                step = 1 if inside else 2
                out.append(" " * step)
            elif pair == "/*":
                inside, step = True, 2
                out.append("  ")
            elif pair == "//":
                step = len(line) - i
                out.append(" " * step)
            else:
                step = 1
                out.append(line[i])
            i += step
        result.append("".join(out).replace("\r", " "))
    return result


class SourceFile:
    """A GLSL file: `lines` as written, `code` without comments, `directive` by line."""

    def __init__(self, path):
        self.lines = read_lines(path)
        self.code = blank_comments(self.lines)
        self.directive, continued = [], False
        for text in self.code:
            self.directive.append(continued or text.lstrip().startswith("#"))
            continued = self.directive[-1] and text.rstrip().endswith("\\")

    @cached_property
    def depth(self):
        """Braces open at the start of each line, branches of #if taken as they come."""
        depths, depth = [], 0
        for text, directive in zip(self.code, self.directive):
            depths.append(depth)
            if not directive:
                depth += text.count("{") - text.count("}")
        return depths

    @cached_property
    def groups(self):
        """Each conditional: its directive lines, first the #if, last the #endif."""
        groups, open_groups = [], []
        for number, text in enumerate(self.code, 1):
            found = re.match(r"\s*#\s*(if|ifdef|ifndef|elif|else|endif)\b", text)
            if not found or not self.directive[number - 1]:
                continue
            word = found.group(1)
            if word.startswith("if"):
                open_groups.append([number])
            elif open_groups:
                open_groups[-1].append(number)
                if word == "endif":
                    groups.append(open_groups.pop())
        return sorted(groups)

    @cached_property
    def branches(self):
        """First and last line of the innermost branch that holds each line."""
        branches = [(1, len(self.lines))] * (len(self.lines) + 1)
        # Sorted by first line: an inner conditional comes after the one around it.
        for group in self.groups:
            for first, after in zip(group, group[1:]):
                for line in range(first + 1, after):
                    branches[line] = (first + 1, after - 1)
        return branches


class Reach:
    """What reaches a driver: the texts of all stages and the places their lines came from."""

    def __init__(self, folder):
        self.lines, self.stages, self.texts = {}, {}, {}
        self.programs = {}
        for path in sorted(Path(folder).rglob("*.map")):
            name = str(path.relative_to(folder))[:-4]
            program, stage = os.path.splitext(name)
            self.texts[name] = path.with_suffix("").read_bytes().decode("latin-1")
            for row in path.read_bytes().decode("latin-1").split("\n"):
                for place in filter(None, row.split("\t")):
                    file, line = place.rsplit(":", 1)
                    self.lines.setdefault(file, set()).add(int(line))
                    self.stages.setdefault(file, set()).add(stage)
                    self.programs.setdefault(file, set()).add(program)


class PackView:
    """A pristine copy of a pack with what is known of it."""

    def __init__(self, name, source, orris):
        self.name, self.orris = name, orris
        self.folder = temporary_folder()
        self.root = Path(self.folder.name) / "pack"
        copy_pack(source, self.root)
        self.reach = self.reach_with(())
        self.baselines = {}

    def reach_with(self, settings):
        with temporary_folder() as folder:
            self.orris.validate(self.root, settings, patched=folder)
            return Reach(folder)

    def path(self, file):
        return self.root / "shaders" / file.lstrip("/")

    @cached_property
    def files(self):
        shaders = self.root / "shaders"
        return ["/" + str(p.relative_to(shaders)) for p in sorted(shaders.rglob("*"))
                if p.is_file() and p.suffix in TEXT_SUFFIXES]

    @cached_property
    def sources(self):
        """The GLSL files that reach a driver; of stages that the host adds there is none."""
        return {file: SourceFile(self.path(file)) for file in sorted(self.reach.lines)
                if self.path(file).is_file()}

    @cached_property
    def lines_in_use(self):
        """File and number of each line whose branch has lines that reach a driver."""
        rows = []
        for file, source in self.sources.items():
            reached = sorted(self.reach.lines[file])
            for number in range(1, len(source.lines) + 1):
                first, last = source.branches[number]
                at = bisect_left(reached, first)
                if at < len(reached) and reached[at] <= last:
                    rows.append((file, number))
        return rows

    @cached_property
    def words(self):
        """Every word of the pack: no misspelling may be one of them."""
        words = set()
        for file in self.files:
            words.update(re.findall(r"\w+", self.path(file).read_bytes().decode("latin-1")))
        return words

    @cached_property
    def options(self):
        """Name -> what `orris options` says of it."""
        return {option["name"]: option for option in self.orris.options(self.root)}

    def properties(self, name):
        """Number and text of the lines of a properties file that stand under no condition."""
        path = self.path("/" + name)
        if not path.is_file():
            return []
        rows, depth, continued = [], 0, False
        for number, text in enumerate(read_lines(path), 1):
            text = text.rstrip("\r")
            word = re.match(r"\s*#\s*(if|ifdef|ifndef|endif)\b", text)
            if word:
                depth += -1 if word.group(1) == "endif" else 1
            whole = not continued and not text.endswith("\\")
            if depth == 0 and whole and text.strip() and text.lstrip()[0] not in "#!":
                rows.append((number, text))
            continued = text.endswith("\\") and not text.lstrip().startswith("#")
        return rows

    def misspell(self, word):
        """A near word that the pack does not contain."""
        swapped = [word[:i] + word[i + 1] + word[i] + word[i + 2:]
                   for i in range(1, len(word) - 2) if word[i] != word[i + 1]]
        return next(w for w in swapped[len(swapped) // 2:] + [word + "q", word + "qz"]
                    if w not in self.words and not w[0].isdigit())

    def baseline(self, settings, folder):
        key = settings, folder
        if key not in self.baselines:
            self.baselines[key] = self.orris.validate(self.root, settings, folder)
        return self.baselines[key]

    def folder_of(self, file):
        """The smallest program folder that the file reaches, or of all; None when there is but one."""
        def folder(program):
            return program.rpartition("/")[0]
        sizes = Counter(map(folder, set().union(*self.reach.programs.values())))
        reached = set(map(folder, self.reach.programs.get(file, ()))) or set(sizes)
        if "" in sizes or len(sizes) < 2:
            return None
        return min(reached, key=lambda name: (sizes[name], name))
