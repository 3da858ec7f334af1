"""Long sessions of `orris view --script` in an EGL context: everything that a person does, for long.

long_session_test.py --list                         names of the cases
long_session_test.py ORRIS CASE                     runs one on the test's own pack; exit status 77 means skipped
long_session_test.py ORRIS CASE --pack P --world W  on another pack, and prints what was measured
"""

import argparse
import json
import pathlib
import random
import re
import shutil
import statistics
import subprocess
import sys

import cases
from view_test import read_png

HERE = pathlib.Path(__file__).resolve().parent
TIMEOUT = 3600
SOURCES = (".fsh", ".vsh", ".csh", ".gsh", ".glsl", ".inc", ".h", ".properties", ".lang")
PROBES = 50


class Session:
    """A copy of a pack, and a folder for what scripts write."""

    def __init__(self, arguments, folder):
        self.orris = pathlib.Path(arguments.orris).resolve()
        self.folder, self.count = folder, arguments.count
        world = pathlib.Path(arguments.world)
        self.world = world.resolve() if world.exists() else arguments.world
        self.width, self.height = (int(word) for word in arguments.size.split("x"))
        self.own = arguments.pack is None
        shutil.copytree(arguments.pack or HERE / "pack", folder / "pack", symlinks=True)
        self.shaders = folder / "pack" / "shaders"
        if self.own:
            write_deep_pack(self.shaders)

    def view(self, steps):
        """Runs the steps, which must succeed; what was written on standard error."""
        (self.folder / "script.json").write_text(json.dumps(steps, indent=1))
        process = cases.view([self.orris, "view", "pack", self.world, "--size", f"{self.width}x{self.height}",
                              "--backend", "egl", "--script", "script.json", "--quiet"], self.folder, TIMEOUT)
        assert process.returncode == 0, (process.returncode, process.stderr[-4000:])
        return process.stderr

    def options(self):
        output = subprocess.run([self.orris, "options", "pack", "--json"], cwd=self.folder, check=True,
                                capture_output=True, timeout=TIMEOUT).stdout
        return json.loads(output)

    def state(self, name):
        return json.loads((self.folder / f"{name}.json").read_text())

    def sources(self):
        return sorted(path for path in self.shaders.rglob("*") if path.suffix in SOURCES and path.is_file())

    def name(self, path):
        return str(path.relative_to(self.folder))


def write_deep_pack(shaders):
    """The tint lies three includes deep, some options on screens of their own."""
    lib = shaders / "lib"
    text = (lib / "tint.glsl").read_text()
    (lib / "deep.glsl").write_text("#define GAIN 1.0 // [0.25 0.5 1.0 2.0]\n" +
                                   text.replace("return color;", "return color * GAIN * 1.00;"))
    (lib / "tint.glsl").write_text('#include "/lib/middle.glsl"\n')
    (lib / "middle.glsl").write_text('#include "/lib/deep.glsl"\n')
    with (shaders / "shaders.properties").open("a") as file:
        file.write("screen=<profile> [COLORS]\nscreen.COLORS=TINT GAIN\nsliders=TINT GAIN\n")


def deep_edit(session):
    """A file three includes deep and what to replace in it, so that the picture changes."""
    if session.own:
        return session.shaders / "lib" / "deep.glsl", "GAIN * 1.00", "GAIN * 0.{:02}"
    path, text = session.shaders / "include" / "sky" / "sky.glsl", "return dome * mix(0.33,"
    assert path.is_file() and text in path.read_text(), \
        "edits_reach_the_picture_soon knows the test's own pack and the reference pack"
    return path, text, "return dome * mix(0.{:02},"


def edits_reach_the_picture_soon(session):
    path, old, new = deep_edit(session)
    steps, before = [{"frames": 3}], old
    for i in range(20):
        after = new.format(i + 1)
        steps += [{"state": f"saved{i}.json"}, {"replace": session.name(path), "old": before, "new": after},
                  {"until": {"/loads": i + 2}, "seconds": 60}, {"picture": f"edit{i}.png"},
                  {"state": f"drawn{i}.json"}, {"expect": {"/load/succeeded": True, "/glErrors": 0}}]
        before = after
    session.view(steps)
    times = [(session.folder / f"edit{i}.png").stat().st_mtime - (session.folder / f"saved{i}.json").stat().st_mtime
             for i in range(20)]
    loads = [session.state(f"drawn{i}")["load"] for i in range(20)]
    print(f"from a save to its picture: median {statistics.median(times):.3f} s, {min(times):.3f} to {max(times):.3f};"
          f" loading {statistics.median(load['seconds'] for load in loads):.3f} s,"
          f" {statistics.median(load['frames'] for load in loads)} frames meanwhile,"
          f" the longest {max(load['longestFrame'] for load in loads):.3f} s;"
          f" built {loads[0]['built']}")
    if session.own:
        pictures = [read_png(session.folder / f"edit{i}.png") for i in range(20)]
        assert all(a != b for a, b in zip(pictures, pictures[1:])), "an edit does not show"
    assert statistics.median(times) < 1.5, times


