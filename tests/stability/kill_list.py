#!/usr/bin/env python3
"""Puts each mistake of a table into a copy of the reference pack and runs the tests that must find it.

Prints a line for each; fails when a mistake stays unfound, or when the pack without it fails the same
tests."""

import argparse
import concurrent.futures
import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile


def read_table(path):
    spec = importlib.util.spec_from_file_location("table", path)
    table = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(table)
    return table.MUTANTS


def run_tests(program, filters, pack):
    """(exit status, output). Ends the program where it holds no such test, as what is not tried would count as unfound."""
    env = dict(os.environ, ORRIS_REFERENCE_PACK=str(pack))
    result = subprocess.run([program, "--gtest_filter=" + filters], env=env, text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=600, check=False)
    if "Running 0 tests" in result.stdout:
        sys.exit(f"{program} has no test {filters}: name the program that holds it")
    return result.returncode, result.stdout


def mutate(pack, edits):
    """None, or why the edits do not fit the pack any more."""
    for file, before, after in edits:
        path = pack / "shaders" / file
        text = path.read_text()
        if text.count(before) != 1:
            return f"{file}: found {text.count(before)} times: {before!r}"
        path.write_text(text.replace(before, after))
    return None


def failed_tests(output):
    names = {line.split("]")[1].split(",")[0].split(" (")[0].strip()
             for line in output.splitlines() if line.startswith("[  FAILED  ]")}
    return sorted(name for name in names if "." in name)


def try_mutant(program, source, mutant):
    """(killed, what happened)"""
    _, filters, edits = mutant
    with tempfile.TemporaryDirectory() as folder:
        pack = pathlib.Path(folder) / "pack"
        shutil.copytree(source, pack)
        problem = mutate(pack, edits)
        if problem:
            return False, problem
        code, output = run_tests(program, filters, pack)
    if "error:" in output:
        return False, "does not load:\n" + output
    if code not in (0, 1):
        return False, f"ended with {code}:\n{output}"
    failed = failed_tests(output)
    return code == 1, ", ".join(failed) if failed else "no test failed"


def print_results(results):
    """Of (name, (killed, what happened)); the exit status."""
    count = survivors = 0
    for name, (killed, what) in results:
        count += 1
        survivors += not killed
        print(f"{'killed  ' if killed else 'SURVIVED'} {name}: {what}", flush=True)
    print(f"{count - survivors} of {count} mutants killed")
    return 1 if survivors else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", help="the tests, test_stability_gl for the default table")
    parser.add_argument("pack", type=pathlib.Path, help="shaderpack/")
    parser.add_argument("--table", type=pathlib.Path,
                        default=pathlib.Path(__file__).with_name("mutants.py"))
    parser.add_argument("--only", default="", help="mutants whose name contains this")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    args = parser.parse_args()
    chosen = [mutant for mutant in read_table(args.table) if args.only in mutant[0]]
    program = os.path.abspath(args.program)

    code, output = run_tests(program, ":".join(dict.fromkeys(filters for _, filters, _ in chosen)), args.pack)
    if code != 0:
        print(output, "the pack itself fails", sep="\n")
        return 1
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        results = pool.map(lambda mutant: try_mutant(program, args.pack, mutant), chosen)
        return print_results(zip((name for name, _, _ in chosen), results))


if __name__ == "__main__":
    sys.exit(main())
