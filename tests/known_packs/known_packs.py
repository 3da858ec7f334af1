#!/usr/bin/env python3
"""Validates every shader pack of some folders and writes what came out as a table.

    tests/known_packs/known_packs.py ~/packs --out docs/known-packs.md

A folder holds packs: folders with shaders/ in them, or zips. Nothing is downloaded. A file of names
(--names) may say what a pack is called in public and which revision it is, one pack a line:

    Base-330 shaderLABS/Base-330 320d05a

Without it a pack has the name of its folder; its revision is the git commit of the folder if it is a
checkout, else the first digits of a hash of its shaders. Exit status: 1 when a pack has an error.

    tests/known_packs/known_packs.py --list packs.tsv --keep results --out docs/known-packs.md

takes the packs from a list instead, one a line, cells separated by tabs: folder, public name, revision,
and what a reader of the sources found about the errors. They are validated with default options, not
drawn, and a table of them replaces that below the last heading of the page. --keep keeps the JSON of
each; what is there already is not run again.
"""
import argparse
import hashlib
import json
import os
import pathlib
import subprocess
import sys
import time
import zipfile
from dataclasses import dataclass, field

ROOT = pathlib.Path(__file__).resolve().parents[2]
INTRO = """# Known packs

Public shader packs, validated. Written by
[tests/known_packs/known_packs.py](../tests/known_packs/known_packs.py) over a folder of packs; nothing
of a pack is in this repository.

"Programs" are those that Iris would load with default options, over all dimensions, and how many of
them compile and link, with glslang and, where "draw" says yes, with the driver; those of other mods
are checked but never drawn. "Profiles" counts the profiles of the pack of which every program does.
"Draw" is one frame of a small world in each dimension; a program beyond a limit of this driver is left
out and named. "-" was not tried in this run. "Warnings" are those with default options, without the
notes that `--verbose` adds. Seconds are wall time on {cores} cores, whatever else ran on them. Errors
were compared with the packs' sources: each is one that Iris or this driver gives too.

Driver: {driver}.
"""


@dataclass
class Result:
    programs: int = 0
    good: int = 0
    mods: dict = field(default_factory=dict)
    errors: list = field(default_factory=list)
    limits: list = field(default_factory=list)
    warnings: int = 0
    absent: int = 0
    folders: int = 1
    seconds: float = 0.0
    crashed: str = ""

    @property
    def clean(self):
        return not self.crashed and not self.errors


def find_packs(folder):
    for path in sorted(pathlib.Path(folder).iterdir(), key=lambda p: p.name.lower()):
        if path.suffix == ".zip" or any(path.glob("shaders")):
            yield path


def revision(path):
    """The commit of a checkout, or a hash of what the pack holds."""
    if (path / ".git").exists():
        done = subprocess.run(["git", "-C", path, "rev-parse", "--short=12", "HEAD"],
                              capture_output=True, text=True, check=False)
        if done.returncode == 0:
            return done.stdout.strip()
    digest = hashlib.sha256()
    if path.is_file():
        with zipfile.ZipFile(path) as archive:
            for name in sorted(archive.namelist()):
                digest.update(name.encode() + archive.read(name))
    else:
        for file in sorted(p for p in (path / "shaders").rglob("*") if p.is_file()):
            digest.update(file.relative_to(path).as_posix().encode() + file.read_bytes())
    return "sha256:" + digest.hexdigest()[:12]


def read_names(path):
    names = {}
    for line in pathlib.Path(path).read_text().splitlines() if path else []:
        words = line.split("#")[0].split()
        if words:
            names[words[0]] = (words[1] if len(words) > 1 else words[0],
                               words[2][:12] if len(words) > 2 else None)
    return names


def orris(args, *more):
    """The JSON that a command printed; a text that says why there is none."""
    try:
        done = subprocess.run([args.orris, *map(str, more), "--json"], capture_output=True,
                              text=True, timeout=args.timeout, check=False)
    except subprocess.TimeoutExpired:
        return f"took longer than {args.timeout} s"
    try:
        return json.loads(done.stdout)
    except json.JSONDecodeError:
        last = done.stderr.strip().splitlines()
        return f"exit status {done.returncode}" + (": " + last[-1] if last else "")


def describe(diagnostic):
    place = diagnostic["file"] + (f":{diagnostic['line']}" if diagnostic["line"] else "")
    return f"{place}: {diagnostic['message']}"


def validate(args, path, profile=None):
    flags = ["--draw"] if args.draw else []
    if profile:
        flags += ["--profile", profile]
    begin = time.monotonic()
    answer = orris(args, "validate", path, *flags)
    result = read_answer(answer)
    result.seconds = time.monotonic() - begin
    return result


def read_answer(answer):
    result = Result()
    if isinstance(answer, str):
        result.crashed = answer
        return result
    pack = answer["packs"][0]
    result.programs = len(pack["programs"])
    result.good = result.programs - len(pack["failed"])
    result.mods = {mod["name"]: (len(mod["programs"]) - len(mod["failed"]), len(mod["programs"]))
                   for mod in pack.get("mods", [])}
    result.folders = len(pack["folders"])
    for diagnostic in pack["diagnostics"]:
        if diagnostic["severity"] == "error":
            result.errors.append(describe(diagnostic))
        elif diagnostic["id"] in ("target-limit", "draw-timeout"):
            result.limits.append(describe(diagnostic))
        elif diagnostic["severity"] == "warning":
            result.warnings += 1
            result.absent += diagnostic["id"] == "texture-missing"
    return result