def screen_walk(options):
    """Clicks through every screen, from the main one and back."""
    screens = {screen["name"]: screen["entries"] for screen in options["screens"]}
    steps, met = [], set()

    def visit(name):
        if name in met or name not in screens:
            return
        met.add(name)
        for entry in screens[name]:
            inner = entry[1:-1] if entry.startswith("[") and entry.endswith("]") else None
            if inner in screens and inner not in met:
                steps.extend([{"click": entry}, {"frames": 1}, {"expect": {"/panels/screen": inner}}])
                visit(inner)
                steps.extend([{"click": "Back"}, {"frames": 1}])

    visit("")
    return steps, met


def slider_drags(options, most, dice):
    """Sliders found by the search, so that each is on the screen."""
    known = {option["name"] for option in options["options"] if len(option["values"]) > 1}
    names = sorted(name for name in options["sliders"] if name in known)
    steps = []
    for i in range(most if names else 0):
        name = names[i % len(names)] if i >= len(names) else names[i]
        steps += [{"click": "Search"}, {"text": name}, {"frames": 2}, {"drag": name, "to": dice.choice([0.02, 0.4, 0.98])},
                  {"frames": 1}, {"expect": {"/glErrors": 0}}, {"click": "Back"}, {"frames": 1}]
    return steps, names


