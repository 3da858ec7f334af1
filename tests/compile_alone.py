"""Each source compiles by itself: a unity build lends a file the includes of the files before it.

compile_alone.py SOURCE FOLDER    configures SOURCE without unity in FOLDER and checks the syntax of each file
"""

import concurrent.futures
import json
import os
import pathlib
import shlex
import subprocess
import sys


def diagnostics(entry):
    """What the compiler says about the syntax of one file; empty where it compiles."""
    words = shlex.split(entry["command"])
    at = words.index("-o")
    words[at:at + 2] = ["-fsyntax-only", "-w"]
    return subprocess.run(words, cwd=entry["directory"], capture_output=True, text=True).stderr


def main():
    source, folder = sys.argv[1:]
    subprocess.run(["cmake", "-S", source, "--preset", "dev", "-B", folder, "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON",
                    "-DCMAKE_CXX_COMPILER_LAUNCHER="], cwd=source, check=True, stdout=subprocess.DEVNULL)
    entries = json.loads((pathlib.Path(folder) / "compile_commands.json").read_text())
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        found = [text for text in pool.map(diagnostics, entries) if text]
    print("\n".join(found), f"{len(found)} of {len(entries)} files do not compile alone", sep="\n")
    return 1 if found or not entries else 0


if __name__ == "__main__":
    sys.exit(main())
