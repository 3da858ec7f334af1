"""What studies share that write a part of a page of docs/results anew."""

import argparse
import pathlib
import re
import subprocess

CHANNELS = ("red", "green", "blue")
ENDS = ("", "_low", "_high")


def with_part(page, name, text):
    """
    >>> with_part("a<!-- rooms -->old<!-- end of rooms -->b", "rooms", "new")
    'a<!-- rooms -->\\nnew\\n<!-- end of rooms -->b'
    """
    return re.sub(rf"(<!-- {name} -->).*(<!-- end of {name} -->)", lambda m: f"{m[1]}\n{text}\n{m[2]}", page, flags=re.S)


def parser_of(description, folder):
    """What each study is called with; `folder`: where it keeps what it measures."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("orris")
    parser.add_argument("pack")
    parser.add_argument("page", type=pathlib.Path)
    parser.add_argument("--folder", type=pathlib.Path, default=pathlib.Path(folder))
    return parser


def commit_of(pack):
    """With + where the pack has changes that no commit has."""
    def git(*arguments):
        return subprocess.run(["git", "-C", pack, *arguments], check=True, capture_output=True, text=True).stdout
    return git("rev-parse", "--short", "HEAD").strip() + ("+" if git("status", "--porcelain", ".") else "")


def markdown_table(heads, rows):
    """
    >>> print(markdown_table(["a", "b"], [[1, ""], ["x", 2.5]]))
    | a | b |
    | --- | --- |
    | 1 |  |
    | x | 2.5 |
    """
    return "\n".join("| " + " | ".join(map(str, cells)) + " |" for cells in [heads, ["---"] * len(heads), *rows])


def rms_of(measured, channel):
    """Root of the squared bias with its interval, of a row of scenes.csv.

    >>> rms_of({"rms_red": ".02", "rms_low_red": ".01", "rms_high_red": ".03"}, "red")
    [0.02, 0.01, 0.03]
    """
    return [float(measured[f"rms{end}_{channel}"]) for end in ENDS]


def interval(values, digits=3):
    """
    >>> interval([1.234, 1.1, 1.3], 2)
    '1.23 [1.10, 1.30]'
    """
    value, low, high = (f"{x:.{digits}f}" for x in values)
    return f"{value} [{low}, {high}]"


def as_typed(words):
    """A command in a page: lines of at most about 120 characters.

    >>> as_typed(["build/release/orris", "chart", "x" * 110, "--runs", "4"]).splitlines()[2]
    '      --runs 4'
    """
    lines, line = [], "    " + pathlib.Path(words[0]).name
    for word in words[1:]:
        if len(line) + len(word) > 112:
            lines.append(line + " \\")
            line = "     "
        line += " " + word
    return "\n".join([*lines, line])
