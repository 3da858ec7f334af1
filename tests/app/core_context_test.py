#!/usr/bin/env python3
"""core_context_test.py PROGRAM SOURCE_DIR: a pack of old GLSL and the reference pack give the same
picture in a core and in a compatibility context: within 1/255 on 99.9 % of the pixels."""
import subprocess
import sys
import tempfile
from pathlib import Path


def main():
    program, source = sys.argv[1], Path(sys.argv[2])
    cases = ((source / "tests/packs/old-names", "worlds/glazed_house", "160x90"),
             (source / "shaderpack", "worlds/cornell", "96x54"))
    failed = 0
    with tempfile.TemporaryDirectory() as temporary:
        for pack, world, size in cases:
            pictures = []
            for profile in ("core", "compatibility"):
                pictures.append(Path(temporary) / f"{pack.name}-{profile}.png")
                subprocess.run([program, "render", pack, source / world, "-o", pictures[-1], "--size",
                                size, "--frames", "2", "--context", profile], check=True)
            # 1.1/255: a difference of exactly 1/255 must not be counted because of rounding.
            failed |= subprocess.run([program, "compare", *pictures, "--threshold", str(1.1 / 255),
                                      "--max-fraction", "0.001"]).returncode
    return failed


if __name__ == "__main__":
    sys.exit(main())
