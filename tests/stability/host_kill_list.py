#!/usr/bin/env python3
"""Puts each mistake of a table into a copy of a source file of the host, links the tests with it, and
runs those that must find it.

Prints a line for each; fails when a mistake stays unfound, or when the tests fail without it. Needs a
build by Ninja, from whose files it takes how to compile and to link."""

import argparse
import json
import pathlib
import shlex
import subprocess
import sys
import tempfile

import kill_list


def ninja(build, *words):
    return subprocess.run(["ninja", "-C", build, *words], text=True, check=True,
                          stdout=subprocess.PIPE).stdout


def compile_commands(build):
    """By source file."""
    return {entry["file"]: entry for entry in json.loads(ninja(build, "-t", "compdb"))
            if entry["output"].endswith(".o")}


def run(command, folder):
    return subprocess.run(command, cwd=folder, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, check=False)


def compiled_with(build, source, changed):
    """How the file that has `source` in it is compiled, and the file to compile so instead: `changed`,
    or where several sources are compiled at once, a copy of the file that includes them."""
    entries = compile_commands(build)
    if str(source) in entries:
        return entries[str(source)], changed
    line = f'#include "{source}"'
    for file, entry in entries.items():
        if "Unity" in pathlib.Path(file).parts and line in pathlib.Path(file).read_text():
            unit = changed.with_suffix(".cxx")
            unit.write_text(pathlib.Path(file).read_text().replace(line, f'#include "{changed}"'))
            return entry, unit
    raise KeyError(f"{source} is no part of the build")


def build_tests(build, program, source, changed, target):
    """Compiles `changed` as if it were `source` and links `program` with it. '' or what went wrong."""
    entry, unit = compiled_with(build, source, changed)
    made = changed.with_suffix(".o")
    words = [str(unit) if word == entry["file"] else word.replace(entry["output"], str(made))
             for word in shlex.split(entry["command"]) if word != "-Werror"]
    done = run(words, build)
    if done.returncode != 0:
        return done.stdout
    # The archive's member of the same names is then not wanted. Only the link itself: what follows
    # asks the tests for their names.
    link = ninja(build, "-t", "commands", "-s", program).strip().split("&&")[1]
    done = run(["sh", "-c", link.replace(f"-o {program}", f"{made} -o {target}")], build)
    return done.stdout if done.returncode != 0 else ""


def rows_of(table):
    """name, tests, file, what is replaced by what"""
    return [(name, filters, file, before, after)
            for file, rows in table.items() for name, filters, before, after in rows]


def mutated(mutant, folder):
    """The text of the file with the mistake, and None or why the mistake does not fit it any more."""
    _, _, file, before, after = mutant
    text = (folder / file).read_text()
    problem = None if text.count(before) == 1 else f"{file}: found {text.count(before)} times: {before!r}"
    return text.replace(before, after), problem


def try_mutant(args, mutant):
    """(killed, what happened)"""
    source, filters = args.source / mutant[2], mutant[1]
    text, problem = mutated(mutant, args.source)
    if problem:
        return False, problem
    with tempfile.TemporaryDirectory() as folder:
        changed = pathlib.Path(folder) / source.name
        changed.write_text(text)
        problem = build_tests(args.build, args.program, source, changed,
                              pathlib.Path(folder) / "tests")
        if problem:
            return False, "does not build:\n" + problem
        code, output = kill_list.run_tests(pathlib.Path(folder) / "tests", filters,
                                           args.source / "shaderpack")
    failed = kill_list.failed_tests(output)
    return code == 1, ", ".join(failed) if failed else f"no test failed ({code})"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", help="folder of the build")
    parser.add_argument("program", help="the tests, a target of the build")
    parser.add_argument("source", type=pathlib.Path, help="folder of the sources")
    parser.add_argument("--table", type=pathlib.Path, required=True)
    parser.add_argument("--only", default="", help="mutants whose name contains this")
    args = parser.parse_args()
    args.source = args.source.resolve()
    chosen = [row for row in rows_of(kill_list.read_table(args.table)) if args.only in row[0]]

    filters = ":".join(dict.fromkeys(row[1] for row in chosen))
    code, output = kill_list.run_tests(pathlib.Path(args.build) / args.program, filters,
                                       args.source / "shaderpack")
    if code != 0:
        print(output, "the tests fail without a mutant", sep="\n")
        return 1
    return kill_list.print_results((mutant[0], try_mutant(args, mutant)) for mutant in chosen)


if __name__ == "__main__":
    sys.exit(main())
