#!/usr/bin/env python3
"""Puts each mistake of command_mutants.py into a copy of a source file, links the command with it, and runs the cases of the
test scripts that must find it: script_kill_list.py BUILD SOURCE [--only TEXT]

Prints a line for each; fails when a mistake stays unfound, or when a case fails without it. Needs a build by Ninja."""

import argparse
import pathlib
import shlex
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "stability"))
import host_kill_list  # noqa: E402
import kill_list  # noqa: E402
from command_mutants import MUTANTS  # noqa: E402

SKIPPED = 77


def scripts():
    """By their short name: how a case is run, and the names of the cases."""
    lsp = HERE.parent / "app" / "lsp_test.py"
    names = [line.split("(")[0].removeprefix("def ") for line in lsp.read_text().splitlines()
             if line.startswith("def ") and "(orris, root)" in line]
    apart = HERE / "apart_test.py"
    listed = subprocess.run([sys.executable, apart, "--list"], check=True, capture_output=True, text=True).stdout.split()
    return {"apart": (lambda orris, case: [apart, orris, case], listed),
            "lsp": (lambda orris, case: [lsp, orris, "--case", case], names)}


def run_case(orris, words, case):
    try:
        return subprocess.run([sys.executable, "-S", *map(str, words(orris, case))], capture_output=True, timeout=200,
                              check=False).returncode
    except subprocess.TimeoutExpired:
        return 1


def link_command(build, source, changed, target):
    """Makes `target`, the command with `changed` in the place of `source`. '' or what went wrong."""
    entry, unit = host_kill_list.compiled_with(build, source, changed)
    made = changed.with_suffix(".o")
    words = [str(unit) if word == entry["file"] else word.replace(entry["output"], str(made))
             for word in shlex.split(entry["command"]) if word != "-Werror"]
    done = host_kill_list.run(words + ["-O0"], build)
    if done.returncode != 0:
        return done.stdout
    link = host_kill_list.ninja(build, "-t", "commands", "-s", "orris").strip().split("&&")[1]
    # A source of the command itself is no member of an archive, but one of the objects that are linked.
    link = link.replace(entry["output"], str(made)) if entry["output"] in link else link.replace("-o orris", f"{made} -o orris")
    done = host_kill_list.run(["sh", "-c", link.replace("-o orris", f"-o {target}")], build)
    return done.stdout if done.returncode != 0 else ""


def try_mutant(args, mutant, known, passed):
    """(killed, what happened)"""
    name, wanted, file, _, _ = mutant
    text, problem = host_kill_list.mutated(mutant, args.source)
    if problem:
        return False, problem
    failed = []
    with tempfile.TemporaryDirectory() as folder:
        changed = pathlib.Path(folder) / pathlib.Path(file).name
        changed.write_text(text)
        orris = pathlib.Path(folder) / "orris"
        problem = link_command(args.build, args.source / file, changed, orris)
        if problem:
            return False, "does not build:\n" + problem
        for word in wanted.split():
            script, _, begin = word.partition(":")
            words, cases = known[script]
            case = next(case for case in cases if case.startswith(begin))
            if case not in passed:
                passed[case] = run_case(pathlib.Path(args.build) / "orris", words, case)
            if passed[case] != 0:
                return passed[case] == SKIPPED, f"{case} is skipped or fails without the mistake"
            if run_case(orris, words, case) == 0:
                return False, f"{case} passes"
            failed.append(case)
    return True, ", ".join(failed)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", help="folder of the build")
    parser.add_argument("source", type=pathlib.Path, help="folder of the sources")
    parser.add_argument("--only", default="", help="mistakes whose name contains this")
    args = parser.parse_args()
    args.source = args.source.resolve()
    known, passed = scripts(), {}
    return kill_list.print_results((mutant[0], try_mutant(args, mutant, known, passed))
                                   for mutant in host_kill_list.rows_of(MUTANTS) if args.only in mutant[0])


if __name__ == "__main__":
    sys.exit(main())
