#!/usr/bin/env python3
"""Mutation score of `orris validate`: one fault at a time, in copies of real packs.

A fault is found when an error or warning appears that the pack does not have without it, and located
when one of these stands at the changed file and line, give or take one. A fault that changes no text
that reaches the driver is equivalent: there is nothing to find.
"""
import argparse
import json
import queue
import random
import re
import sys
import time
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict, dataclass
from pathlib import Path

import contract_faults
import directive_faults
import glsl_faults
import properties_faults
from pack_view import (Orris, PackView, Reach, copy_pack, find_packs, read_lines,
                       temporary_folder)

KINDS = {**glsl_faults.KINDS, **directive_faults.KINDS, **properties_faults.KINDS}
# The score stays comparable without these; --once and --kind have them too.
MORE_KINDS = contract_faults.KINDS
VERDICTS = ("found", "missed", "equivalent", "no answer")


@dataclass
class Result:
    """What became of one fault."""
    pack: str
    fault: object
    before: str
    verdict: str = "missed"
    reason: str = ""  # why it is equivalent
    exact: bool = False  # a message at the changed line itself, give or take one
    located: bool = False  # the same, or at the other end of the changed pair
    fixed: bool = False  # elsewhere, and the #include that the report asks for leaves nothing to report
    first: bool = False  # the first message is a located one
    rank: int = 0  # of the first located message among the new ones, from 1; 0: none
    unfolded: int = 0  # new messages that are not folded under another
    messages: tuple = ()


def key(diagnostic):
    """A finding that counts one line more is no new one."""
    message = re.sub(r"\d+ more", "more", diagnostic["message"])
    return (*(diagnostic[part] for part in ("severity", "id", "file", "line")), message)


def new_messages(before, after):
    """Errors and warnings of `after` that `before` lacks, in the order of the report."""
    known = Counter(map(key, before))
    fresh = []
    for diagnostic in after:
        if known[key(diagnostic)] > 0:
            known[key(diagnostic)] -= 1
        elif diagnostic["severity"] != "note":
            fresh.append(diagnostic)
    return fresh


def apply(view, fault, root):
    """Writes the changed file into a copy; returns the line as it was."""
    path = Path(root) / "shaders" / fault.file.lstrip("/")
    lines = read_lines(path)
    before = lines[fault.line - 1]
    for number, text in ((fault.line, fault.text), *fault.also):
        end = "\r" if lines[number - 1].endswith("\r") else ""
        lines[number - 1] = text.rstrip("\r") + end
    path.write_bytes("\n".join(lines).encode("latin-1"))
    if fault.moved:
        path.rename(Path(root) / "shaders" / fault.moved.lstrip("/"))
    return before.rstrip("\r")


def restore(view, fault, root):
    path = Path(root) / "shaders" / fault.file.lstrip("/")
    path.write_bytes(view.path(fault.file).read_bytes())
    if fault.moved:
        (Path(root) / "shaders" / fault.moved.lstrip("/")).unlink()


def keeps_all_but_declarations(before, after):
    """Is `after` the text `before` without some whole declarations at file scope?"""
    kept, depth, lost_at = iter(after.split("\n") + [None]), 0, None
    expected = next(kept)
    for line in before.split("\n"):
        if line == expected:
            if lost_at is not None and lost_at != depth:
                return False
            lost_at, expected = None, next(kept)
        elif line.strip() and lost_at is None:
            if depth > 0:
                return False
            lost_at = depth
        depth += line.count("{") - line.count("}")
    return expected is None


def declarations(text):
    """The pieces of a text at file scope, sorted: their order does not matter where all of it compiles."""
    pieces, piece, depth = [], [], 0
    for line in text.split("\n"):
        piece.append(line.strip())
        depth += line.count("{") - line.count("}")
        if depth == 0 and (line.rstrip().endswith((";", "}")) or line.startswith("#")):
            pieces.append(" ".join(filter(None, piece)))
            piece = []
    return sorted([*pieces, " ".join(filter(None, piece))])


