#!/usr/bin/env python3
"""light_start_test.py PROGRAM SOURCE: commands that read and write no picture but PNG and draw nothing
load neither the picture codecs nor a GL driver, whose libraries take longer to load than the work takes."""
import os
import subprocess
import sys
import tempfile
from pathlib import Path

PROGRAM, SOURCE = sys.argv[1], Path(sys.argv[2])
PNG = SOURCE / "docs/everything.png"
HEAVY = ("OpenImageIO", "OSMesa", "libGL", "libEGL", "LLVM", "gallium")
LIGHT = {
    "version": ["--version"],
    "options": ["options", SOURCE / "shaderpack"],
    "validate": ["validate", SOURCE / "tests/packs/blend-bad"],
    "world": ["world", SOURCE / "worlds/cornell"],
    "compare": ["compare", PNG, PNG],
}
OTHER_PICTURE = ["compare", PNG, "none.exr"]


def loaded(words):
    """The shared libraries that a run loads, as the dynamic linker reports them."""
    with tempfile.TemporaryDirectory() as folder:
        environment = dict(os.environ, LD_DEBUG="files", LD_DEBUG_OUTPUT=f"{folder}/log")
        subprocess.run([PROGRAM, *map(str, words)], env=environment, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL, check=False)
        return "\n".join(log.read_text(errors="replace") for log in Path(folder).iterdir())


for name, words in LIGHT.items():
    libraries = loaded(words)
    assert "libc.so" in libraries, f"{name}: the dynamic linker reported nothing"
    found = [library for library in HEAVY if library in libraries]
    assert not found, f"orris {name} loads {found}"
assert PNG.is_file()
assert "OpenImageIO" in loaded(OTHER_PICTURE), "the codecs are loaded where a picture of another kind is read"
