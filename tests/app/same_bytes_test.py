#!/usr/bin/env python3
"""same_bytes_test.py PROGRAM SOURCE_DIR: the same command gives the same bytes, of the picture and of the radiance before
exposure and tone map, with one and with two rasteriser threads; OSMesa and EGL agree within 1/255 on 99.9 % of the pixels."""
import os
import subprocess
import sys
import tempfile
from pathlib import Path


def main():
    program, source = sys.argv[1], Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as temporary:
        def render(name, backend, threads):
            picture = Path(temporary) / name
            subprocess.run([program, "render", source / "shaderpack", source / "worlds/cornell", "-o",
                            picture, "--size", "96x54", "--frames", "8", "--backend", backend,
                            "--dump", f"colortex0={picture}.exr"],
                           check=True, env={**os.environ, "LP_NUM_THREADS": str(threads)})
            return picture

        first = render("first.png", "osmesa", 1)
        for name, threads in (("again.png", 1), ("threads.png", 2)):
            picture = render(name, "osmesa", threads)
            for ending in ("", ".exr"):
                if Path(f"{picture}{ending}").read_bytes() != Path(f"{first}{ending}").read_bytes():
                    print(f"{name}{ending} differs from first.png{ending}")
                    return 1
        # 1.1/255: a difference of exactly 1/255 must not be counted because of rounding.
        return subprocess.run([program, "compare", render("egl.png", "egl", 2), first, "--threshold",
                               str(1.1 / 255), "--max-fraction", "0.001"]).returncode


if __name__ == "__main__":
    sys.exit(main())
