"""orris validate --cache: an unchanged pack has the same report without being checked, and anything else is
checked.

result_cache_test.py ORRIS SOURCE_DIR
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

orris, source = sys.argv[1], pathlib.Path(sys.argv[2])

FINAL = """#version 330 compatibility
#define STRENGTH 1.0 // [0.5 1.0]
uniform sampler2D colortex0;
in vec2 uv;
layout(location = 0) out vec4 color;
#include "/lib/tint.glsl"
void main() { color = texture(colortex0, uv) * tint * STRENGTH; }
"""
VERTEX = """#version 330 compatibility
out vec2 uv;
void main() { gl_Position = ftransform(); uv = gl_MultiTexCoord0.xy; }
"""
GOOD, BAD = "const float tint = 1.0;\n", "const float tint = one;\n"


def run(*flags, env=None):
    done = subprocess.run([orris, "validate", str(pack), "--json", *flags], capture_output=True, text=True,
                          env={**os.environ, **(env or {})})
    assert done.returncode in (0, 1), done.stderr
    return json.loads(done.stdout)["packs"][0]


def same_but_cached(first, second):
    return {**first, "cached": True} == second


with tempfile.TemporaryDirectory() as folder:
    pack, cache = pathlib.Path(folder, "Pack"), pathlib.Path(folder, "cache")
    tint = pack / "shaders/lib/tint.glsl"
    tint.parent.mkdir(parents=True)
    (pack / "shaders/final.fsh").write_text(FINAL)
    (pack / "shaders/final.vsh").write_text(VERTEX)
    (pack / "shaders/shaders.properties").write_text("screen = STRENGTH GONE\n")
    tint.write_text(BAD)
    keep = ["--cache", str(cache)]

    # A pack with an error and a warning: the same report, every format, the same status.
    first = run(*keep)
    assert not first["cached"] and first["status"] == 1 and len(first["diagnostics"]) >= 2, first
    assert same_but_cached(first, run(*keep)), "second run"
    text = [subprocess.run([orris, "validate", str(pack), *keep, *off], capture_output=True, text=True)
            for off in ([], ["--no-cache"])]
    assert text[0].stderr == text[1].stderr and text[0].returncode == text[1].returncode == 1
    assert "unchanged since an earlier run" in text[0].stdout
    assert "unchanged" not in text[1].stdout
    assert same_but_cached(first, run(env={"ORRIS_CACHE": str(cache)})), "by environment"

    # Each of these is another question.
    for flags in (["--set", "STRENGTH=0.5"], ["--target", "apple"], ["--iris", "1.8"], ["--matrix", "each"],
                  ["--dimensions", "/"]):
        other = run(*keep, *flags)
        assert not other["cached"], flags
        assert run(*keep, *flags)["cached"], flags
    tint.write_text(GOOD)
    good = run(*keep)
    assert not good["cached"] and not good["failed"], good
    tint.write_text(BAD)
    assert same_but_cached(first, run(*keep)), "the old text again"
    settings = pathlib.Path(folder, "settings.txt")
    for value in ("0.5", "1.0"):
        settings.write_text(f"STRENGTH={value}\n")
        assert not run(*keep, "--settings", str(settings))["cached"], value
    assert run(*keep, "--settings", str(settings))["cached"]

    # Results that depend on more than the pack are not kept.
    for _ in range(2):
        assert not run(*keep, "--patched", folder + "/patched")["cached"]
    # The whole of a matrix within its time is the matrix; a part of it, as a CI job asks, is not.
    assert run(*keep, "--budget", "300s", "--matrix", "each")["cached"]
    assert not run(*keep, "--matrix", "each", env={"CI_NODE_INDEX": "1", "CI_NODE_TOTAL": "2"})["cached"]
    properties = pack / "shaders/shaders.properties"
    lines = properties.read_text()
    properties.write_text(lines + "texture.composite.depthtex1 = ../side.png\n")
    assert not run(*keep)["cached"] and not run(*keep)["cached"], "files beside shaders/"
    properties.write_text(lines)

    # A damaged entry is none, and a whole one takes its place.
    shutil.rmtree(cache)
    run(*keep)
    entry, = cache.iterdir()
    whole = entry.read_bytes()
    for damaged in (b"", whole[:10], whole[:-1], whole + b"x", whole[:-9] + b"damaged!!"):
        entry.write_bytes(damaged)
        assert run(*keep) == first, damaged[:20]
        assert entry.read_bytes() == whole
    # A folder in its place, and a folder that nobody can write to.
    entry.unlink()
    entry.mkdir()
    assert run(*keep) == first
    assert run("--cache", "/proc/none") == first

    # Several runs at once.
    shutil.rmtree(cache)
    runs = [subprocess.Popen([orris, "validate", str(pack), "--json", *keep], stdout=subprocess.PIPE,
                             stderr=subprocess.DEVNULL, text=True) for _ in range(6)]
    for done in runs:
        found = json.loads(done.communicate()[0])["packs"][0]
        assert found["diagnostics"] == first["diagnostics"]
    assert len(list(cache.iterdir())) == 1, "no partial file stays"
    # One killed while it writes or before leaves an entry or none.
    for delay in range(12):
        shutil.rmtree(cache, ignore_errors=True)
        victim = subprocess.Popen([orris, "validate", str(pack), *keep], stdout=subprocess.DEVNULL,
                                  stderr=subprocess.DEVNULL)
        try:
            victim.wait(0.01 + delay * 0.01)
        except subprocess.TimeoutExpired:
            victim.kill()
            victim.wait()
        assert {**run(*keep), "cached": False} == first, delay
