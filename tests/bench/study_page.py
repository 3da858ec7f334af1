"""What studies share that write a part of a page of docs/results anew."""

import re
import subprocess


def with_part(page, name, text):
    """
    >>> with_part("a<!-- rooms -->old<!-- end of rooms -->b", "rooms", "new")
    'a<!-- rooms -->\\nnew\\n<!-- end of rooms -->b'
    """
    return re.sub(rf"(<!-- {name} -->).*(<!-- end of {name} -->)", lambda m: f"{m[1]}\n{text}\n{m[2]}", page, flags=re.S)


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