def equivalence(view, fault, root):
    """Why nothing could be found, or "": only texts that reach the driver prove it."""
    nowhere = properties_faults.names_nothing(view, fault)
    in_texts = fault.kind not in (*properties_faults.KINDS, *directive_faults.IN_COMMENTS, *MORE_KINDS)
    if not nowhere and not in_texts:
        return ""
    with temporary_folder() as folder:
        view.orris.validate(root, fault.options, patched=folder)
        texts = Reach(folder).texts
    before = view.reach_with(fault.options).texts if fault.options else view.reach.texts
    if texts == before:
        return nowhere or "no text that reaches the driver changes"
    # Such a text was compiled and linked without a complaint.
    if fault.kind != "include-removed" or texts.keys() != before.keys():
        return ""
    if all(keeps_all_but_declarations(before[name], texts[name]) for name in texts):
        return "the texts lose declarations only, and nothing names what they declared"
    if all(declarations(before[name]) == declarations(texts[name]) for name in texts):
        return "the texts hold the same declarations in another order"
    return ""


def compare(view, fault, root, folder):
    """Verdict with the messages of one folder, or of all when `folder` is None."""
    after = view.orris.validate(root, fault.options, folder)
    if after is None:
        return "no answer", []
    fresh = new_messages(view.baseline(fault.options, folder), after)
    return ("found" if fresh else "missed"), fresh


def fixed_by_includes(view, fault, root, fresh):
    """Does the pack report nothing new with the #include lines that the messages ask for?"""
    asked = {(m["file"], m["line"], m["hint"]) for m in fresh if m["id"] == "include-probably-missing" and m["severity"] == "error"}
    changed = {file: read_lines(Path(root) / "shaders" / file.lstrip("/")) for file, _, _ in asked}
    for file, number, text in sorted(asked, key=lambda place: -place[1]):
        changed[file].insert(number - 1, text)
    for file, lines in changed.items():
        (Path(root) / "shaders" / file.lstrip("/")).write_bytes("\n".join(lines).encode("latin-1"))
    left = compare(view, fault, root, None)[1] if asked else fresh
    for file in changed:
        source = view.path(file)
        (Path(root) / "shaders" / file.lstrip("/")).write_bytes(source.read_bytes())
    return not left


def judge(view, fault, root):
    """One folder is quicker; all are asked when it does not show the fault at its place."""
    result = Result(view.name, fault, apply(view, fault, root))
    file, places = fault.moved or fault.file, (fault.line, *fault.ends)
    folder = view.folder_of(fault.file)
    try:
        fresh = []
        if folder:
            result.verdict, fresh = compare(view, fault, root, folder)
        if not any(near(message, file, places) for message in fresh):
            result.verdict, fresh = compare(view, fault, root, None)
        if result.verdict == "missed":
            result.reason = equivalence(view, fault, root)
            result.verdict = "equivalent" if result.reason else "missed"
        at_place = any(near(message, file, places) for message in fresh)
        result.fixed = bool(fresh) and not at_place and fixed_by_includes(view, fault, root, fresh)
    finally:
        restore(view, fault, root)
    if fresh:
        result.exact = any(near(message, file, (fault.line,)) for message in fresh)
        result.located = any(near(message, file, places) for message in fresh)
        result.rank = next((i for i, message in enumerate(fresh, 1)
                            if near(message, file, places)), 0)
        result.first, result.unfolded = result.rank == 1, len(fresh)
        result.messages = tuple("{file}:{line}: {severity}: {message} [{id}]".format(**message)
                                for message in fresh[:4])
    return result


def near(diagnostic, file, places):
    """Is one of the places of the message there? A number is a line of the file."""
    there = [place if isinstance(place, tuple) else (file, place) for place in places]
    return any(place["file"] == name and abs(place["line"] - line) <= 1
               for place in (diagnostic, *diagnostic["related"]) for name, line in there)