def everything_is_used(session):
    """Edits, breaks, mends, walks screens and profiles, drags, shows, probes, resizes, leaves."""
    dice, options = random.Random(1), session.options()
    path = late_file(session)
    name, text = session.name(path), path.read_text(errors="replace")
    walk, screens = screen_walk(options)
    drags, sliders = slider_drags(options, 20, dice)
    large = [1280, 1600]
    steps = [{"frames": 3},
             {"write": name, "text": text + "\n// edited\n"}, {"until": {"/loads": 2}, "seconds": 120},
             {"expect": {"/load/succeeded": True}}, {"frames": 2}, {"state": "good.json"},
             {"write": name, "text": text + "\n}}} broken\n"}, {"until": {"/load/succeeded": False}, "seconds": 120},
             {"frames": 1}, {"expect": {"/items": {"contains": "problem"}}}, {"screenshot": "broken.png"}, {"frames": 1},
             {"write": name, "text": text}, {"until": {"/load/succeeded": True}, "seconds": 120}, {"frames": 2},
             {"expect": {"/glErrors": 0}}, {"state": "mended.json"}]
    steps += [{"pause": True}, {"resize": large}, {"frames": 2}, {"key": "O"}, {"frames": 2}, *walk,
              {"screenshot": "options.png"}, {"frames": 1}, *drags, {"resize": [session.width, session.height]},
              {"key": "O"}, {"pause": False}, {"frames": 2}]
    for profile in options["profiles"]:
        steps += [{"profile": profile["name"]}, {"frames": 2}, {"expect": {"/load/succeeded": True, "/glErrors": 0}}]
    steps += [{"frames": 1}, {"state": "views.json"}]
    for key in ("F1", "T", "F3"):
        steps += [{"key": key}, {"frames": 2}, {"screenshot": f"{key}.png"}, {"frames": 1}, {"key": key}]
    steps += [{"key": "F3"}, {"frames": 1}]
    for _ in range(PROBES):
        # Beside the panel, which stands on the right.
        steps += [{"click": [dice.randrange(session.width * 2 // 5), dice.randrange(session.height)]}, {"frames": 1}]
    steps += [{"state": "probed.json"}, {"key": "F3"}, {"frames": 1}, {"key": "F4"}, {"frames": 2},
              {"state": "buffers.json"}, {"key": "F4"}]
    for size in ([97, 51], [1, 1], [session.width + 60, session.height], [session.width, session.height]):
        steps += [{"resize": size}, {"frames": 2}, {"expect": {"/width": size[0], "/glErrors": 0}}]
    steps += [{"state": "end.json"}]
    errors = session.view(steps)
    probed, end, good, mended = (session.state(name) for name in ("probed", "end", "good", "mended"))
    assert mended["problems"] == good["problems"], mended["problems"]
    assert probed["probe"] and probed["probe"][-1]["buffer"] == "screen", probed["probe"]
    print(f"{len(steps)} steps, {end['loads']} loads, {len(screens)} screens, {len(options['profiles'])} profiles,"
          f" {len(sliders)} sliders, {PROBES} pixels, {len(session.state('views')['steps'])} passes,"
          f" {end['glErrors']} errors of GL, {errors.count(': error:')} errors of the break")
    shows_every_buffer(session)


def shows_every_buffer(session):
    """Each buffer after each pass that writes it, and the frame's own."""
    passes = session.state("views")["passes"]
    shown = sorted({f"{side.split()[0]}@{name}" for name, sides in passes.items() for side in sides["writes"]
                    if side != "screen"})
    steps = [{"frames": 2}]
    for one in shown:
        steps += [{"show": one}, {"frames": 1}, {"expect": {"/glErrors": 0, "/shown/asked": one}}]
    session.view(steps + [{"show": ""}, {"frames": 1}])
    print(f"{len(shown)} buffers shown after the passes that write them")


def late_file(session):
    """A file of one of the last passes."""
    return next(path for path in session.sources() if path.name.startswith(("final.", "composite")))


def any_edit(session):
    """As deep_edit, in any pack: a constant that nothing reads, so that the picture stays."""
    if session.own:
        return deep_edit(session)
    path = late_file(session)
    path.write_text(path.read_text(errors="replace") + "\nconst float edited = 1.0;\n")
    return path, "edited = 1.0", "edited = 0.{:02}"


def reloads_keep_the_memory(session):
    path, old, new = any_edit(session)
    steps, before = [{"frames": 3}], old
    for i in range(200):
        after = new.format(i % 97 + 1)
        steps += [{"replace": session.name(path), "old": before, "new": after},
                  {"until": {"/loads": i + 2}, "seconds": 60}, {"frames": 1}]
        before = after
        if i + 1 in (20, 200):
            steps += [{"frames": 3}, {"state": f"after{i + 1}.json"}]
    session.view(steps)
    early, late = session.state("after20"), session.state("after200")
    growth = late["residentMegabytes"] / early["residentMegabytes"] - 1
    print(f"resident {early['residentMegabytes']:.1f} MB after 20 reloads, {late['residentMegabytes']:.1f} after 200:"
          f" {growth * 100:+.2f} %")
    assert late["loads"] >= 201 and late["glErrors"] == 0, late
    assert growth < 0.05, growth


def corrupted(text, dice):
    """Another text, or None for a file that is gone."""
    lines, at = text.split("\n"), dice.randrange(len(text) + 1)
    row = dice.randrange(len(lines))
    kinds = [lambda: None, lambda: "", lambda: text[:at], lambda: text[:at] + text[at + dice.randrange(1, 40):],
             lambda: text[:at] + dice.choice("(){};,.#\"/*\\\0\u00e9\t") + text[at:],
             lambda: "\n".join(lines[:row] + lines[row + 1:]), lambda: "\n".join(reversed(lines)),
             lambda: text[:at] + '\n#include "/lib/none.glsl"\n' + text[at:],
             lambda: text[:at] + "\n#if 1\n" + text[at:], lambda: text[:at] + "".join(
                 chr(dice.randrange(1, 0x2000)) for _ in range(dice.randrange(1, 200))) + text[at:],
             lambda: re.sub(r"\d", lambda m: str(dice.randrange(10)), text), lambda: text * 2]
    return dice.choice(kinds)()


def corruptions_leave_the_last_good_picture(session):
    dice, files = random.Random(2), session.sources()
    texts = {path: path.read_text(errors="replace") for path in files}
    steps, loads = [{"frames": 3}, {"picture": "good.png"}], 1
    count = session.count or 1000
    for i in range(count):
        path = dice.choice(files)
        text = corrupted(texts[path], dice)
        if text == texts[path]:
            text = "broken"
        name = session.name(path)
        steps += [{"remove": name} if text is None else {"write": name, "text": text},
                  {"until": {"/loads": loads + 1}, "seconds": 120}, {"state": f"bad{i}.json"}, {"picture": f"bad{i}.png"},
                  {"write": name, "text": texts[path]}, {"until": {"/loads": loads + 2}, "seconds": 120},
                  {"expect": {"/load/succeeded": True, "/glErrors": 0}}]
        loads += 2
    # A pack that the last corruption left in another state than it found is caught here.
    errors = session.view(steps + [{"frames": 3}, {"picture": "end.png"}, {"state": "end.json"}])
    failed, reported, same = 0, 0, 0
    good = (session.folder / "good.png").read_bytes()
    for i in range(count):
        state = session.state(f"bad{i}")
        if state["load"]["succeeded"]:
            continue
        failed += 1
        found = [problem for problem in state["problems"] if problem["severity"] == "error"]
        assert found, (i, state["load"])
        keys = [json.dumps(problem, sort_keys=True) for problem in found]
        assert len(set(keys)) == len(keys), (i, found)
        reported += len(found)
        same += (session.folder / f"bad{i}.png").read_bytes() == good
    print(f"{count} corruptions, {failed} of them errors with {reported} messages, {errors.count(': error:')} printed,"
          f" {same} times the last good picture")
    assert failed > count / 4, failed
    if session.own:
        assert same == failed and (session.folder / "end.png").read_bytes() == good
    assert errors.count(": error:") == reported, (errors.count(": error:"), reported)


CASES = [edits_reach_the_picture_soon, everything_is_used, reloads_keep_the_memory,
         corruptions_leave_the_last_good_picture]


def main():
    if cases.lists(CASES):
        return 0
    parser = argparse.ArgumentParser()
    parser.add_argument("orris")
    parser.add_argument("case", choices=[case.__name__ for case in CASES])
    parser.add_argument("--pack")
    parser.add_argument("--world", default=str(HERE / "world"))
    parser.add_argument("--size", default="320x240")
    parser.add_argument("--count", type=int, default=0)
    parser.add_argument("--keep", help="folder that keeps the pictures")
    arguments = parser.parse_args()
    return cases.run(CASES, arguments.case, lambda folder: Session(arguments, folder), arguments.keep)


if __name__ == "__main__":
    sys.exit(main())
