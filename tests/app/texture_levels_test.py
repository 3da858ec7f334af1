#!/usr/bin/env python3
"""texture_levels_test.py PROGRAM SOURCE_DIR: the frame and `orris trace` read the same texels, near and far:
a floor of lamps, which the camera sees as it is drawn."""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

WORLD = {"size": [32, 2, 32], "environment": {"time": 18000},
         "cameras": [{"name": "above", "position": [2.3, 2.6, 2.7], "yaw": -35, "pitch": 9},
                     {"name": "level", "position": [2.3, 1.2, 2.7], "yaw": -35, "pitch": 0}],
         "blocks": [{"box": "glowstone", "min": [0, 0, 0], "max": [31, 0, 31]}]}
OPTIONS = ["AMBIENT_MINIMUM=0.0", "DIRECT_LIGHT=NONE", "GI_METHOD=BOUNCE_1"]
# The middle row of an odd number of rows looks along the floor.
SIZES = {"above": "96x54", "level": "96x55"}


def main():
    program, source = sys.argv[1], Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        (folder / "world.json").write_text(json.dumps(WORLD), encoding="utf-8")
        frame, reference = folder / "frame.exr", folder / "reference.exr"
        for camera, size in SIZES.items():
            view = ["--camera", camera, "--size", size, "--set", *OPTIONS]
            subprocess.run([program, "render", source / "shaderpack", folder, "-o", folder / "out.png", "--frames", "2",
                            "--dump", f"colortex0={frame}", *view], check=True)
            subprocess.run([program, "trace", folder, "-o", reference, "--samples", "2", "--bounces", "0", *view], check=True)
            # Of a radiance up to 10. Two pixels on the edge of a block, and a star, may differ.
            if subprocess.run([program, "compare", frame, reference, "--threshold", "0.2", "--max-fraction", "0.003"]).returncode:
                return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