def choose(views, kinds, count, seed):
    """`count` faults, spread over kinds and packs as evenly as the places allow."""
    places = {}
    for view in views:
        for kind in kinds:
            found = list((KINDS | MORE_KINDS)[kind](view))
            random.Random(f"{seed} {view.name} {kind}").shuffle(found)
            if found:
                places[kind, view.name] = found
    chosen, by_name, turns = [], {view.name: view for view in views}, Counter()
    while len(chosen) < count and places:
        for kind in kinds:
            rows = [entry for entry in places if entry[0] == kind]
            if rows and len(chosen) < count:
                # The pack with fewest of this kind, then of all kinds, gives the next one.
                turn = min(rows, key=lambda entry: (turns[entry], turns[entry[1]]))
                turns.update((turn, turn[1]))
                chosen.append((by_name[turn[1]], places[turn].pop()))
                if not places[turn]:
                    del places[turn]
    return chosen


class Copies:
    """Copies of packs for the threads: one of each pack for each thread at work on it."""

    def __init__(self, folder, seconds):
        self.folder, self.free, self.made = Path(folder), {}, 0
        self.end = time.monotonic() + seconds

    def judge(self, job):
        """None: the time is over."""
        if time.monotonic() > self.end:
            return None
        view, fault = job
        free = self.free.setdefault(view.name, queue.SimpleQueue())
        try:
            root = free.get_nowait()
        except queue.Empty:
            self.made += 1
            root = self.folder / f"{self.made}-{view.name.replace('/', '-')}"
            copy_pack(view.root, root)
        result = judge(view, fault, root)
        free.put(root)
        elsewhere = result.verdict == "found" and not (result.located or result.fixed)
        print(f"{'found elsewhere' if elsewhere else result.verdict}: {fault.kind} "
              f"{view.name}{fault.file}:{fault.line}", file=sys.stderr)
        return result


def table(results, name, part):
    rows = {}
    for result in results:
        rows.setdefault(part(result), []).append(result)
    lines = [f"{name:26} faults equiv  found missed  exact located fixed first"]
    for row, group in [*sorted(rows.items()), ("all", results)]:
        found = [result for result in group if result.verdict == "found"]
        equivalent = sum(result.verdict == "equivalent" for result in group)
        lines.append(f"{row:26} {len(group):6} {equivalent:5} {len(found):6} "
                     f"{len(group) - len(found) - equivalent:6} "
                     f"{sum(result.exact for result in found):6} "
                     f"{sum(result.located for result in found):7} "
                     f"{sum(result.fixed for result in found):5} "
                     f"{sum(result.first for result in found):5}")
    return "\n".join(lines)


def describe(result):
    fault = result.fault
    lines = [f"{result.pack}{fault.file}:{fault.line}: {fault.kind}: {result.verdict}"
             + (f": {result.reason}" if result.reason else ""),
             f"  - {result.before.strip()}", f"  + {fault.text.strip()}"]
    if fault.options:
        lines.append(f"  with {' '.join(fault.options)}")
    return "\n".join(lines + [f"    {message}" for message in result.messages])


def report(results):
    def select(test, title):
        rows = [describe(result) for result in results if test(result)]
        return [f"\n{title}: {len(rows)}", *rows] if rows else []
    print("\n".join([
        *select(lambda r: r.verdict == "equivalent", "equivalent"),
        *select(lambda r: r.verdict in ("missed", "no answer"), "not found"),
        *select(lambda r: r.fixed, "elsewhere, where the #include that the report asks for fixes the pack"),
        *select(lambda r: r.verdict == "found" and not (r.located or r.fixed), "found elsewhere"),
        "", table(results, "kind", lambda r: r.fault.kind), "",
        table(results, "pack", lambda r: r.pack)]))


