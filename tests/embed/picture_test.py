"""picture.py gives the picture of `orris render`: picture_test.py LIBRARY ORRIS SOURCE"""
import pathlib
import subprocess
import sys
import tempfile

LIBRARY, ORRIS, SOURCE = sys.argv[1:]
PACK, WORLD = f"{SOURCE}/tests/packs/engine", f"{SOURCE}/worlds/lamps"
SCRIPT = f"{SOURCE}/tests/embed/picture.py"


def run(*words, **more):
    return subprocess.run(words, capture_output=True, text=True, **more)


with tempfile.TemporaryDirectory() as folder:
    mine, theirs = f"{folder}/ctypes.png", f"{folder}/orris.png"
    run(sys.executable, SCRIPT, LIBRARY, PACK, WORLD, mine, check=True)
    run(ORRIS, "render", PACK, WORLD, "-o", theirs, "--size", "160x90", "--frames", "1", check=True)
    compared = run(ORRIS, "compare", mine, theirs, check=True).stdout
    if "maxAbsolute    0\n" not in compared:
        sys.exit("the pictures differ:\n" + compared)
    wrong = run(sys.executable, SCRIPT, LIBRARY, "/nowhere", WORLD, mine)
    if wrong.returncode == 0 or "/nowhere" not in wrong.stderr:
        sys.exit("a pack that is not there: " + wrong.stderr)
    lines = len(pathlib.Path(SCRIPT).read_text().splitlines())
    print(f"{lines} lines of Python, the same picture")