def profile_names(args, path):
    answer = orris(args, "options", path)
    profiles = [] if isinstance(answer, str) else answer.get("profiles", [])
    return [p if isinstance(p, str) else p["name"] for p in profiles]


def counts(result):
    text = f"{result.good}/{result.programs}"
    return "".join([text, *(f", {good}/{all} {mod}" for mod, (good, all) in result.mods.items())])


def reason(default, profiles):
    """The first cause of each kind that a reader should know."""
    causes = []
    for name, result in [("", default), *profiles.items()]:
        where = f"{name}: " if name else ""
        for text in [result.crashed, *result.errors[:1], *result.limits[:1]]:
            if text and not any(text in other for other in causes):
                causes.append(where + text)
    if default.absent:
        causes.insert(0, f"this copy lacks {default.absent} of its textures")
    more = len(causes) - 3
    return "; ".join(causes[:3]) + (f"; and {more} more" if more > 0 else "")


def row(name, rev, default, profiles, draw):
    clean = sum(result.clean for result in profiles.values())
    drawn = "no" if default.crashed or default.errors else "yes"
    seconds = default.seconds + sum(result.seconds for result in profiles.values())
    cells = [name, f"`{rev}`", counts(default), f"{clean}/{len(profiles)}" if profiles else "-",
             drawn if draw else "-", str(default.warnings), f"{seconds:.0f}",
             reason(default, profiles).replace("|", "\\|")]
    return "| " + " | ".join(cells) + " |"


def listed_row(args, line):
    """Validates a pack of the list; the row of its table, and whether it has errors."""
    path, name, rev, word = (line.rstrip("\n").split("\t") + [""] * 3)[:4]
    kept = pathlib.Path(args.keep, name.replace("/", "+") + ".json") if args.keep else None
    if kept and kept.exists():
        answer = json.loads(kept.read_text())
    else:
        answer = orris(args, "validate", path)
        if kept and not isinstance(answer, str):
            kept.write_text(json.dumps(answer))
    result = read_answer(answer)
    errors = len(result.errors) if not result.crashed else 1
    text = [result.crashed or (result.errors[0] if errors else "")] + [word] * bool(word)
    cells = [name, f"`{rev[:12]}`", counts(result), "passes" if result.clean else "fails",
             str(errors), str(result.warnings), "; ".join(filter(None, text)).replace("|", "\\|")]
    print(f"{name}: {counts(result)}, {errors} errors", flush=True)
    return "| " + " | ".join(cells) + " |", not result.clean


def write_list(args):
    lines = pathlib.Path(args.list).read_text().splitlines()
    rows = [listed_row(args, line) for line in lines if line.strip()]
    table = ["| pack | revision | programs | status | errors | warnings | the first error, and what it is |",
             "| --- | --- | --- | --- | --- | --- | --- |", *(row for row, _ in rows)]
    if args.out:
        page = pathlib.Path(args.out).read_text()
        start = page.index("\n| ", page.rindex("\n## "))
        pathlib.Path(args.out).write_text(page[:start + 1] + "\n".join(table) + "\n")
    print(f"{sum(bad for _, bad in rows)} of {len(rows)} packs have errors")
    return 1 if any(bad for _, bad in rows) else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="*", metavar="FOLDER", help="folder that holds packs")
    parser.add_argument("--list", help="file of packs, see above")
    parser.add_argument("--keep", help="folder for the JSON of the packs of a list")
    parser.add_argument("--orris", default=ROOT / "build/release/orris", help="the program to run")
    parser.add_argument("--names", help="file of public names and revisions")
    parser.add_argument("--out", help="Markdown file to write")
    parser.add_argument("--driver", default="Mesa llvmpipe (OSMesa)", help="what to call the driver")
    parser.add_argument("--no-draw", dest="draw", action="store_false", help="compile only")
    parser.add_argument("--no-profiles", dest="profiles", action="store_false",
                        help="default options only")
    parser.add_argument("--timeout", type=int, default=900, help="seconds that one run may take")
    args = parser.parse_args()
    if args.list:
        return write_list(args)

    names = read_names(args.names)
    rows, failed = [], 0
    for path in (pack for folder in args.folders for pack in find_packs(folder)):
        name, rev = names.get(path.name, (path.name, None))
        default = validate(args, path)
        chosen = profile_names(args, path) if args.profiles else []
        profiles = {profile: validate(args, path, profile) for profile in chosen}
        rows.append(row(name, rev or revision(path), default, profiles, args.draw))
        bad = [r for r in [default, *profiles.values()] if not r.clean]
        failed += bool(bad)
        print(f"{name}: {counts(default)}, {len(bad)} of {1 + len(profiles)} runs with errors, "
              f"{default.warnings} warnings", flush=True)
        for result in bad:
            print("  " + (result.crashed or result.errors[0]), flush=True)
    table = ["| pack | revision | programs | profiles | draw | warnings | s | remarks |",
             "| --- | --- | --- | --- | --- | --- | --- | --- |", *rows]
    if args.out:
        cores = len(os.sched_getaffinity(0))
        intro = INTRO.format(cores=cores, driver=args.driver)
        pathlib.Path(args.out).write_text(intro + "\n" + "\n".join(table) + "\n")
    print("\n".join(table))
    return 1 if failed or not rows else 0


if __name__ == "__main__":
    sys.exit(main())
