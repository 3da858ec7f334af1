"""docs/first-pack.md does what it says: its files are written in order, its commands run after them.

first_pack_test.py ORRIS SOURCE_DIR
"""
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

orris, source = sys.argv[1], pathlib.Path(sys.argv[2])
# A file's name alone on a line, then its text; or commands.
BLOCK = re.compile(r"(?:^`(MyPack/[\w./]+)`\n\n)?^```(\w+)\n(.*?)^```$", re.M | re.S)


def run(line, folder):
    words = shlex.split(line)
    assert words[0] == "orris", line
    if words[1] == "render":
        words += ["--size", "64x36", "--frames", "1"]
    if words[1:2] == ["render"] or words[1:2] == ["view"]:
        words[3] = str(source / "worlds" / words[3])
    done = subprocess.run([orris, *words[1:]], cwd=folder, capture_output=True, text=True)
    # Pictures of two settings differ, which `compare` reports by its status only with a limit.
    assert done.returncode == 0, f"{line}: status {done.returncode}\n{done.stdout}{done.stderr}"
    assert "warning" not in done.stdout + done.stderr, f"{line}: {done.stderr}"
    return done.stdout


page = (source / "docs/first-pack.md").read_text()
with tempfile.TemporaryDirectory() as folder:
    files = commands = 0
    for name, language, text in BLOCK.findall(page):
        if name:
            path = pathlib.Path(folder, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
            files += 1
        elif language == "sh":
            for line in text.splitlines():
                out = run(line, folder)
                commands += 1
    assert files == 9 and commands == 8, (files, commands)
    # The last command compares a morning with and without shadows: they must differ.
    rmse = float(re.search(r"rmse\s+(\S+)", out)[1])
    assert rmse > 0.01, out
