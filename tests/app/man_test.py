#!/usr/bin/env python3
"""man_test.py PROGRAM PAGE: every command and flag that --help shows is in the man page, and no
flag in the page is unknown to the program."""
import re
import subprocess
import sys
from pathlib import Path


def help_of(*words):
    return subprocess.run([*words, "--help"], check=True, capture_output=True, text=True).stdout


def main():
    program, page = sys.argv[1], Path(sys.argv[2]).read_text().replace("\\-", "-")
    commands = re.findall(r"^  ([a-z]+) ", help_of(program).split("Subcommands:")[1], re.M)
    flags = set(re.findall(r"--[a-z-]+", help_of(program)))
    for command in commands:
        flags |= set(re.findall(r"--[a-z-]+", help_of(program, command)))
    documented = set(re.findall(r"--[a-z-]+", page))
    problems = [f"{name} is not in the man page"
                for name in sorted(flags - documented - {"--version"})
                + [command for command in commands if f"orris {command}" not in page]]
    problems += [f"{flag} is in the man page only" for flag in sorted(documented - flags)]
    print("\n".join(problems))
    return bool(problems)


if __name__ == "__main__":
    sys.exit(main())