def once_table(results):
    """Markdown: each mistake, what is said first, its rank and how many messages stand beside it."""
    rows = ["| mistake | at | first message | rank | messages |", "| --- | --- | --- | --- | --- |"]
    for result in sorted(results, key=lambda r: r.fault.kind):
        said = result.messages[0] if result.messages else "-"
        rows.append(f"| {result.fault.kind} | {result.fault.file}:{result.fault.line} | "
                    f"{said.replace('|', '&#124;')} | {result.rank or '-'} | {result.unfolded} |")
    return "\n".join(rows)


def meets_bar(result):
    """Among the first three messages, at its line, with at most three in all."""
    return result.verdict == "equivalent" or (0 < result.rank <= 3 and result.unfolded <= 3)


def run_once(results, skipped, least):
    bad = [result for result in results if not meets_bar(result)]
    print(once_table(results))
    report(bad)
    good = len(results) - len(bad)
    print(f"\n{len(results)} mistakes, one of each kind: {good} are reported at their line among the "
          f"first three messages, with at most three in all")
    if skipped:
        print(f"The pack has no line for: {', '.join(skipped)}")
    return 0 if good >= least else 1


def score(results):
    """Shares in percent: of the faults found; of these located; located or fixed."""
    real = [result for result in results if result.verdict != "equivalent"]
    found = [result for result in real if result.verdict == "found"]
    located = [result for result in found if result.located]
    fixed = [result for result in found if result.fixed]
    some = max(len(found), 1)
    return (100 * len(found) / max(len(real), 1), 100 * len(located) / some,
            100 * (len(located) + len(fixed)) / some)


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("orris")
    parser.add_argument("packs", help="folder of packs; they are copied, never changed")
    parser.add_argument("--faults", type=int, default=600)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--budget", type=float, default=86400, help="seconds; begin none after")
    parser.add_argument("--pack", action="append", help="only this pack; may be repeated")
    parser.add_argument("--kind", action="append", choices=sorted(KINDS | MORE_KINDS), metavar="KIND")
    parser.add_argument("--once", type=int, metavar="LEAST",
                        help="one fault of each kind in one --pack; how many must be reported at "
                        "their line, among the first three messages and with at most three in all")
    parser.add_argument("--json", help="write every fault and its verdict")
    parser.add_argument("--min-found", type=float, default=0, help="percent")
    parser.add_argument("--min-located", type=float, default=0, help="percent")
    return parser.parse_args()


def main():
    arguments = parse_arguments()
    orris = Orris(arguments.orris)
    sources = {name: path for name, path in find_packs(arguments.packs).items()
               if not arguments.pack or name in arguments.pack}
    with ThreadPoolExecutor(arguments.jobs) as pool:
        views = list(pool.map(lambda item: PackView(*item, orris), sources.items()))
        once = arguments.once is not None
        kinds = arguments.kind or list(KINDS | MORE_KINDS if once else KINDS)
        count = len(kinds) if once else arguments.faults
        jobs = choose(views, kinds, count, arguments.seed)
        if once:
            jobs = list({fault.kind: (view, fault) for view, fault in reversed(jobs)}.values())
        with temporary_folder() as folder:
            copies = Copies(folder, arguments.budget)
            results = [result for result in pool.map(copies.judge, jobs) if result]
    if not once:
        report(results)
    if arguments.json:
        Path(arguments.json).write_text(json.dumps([asdict(r) for r in results], indent=1))
    if once:
        skipped = sorted(set(kinds) - {result.fault.kind for result in results})
        return run_once(results, skipped, arguments.once)
    found, located, fixed = score(results)
    print(f"\n{len(results)} faults in {len(views)} packs, seed {arguments.seed}: "
          f"{found:.1f} % found, {located:.1f} % of those located, {fixed:.1f} % located or fixed")
    good = results and found >= arguments.min_found and located >= arguments.min_located
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
