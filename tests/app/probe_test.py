"""probe_test.py ORRIS SOURCE: `orris render --probe` says what --dump of each buffer says at each pass, to
the bit; --check-finite names the first pass that writes NaN or Inf; nothing asked for changes nothing."""
import json
import pathlib
import struct
import subprocess
import sys
import tempfile

from exr_file import read_exr

WIDTH, HEIGHT = 64, 36
PASS = """#version 330 compatibility
in vec2 uv;
uniform sampler2D colortex0;
uniform sampler2D colortex4;
/*
const int colortex4Format = RGBA32F;
*/
/* RENDERTARGETS: %s */
void main() { %s }
"""
VERTEX = """#version 330 compatibility
out vec2 uv;
void main() { gl_Position = ftransform(); uv = gl_MultiTexCoord0.st; }
"""
PASSES = {
    "composite": ("4", "gl_FragData[0] = vec4(uv, 1.0 / 3.0, 0.1) + texture2D(colortex0, uv);"),
    "composite1": ("0,4", "gl_FragData[0] = texture2D(colortex4, uv).brga;"
                          " gl_FragData[1] = sqrt(texture2D(colortex4, uv)) * 1e6;"),
    "composite2": ("4", "gl_FragData[0] = sin(texture2D(colortex4, uv)) * 0.7;"),
    "final": ("0", "gl_FragColor = texture2D(colortex0, uv);"),
}


def channels(planes, x, y):
    order = [name for name in ("R", "G", "B", "A", "Y", "Z") if name in planes]
    order += sorted(set(planes) - set(order))
    return [planes[name][y][x] for name in order]


def write_pack(folder, passes):
    shaders = folder / "pack" / "shaders"
    shaders.mkdir(parents=True, exist_ok=True)
    for name, (targets, code) in passes.items():
        (shaders / f"{name}.vsh").write_text(VERTEX)
        (shaders / f"{name}.fsh").write_text(PASS % (targets, code))


def render(orris, source, folder, *arguments, status=0):
    process = subprocess.run(
        [orris, "render", "pack", source / "worlds" / "cornell", "--size", f"{WIDTH}x{HEIGHT}", "--frames", "2",
         "-o", "out.png", *arguments], cwd=folder, capture_output=True, text=True, timeout=100)
    assert process.returncode == status, (process.returncode, process.stdout, process.stderr)
    return process


def bits(values):
    return [struct.pack("<f", float(value)) for value in values]


def chain_equals_dumps(orris, source, folder):
    for x, y in ((31, 17), (WIDTH - 1, HEIGHT - 1)):
        chain = json.loads(render(orris, source, folder, "--probe", f"{x},{y}", "--json").stdout)["probe"]
        named = {f"{one['buffer']}@{one['step']}": f"{i}.exr" for i, one in enumerate(chain)
                 if one["buffer"] != "screen"}
        steps = [one["step"] for one in chain]
        assert [step for step in steps if step.startswith(("comp", "final"))] == [
            "composite", "composite1", "composite1", "composite2", "final"], steps
        assert any(one["buffer"] == "depthtex0" for one in chain), chain
        render(orris, source, folder, "--dump", *[f"{name}={path}" for name, path in named.items()])
        # The last of several values of one buffer at one pass is the one that the dump shows.
        for name, path in named.items():
            one = chain[int(path.removesuffix(".exr"))]
            width, height, planes = read_exr(folder / path)
            assert (width, height) == (WIDTH, HEIGHT)
            found = channels(planes, one["x"], one["y"])
            assert bits(found) == bits(one["value"]), (name, found, one)
        plain = {one["buffer"]: one for one in chain}
        render(orris, source, folder, "--dump", "colortex4=last.exr")
        assert bits(channels(read_exr(folder / "last.exr")[2], x, y)) == bits(plain["colortex4"]["value"])


def probe_changes_no_picture(orris, source, folder):
    render(orris, source, folder)
    before = (folder / "out.png").read_bytes()
    text = render(orris, source, folder, "--probe", "31,17", "--check-finite").stdout
    assert (folder / "out.png").read_bytes() == before
    assert "pixel 31,17, in the last frame:" in text and "  composite2 " in text, text


def finite_check_names_the_first_pass(orris, source, folder):
    broken = dict(PASSES, composite1=(
        "4", "gl_FragData[0] = vec4(gl_FragCoord.xy == vec2(10.5, 5.5) ? sqrt(-uv.x) : 1.0);"))
    write_pack(folder, broken)
    process = render(orris, source, folder, "--check-finite", status=1)
    assert process.stderr.startswith(
        "/composite1.fsh: error: composite1 writes NaN to colortex4 at pixel 10,30 of frame 0; 1 pixel is not finite"
        " [not-finite]\n"), process.stderr
    assert "after it composite2 writes 4 such pixels to colortex4 (alt)" in process.stderr, process.stderr
    assert process.stderr.count("error:") == 1
    write_pack(folder, dict(PASSES, composite2=("4", "gl_FragData[0] = vec4(1.0 / (uv.x * 0.0));")))
    process = render(orris, source, folder, "--check-finite", status=1)
    assert "composite2 writes Inf to colortex4 (alt) at pixel 0,0" in process.stderr, process.stderr
    assert f"{WIDTH * HEIGHT} pixels are not finite" in process.stderr, process.stderr


def mistakes_are_reported(orris, source, folder):
    for arguments, status, expected in (
            (["--probe", "64,0"], 2, "is no pixel of a picture of 64x36"), (["--probe", "1"], 2, "is no pixel"),
            (["--probe", "-1,2"], 2, "is no pixel"),
            (["--dump", "colortex4@composite9=a.exr"], 2, "no such pass in this frame"),
            (["--dump", "colortex9@composite=a.exr"], 2, "no such buffer in this frame")):
        process = render(orris, source, folder, *arguments, status=status)
        assert expected in process.stderr, process.stderr


def main():
    orris, source = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    for case in (chain_equals_dumps, probe_changes_no_picture, finite_check_names_the_first_pass,
                 mistakes_are_reported):
        with tempfile.TemporaryDirectory() as name:
            write_pack(pathlib.Path(name), PASSES)
            case(orris, source, pathlib.Path(name))
            print(case.__name__, "passed")


if __name__ == "__main__":
    main()
