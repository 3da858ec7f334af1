#!/usr/bin/env python3
"""doc_links.py SOURCE_DIR: every link of a Markdown page to a file of the project leads to one, and its anchor to a
heading there, as GitHub forms anchors. Nothing is fetched."""
import re
import sys
from functools import lru_cache
from pathlib import Path

FOLDERS = [".", "docs", "shaderpack", "worlds", "tests"]
LINK = re.compile(r"\]\(([^)\s]+)\)")


def pages(source):
    for folder in FOLDERS:
        yield from (source / folder).glob("*.md" if folder == "." else "**/*.md")


def lines_outside_of_code(page):
    code = False
    for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
        if line.startswith("```"):
            code = not code
        elif not code:
            yield number, line


@lru_cache
def anchors(page):
    found = {}
    for _, line in lines_outside_of_code(page):
        heading = re.match(r"#+ (.*)", line)
        if heading:
            text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading[1]).strip().lower()
            name = re.sub(r"[^\w\- ]", "", text).replace(" ", "-")
            found[name] = found.get(name, -1) + 1
    return {name if not n else f"{name}-{n}" for name, last in found.items() for n in range(last + 1)}


def problem_of(page, link):
    path, _, anchor = link.partition("#")
    target = (page.parent / path).resolve() if path else page
    if not target.exists():
        return "no such file"
    if anchor and target.suffix == ".md" and anchor not in anchors(target):
        return "no such heading"
    return None


def main():
    source, failed = Path(sys.argv[1]).resolve(), 0
    for page in pages(source):
        for number, line in lines_outside_of_code(page):
            for link in LINK.findall(line):
                problem = None if ":" in link.split("#")[0] else problem_of(page, link)
                if problem:
                    print(f"{page.relative_to(source)}:{number}: {link}: {problem}")
                    failed = 1
    return failed


if __name__ == "__main__":
    sys.exit(main())
