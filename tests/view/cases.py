"""What the test scripts of this folder share: a table of cases, one of which is run in a folder of its own."""

import os
import pathlib
import subprocess
import sys
import tempfile

SKIPPED = 77  # CTest's status for it


class Skip(Exception):
    """With the reason."""


def lists(cases):
    """Prints the names and is true, where they are asked for."""
    if sys.argv[1:] != ["--list"]:
        return False
    print("\n".join(case.__name__ for case in cases))
    return True


def run(cases, name, prepare, keep=None):
    """Runs the case of that name with what `prepare` makes in a folder (a temporary one, or `keep`); the exit status."""
    case = next(case for case in cases if case.__name__ == name)
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(keep or temporary).resolve()
        folder.mkdir(exist_ok=True, parents=True)
        test = None
        try:
            test = prepare(folder)
            case(test)
        except Skip as reason:
            print(f"skipped: {reason}")
            return SKIPPED
        finally:
            if hasattr(test, "stop"):
                test.stop()
    return 0


def without_display():
    """The environment in which no window can open."""
    return {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}


def view(command, folder, timeout):
    """A finished `orris view` in an EGL context."""
    process = subprocess.run([str(word) for word in command], cwd=folder, env=without_display(), capture_output=True,
                             text=True, errors="replace", timeout=timeout)
    if process.returncode == 3 and "EGL" in process.stderr:
        raise Skip("no EGL context here")
    return process


def main(cases, test):
    """SCRIPT ORRIS CASE, or --list; `test` is made of the program and a folder, in which the window keeps its state."""
    if lists(cases):
        return 0
    orris = pathlib.Path(sys.argv[1]).resolve()

    def prepare(folder):
        os.environ["XDG_STATE_HOME"] = str(folder)
        return test(orris, folder)

    return run(cases, sys.argv[2], prepare)
