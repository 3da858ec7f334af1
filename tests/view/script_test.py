"""Runs `orris view --script` without a display, in an EGL context.

script_test.py --list          names of the cases
script_test.py ORRIS CASE      runs one; exit status 77 means skipped
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys

import cases
from view_test import mean, read_png, share_within_one

HERE = pathlib.Path(__file__).resolve().parent
TIMEOUT = 120
BREAK = {"replace": "pack/shaders/lib/tint.glsl", "old": "vec3 tinted(", "new": "vec3 tinted(;"}
REPAIR = {"replace": "pack/shaders/lib/tint.glsl", "old": "vec3 tinted(;", "new": "vec3 tinted("}


class Test:
    """A folder with a copy of the pack, in which scripts run."""

    def __init__(self, orris, folder):
        self.orris, self.folder = orris, folder
        shutil.copytree(HERE / "pack", folder / "pack")

    def view(self, steps, status=0, *arguments):
        """Runs the steps; the finished process."""
        (self.folder / "script.json").write_text(json.dumps(steps, indent=1))
        process = cases.view([self.orris, "view", "pack", HERE / "world", "--size", "320x240", "--backend", "egl",
                              "--script", "script.json", *arguments], self.folder, TIMEOUT)
        assert process.returncode == status, (process.returncode, process.stderr, process.stdout)
        return process

    def picture(self, name):
        return read_png(self.folder / name)


def script_draws_what_render_draws(test):
    test.view([{"frames": 3}, {"picture": "view.png"}, {"screenshot": "window.png"}, {"frames": 1}])
    subprocess.run([test.orris, "render", "pack", HERE / "world", "--size", "320x240", "--frames", "3",
                    "--backend", "egl", "-o", "render.png"], cwd=test.folder, check=True, timeout=TIMEOUT)
    assert test.picture("view.png") == test.picture("render.png")
    assert test.picture("window.png") == test.picture("render.png")


def option_is_taken_over_saved_and_read_back(test):
    test.view([{"frames": 1}, {"picture": "plain.png"}, {"set": {"TINT": "2"}}, {"frames": 1},
               {"expect": {"/changed": {"TINT": "2"}, "/load/built": ["composite"], "/load/kept": 3,
                           "/profile": "BLUE"}},
               {"picture": "blue.png"}])
    assert (test.folder / "pack.txt").read_text() == "TINT=2\n"
    test.view([{"frames": 1}, {"expect": {"/values/TINT": "2", "/loads": 1}}, {"picture": "again.png"},
               {"set": {"TINT": ""}}, {"expect": {"/changed": {}, "/values/TINT": "0"}}])
    assert (test.folder / "pack.txt").read_text() == ""
    assert mean(test.picture("blue.png"))[0] < 0.4 * mean(test.picture("plain.png"))[0]
    assert test.picture("again.png") == test.picture("blue.png")


def own_save_is_no_edit(test):
    test.view([{"frames": 1}, {"set": {"TINT": "1"}}, {"frames": 120},
               {"expect": {"/loads": 2, "/load/cause": "TINT=1"}},
               {"write": "pack.txt", "text": "TINT=2\n"}, {"until": {"/values/TINT": "2"}, "seconds": 20},
               {"expect": {"/load/cause": "pack.txt changed"}}])


def broken_pack_keeps_the_last_good_picture(test):
    for damage, repair in ((BREAK, REPAIR),
                           ({"rename": "pack/shaders/lib/tint.glsl", "to": "tint.glsl"},
                            {"rename": "tint.glsl", "to": "pack/shaders/lib/tint.glsl"}),
                           ({"rename": "pack", "to": "gone"}, {"rename": "gone", "to": "pack"})):
        process = test.view(
            [{"frames": 2}, {"picture": "before.png"}, damage, {"until": {"/load/succeeded": False}},
             {"frames": 2}, {"picture": "broken.png"},
             {"state": "broken.json"}, repair, {"until": {"/load/succeeded": True}},
             {"expect": {"/problems": [], "/glErrors": 0}}, {"picture": "after.png"}])
        state = json.loads((test.folder / "broken.json").read_text())
        assert state["problems"], state
        assert process.stderr.count(": error:") >= 1, process.stderr
        assert test.picture("broken.png") == test.picture("before.png") == test.picture("after.png")


def pack_off_shows_the_hosts_own_programs(test):
    test.view([{"set": {"TINT": "1"}}, {"frames": 2}, {"picture": "on.png"}, {"key": "K"},
               {"expect": {"/packOn": False}}, {"frames": 2}, {"picture": "off.png"}, {"key": "K"},
               {"expect": {"/packOn": True, "/loads": 2}}, {"frames": 2}, {"picture": "again.png"}])
    assert share_within_one(test.picture("on.png"), test.picture("off.png")) < 0.9
    assert test.picture("again.png") == test.picture("on.png")


def pause_holds_the_picture_and_single_frames_go_on(test):
    test.view([{"frames": 3}, {"key": ","}, {"state": "a.json"}, {"frames": 5}, {"state": "b.json"},
               {"key": "."}, {"state": "c.json"}, {"resize": [100, 80]}, {"frames": 2},
               {"expect": {"/paused": True, "/width": 100, "/height": 80}},
               {"key": ","}, {"frames": 3}, {"expect": {"/paused": False}}, {"state": "d.json"}])
    frames = [json.loads((test.folder / f"{name}.json").read_text())["frame"] for name in "abcd"]
    assert frames[1] == frames[0] and frames[2] == frames[0] + 1 and frames[3] > frames[2] + 1, frames


def time_weather_and_camera(test):
    test.view([{"frames": 1}, {"time": 18000}, {"rain": 0.5}, {"camera": "top"}, {"frames": 1},
               {"expect": {"/time": 18000, "/rain": 0.5, "/camera/name": "top", "/camera/pitch": 85}},
               {"key": "1"}, {"expect": {"/camera/name": "front"}}])


def tiny_and_odd_sizes_survive(test):
    test.view([{"frames": 1}] + [step for size in ([1, 1], [2, 3], [17, 5], [640, 1], [320, 240])
                                 for step in ({"resize": size}, {"frames": 2},
                                              {"expect": {"/width": size[0], "/glErrors": 0}})])


def mistakes_in_scripts_are_located(test):
    for steps, status, expected in (
            ([{"keys": "R"}], 2, "script.json:3:3: error: there is no step \"keys\""),
            ([{"key": 5}], 2, "script.json:3:10: error: \"key\" takes a text"),
            ([{"key": "R", "hard": 1}], 2, "has no member \"hard\""),
            ({"key": "R"}, 2, "a script is a list of steps"),
            ([{"frames": 1}, {"expect": {"/profile": "RED"}}], 1,
             "script.json:5:2: error: step 2 (expect): /profile is \"PLAIN\", expected \"RED\""),
            ([{"until": {"/nothing": 1}, "seconds": 0.2}], 1, "/nothing is absent, expected 1, after 0.2 s"),
            ([{"key": "Hyper"}], 1, "there is no key \"Hyper\""),
            ([{"set": {"TINT": "9"}}], 1, "TINT cannot be \"9\": its values are the texts 0, 1, 2"),
            ([{"click": "nothing"}], 1, "nothing on the screen is named \"nothing\""),
            ([{"remove": "nothing.glsl"}], 1, "nothing.glsl does not exist")):
        process = test.view(steps, status)
        assert expected in process.stderr, (expected, process.stderr)
        assert process.stderr.count("error:") == 1, process.stderr


def options_are_walked_changed_and_reset(test):
    properties = test.folder / "pack" / "shaders" / "shaders.properties"
    properties.write_text(properties.read_text() + "screen=<profile> [COLORS] NOTHING\n"
                          "screen.COLORS=TINT <empty>\nsliders=TINT\n")
    test.view([{"frames": 2}, {"key": "O"}, {"frames": 1},
               {"expect": {"/panels/options": True, "/items": {"contains": "[COLORS]"}}},
               {"click": "[COLORS]"}, {"frames": 2}, {"expect": {"/panels/screen": "COLORS", "/loads": 1}},
               {"drag": "TINT", "to": 0.99}, {"frames": 1},
               {"expect": {"/changed": {"TINT": "2"}, "/load/built": ["composite"], "/load/kept": 3, "/loads": 2}},
               {"drag": "TINT", "to": 0.55}, {"frames": 1}, {"expect": {"/changed": {"TINT": "1"}, "/loads": 3}},
               {"click": "Back"}, {"expect": {"/panels/screen": ""}},
               {"click": "<profile>"}, {"frames": 1}, {"expect": {"/profile": "BLUE", "/load/cause": "profile BLUE"}},
               {"click": "<profile>", "button": "right"}, {"frames": 1}, {"expect": {"/profile": "RED"}},
               {"click": "Reset all"}, {"frames": 1}, {"expect": {"/changed": {}, "/profile": "PLAIN"}},
               {"click": "Search"}, {"text": "tin"}, {"expect": {"/panels/search": "tin"}},
               {"expect": {"/items": {"contains": "TINT"}, "/glErrors": 0}},
               {"key": "Escape"}, {"expect": {"/panels/options": False}}])
    assert (test.folder / "pack.txt").read_text() == ""


def problems_are_on_screen_over_the_last_good_picture(test):
    test.view([{"frames": 2}, {"screenshot": "good.png"}, {"frames": 1}, BREAK,
               {"until": {"/load/succeeded": False}}, {"frames": 2},
               {"expect": {"/items": {"contains": "problem"}, "/problems/0/file": "/lib/tint.glsl"}},
               {"screenshot": "broken.png"}, {"picture": "picture.png"}, {"frames": 1},
               {"key": "Escape"}, {"frames": 1}, {"expect": {"/items": []}}, {"screenshot": "closed.png"},
               {"frames": 1}, REPAIR, {"until": {"/load/succeeded": True}},
               {"expect": {"/items": [], "/glErrors": 0}}])
    assert test.picture("picture.png") == test.picture("good.png") == test.picture("closed.png")
    assert share_within_one(test.picture("broken.png"), test.picture("good.png")) < 0.95


def passes_are_timed_and_pixels_probed_only_while_shown(test):
    test.view([{"frames": 3}, {"state": "before.json"}, {"picture": "before.png"}, {"key": "F3"}, {"frames": 3},
               {"click": [40, 200]}, {"frames": 2}, {"state": "open.json"}, {"key": "F3"}, {"frames": 2},
               {"state": "after.json"}, {"picture": "after.png"}])
    before, opened, after = [json.loads((test.folder / f"{name}.json").read_text())
                             for name in ("before", "open", "after")]
    assert not before["interface"] and before["timedSteps"] == 0 and before["probe"] == []
    assert opened["steps"] == before["steps"] == after["steps"]
    assert opened["timedSteps"] == len(opened["steps"]), opened
    assert after["timedSteps"] == 0 and after["probe"] == [], after
    assert opened["probe"][-1]["buffer"] == "screen"
    pixel = test.picture("before.png")[200][40]
    assert [round(value * 255) for value in opened["probe"][-1]["value"][:3]] == list(pixel)
    assert test.picture("before.png") == test.picture("after.png")
    command = [test.orris, "render", "pack", HERE / "world", "--size", "320x240", "--frames", "3", "--backend",
               "egl", "-o", "render.png", "--probe", "40,200", "--json"]
    output = subprocess.run(command, cwd=test.folder, check=True, capture_output=True, timeout=TIMEOUT).stdout
    headless = json.loads(output)["probe"]
    assert [(one["step"], one["buffer"], one["value"]) for one in headless] == \
        [(one["step"], one["buffer"], one["value"]) for one in opened["probe"]]


def times_of_the_last_frames_are_shown_under_the_mouse(test):
    test.view([{"resize": [640, 480]}, {"key": "F3"}, {"frames": 5}, {"pause": True}, {"frames": 2},
               {"screenshot": "panel.png"}, {"frames": 1}, {"move": "ms of clear_color"}, {"frames": 2},
               {"screenshot": "history.png"}, {"frames": 1}])
    share = share_within_one(test.picture("panel.png"), test.picture("history.png"))
    assert 0.5 < share < 0.97, share


def write_odd_values(test):
    """composite leaves a NaN, an Inf and negative values, and fills a buffer object."""
    shaders = test.folder / "pack" / "shaders"
    (shaders / "composite.fsh").write_text("""#version 430 compatibility
uniform sampler2D colortex0;
uniform sampler2D colortex1;
in vec2 uv;
layout(std430, binding = 0) buffer Numbers { uint numbers[8]; };
layout(r32ui) uniform uimage3D cube;
/* RENDERTARGETS: 0,4 */
/*
const int colortex4Format = RGBA32F;
const bool colortex0MipmapEnabled = true;
*/
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  if (at.x < 8 && at.y == 0) numbers[at.x] = 100u + uint(at.x);
  if (at.x < 4 && at.y < 4) imageStore(cube, ivec3(at, 2), uvec4(7u));
  vec4 odd = vec4(0.25, 0.5, 2.0, 1.0);
  if (at == ivec2(10, 239)) odd.r = sqrt(-uv.x);
  if (at == ivec2(11, 239)) odd.g = 1.0 / (uv.x * 0.0);
  if (at == ivec2(12, 239)) odd.b = -3.0;
  gl_FragData[0] = texture2DLod(colortex0, uv, 2.0) + texture2D(colortex1, uv) * 0.0;
  gl_FragData[1] = odd;
}
""")
    (shaders / "composite.vsh").write_text("#version 430 compatibility\nout vec2 uv;\nvoid main() {"
                                           " gl_Position = ftransform(); uv = gl_MultiTexCoord0.st; }\n")
    with (shaders / "shaders.properties").open("a") as file:
        file.write("bufferObject.0=32\nimage.cube=none RED_INTEGER R32UI UNSIGNED_INT true false 4 4 4\n"
                   "iris.features.required=SSBO CUSTOM_IMAGES\n")


def first_value_that_is_not_finite_is_named(test):
    write_odd_values(test)
    test.view([{"frames": 3}, {"state": "before.json"}, {"key": "F3"}, {"frames": 2}, {"click": "find NaN and Inf"}, {"frames": 2},
               {"state": "found.json"}, {"screenshot": "panel.png"}, {"frames": 1},
               {"replace": "pack/shaders/composite.fsh", "old": "sqrt(-uv.x)", "new": "1.0"}, {"until": {"/loads": 2}},
               {"frames": 2}, {"state": "mended.json"}, {"checkFinite": False}, {"frames": 2},
               {"expect": {"/checksFinite": False, "/notFinite": [], "/panels/passes": True, "/glErrors": 0}}])
    before, found, mended = [json.loads((test.folder / f"{name}.json").read_text()) for name in ("before", "found", "mended")]
    assert not before["checksFinite"] and before["notFinite"] == []
    (nan,), (infinite,) = found["notFinite"], mended["notFinite"]
    assert nan["message"].startswith("composite writes NaN to colortex4 (alt) at pixel 10,0 of frame "), nan
    assert nan["message"].endswith("; 2 pixels are not finite") and nan["file"] == "/composite.fsh", nan
    assert infinite["message"].startswith("composite writes Inf to colortex4 (alt) at pixel 11,0 of frame "), infinite


def buffers_are_shown_after_any_pass(test):
    write_odd_values(test)
    test.view([{"frames": 2}, {"show": "colortex4@composite:0..2"}, {"frames": 2}, {"state": "odd.json"},
               {"shown": "odd.png"}, {"show": "colortex4@composite:b:false:0..2:signed"}, {"frames": 1},
               {"shown": "blue.png"}, {"show": "colortex0@composite:mip3"}, {"frames": 1},
               {"expect": {"/shown/width": 40, "/shown/height": 30, "/shown/mip": 3, "/shown/problem": ""}},
               {"show": "cube:slice2"}, {"frames": 1},
               {"expect": {"/shown/slices": 4, "/shown/slice": 2, "/shown/high": [7], "/shown/low": [7]}},
               {"show": "bufferObject.0@composite:at8"}, {"frames": 1},
               {"expect": {"/shown/words": [102, 103, 104, 105, 106, 107], "/shown/bytes": 32}},
               {"shown": "words.csv"}, {"screenshot": "table.png"}, {"show": "depthtex0@composite"}, {"frames": 1},
               {"expect": {"/shown/high": {"contains": 1}, "/shown/side": "main", "/glErrors": 0}},
               {"show": ""}, {"frames": 1}, {"expect": {"/shown": None, "/panels/buffers": False}}])
    state = json.loads((test.folder / "odd.json").read_text())["shown"]
    assert (state["nan"], state["infinite"], state["negative"]) == (1, 1, 1), state
    assert state["low"] == [0.25, 0.5, -3, 1] and state["high"] == [0.25, 0.5, 2, 1], state
    assert (state["width"], state["height"], state["range"]) == (320, 240, [0, 2]), state
    picture = test.picture("odd.png")
    assert picture[0][10:14] == [(255, 0, 255), (0, 255, 255), (0, 200, 60), (32, 64, 255)], picture[0][10:14]
    blue = test.picture("blue.png")
    assert blue[0][0] == (255, 250, 190) and blue[0][12] == (8, 8, 60), (blue[0][0], blue[0][12])
    table = (test.folder / "words.csv").read_text().splitlines()
    assert table[0] == "byte,word,int,float,hexadecimal" and table[1].startswith("8,102,102,"), table
    # Headless, the same pixels.
    subprocess.run([test.orris, "render", "pack", HERE / "world", "--size", "320x240", "--frames", "4", "--backend",
                    "egl", "-o", "out.png", "--show", "colortex4@composite:0..2=again.png",
                    "--show", "bufferObject.0@composite:at8=again.csv"], cwd=test.folder, check=True, timeout=TIMEOUT)
    assert test.picture("again.png") == picture
    assert (test.folder / "again.csv").read_text().splitlines() == table


def buffers_cost_nothing_while_none_is_shown(test):
    test.view([{"frames": 5}, {"expect": {"/copies": 0, "/shown": None, "/interface": False}}, {"key": "F4"},
               {"frames": 4}, {"state": "open.json"}, {"key": "F4"}, {"frames": 1}, {"state": "closed.json"},
               {"frames": 10}, {"state": "later.json"}, {"show": "colortex0@composite"}, {"frames": 2},
               {"key": "Escape"}, {"frames": 1}, {"state": "escaped.json"}, {"frames": 5}, {"state": "end.json"}])
    opened, closed, later, escaped, end = [json.loads((test.folder / f"{name}.json").read_text())
                                           for name in ("open", "closed", "later", "escaped", "end")]
    assert 4 <= opened["copies"] <= opened["frame"] - 5 and opened["shown"]["asked"] == "colortex0", opened
    assert closed["shown"] is None and closed["copies"] == later["copies"], (closed, later)
    assert escaped["copies"] > later["copies"] and escaped["copies"] == end["copies"], (escaped, end)


def buffers_are_chosen_by_hand(test):
    write_odd_values(test)
    test.view([{"resize": [1000, 700]}, {"frames": 2}, {"key": "F3"}, {"frames": 2},
               {"click": "colortex4@composite"}, {"frames": 2},
               {"expect": {"/shown/asked": "colortex4@composite", "/panels/buffers": True}}, {"key": "F3"},
               {"click": "g"}, {"frames": 1}, {"expect": {"/shown/asked": "colortex4@composite:g"}},
               {"click": "false colours"}, {"frames": 1},
               {"expect": {"/shown/asked": "colortex4@composite:g:false"}}, {"click": "alt"}, {"frames": 1},
               {"expect": {"/shown/asked": "colortex4@composite:alt:g:false"}}, {"click": "after"}, {"frames": 1},
               {"click": "after whole frame"}, {"frames": 1}, {"expect": {"/shown/asked": "colortex4:alt:g:false"}},
               {"click": "buffer"}, {"frames": 1}, {"click": "buffer bufferObject.0"}, {"frames": 2},
               {"expect": {"/shown/bytes": 32, "/items": {"contains": "words"}, "/glErrors": 0}},
               {"move": [600, 650]}, {"screenshot": "table.png"}, {"frames": 1}])


def passes_say_what_they_read_and_write(test):
    write_odd_values(test)
    test.view([{"frames": 1},
               {"expect": {"/passes/composite/writes": ["colortex0 alt", "colortex4 alt", "cube"],
                           "/passes/composite/reads": ["colortex0", "cube"],
                           "/passes/gbuffers_terrain_solid/reads": ["gtexture"],
                           "/passes/gbuffers_terrain_solid/writes": ["colortex0", "depthtex0"],
                           "/passes/final/reads": ["colortex0 alt"], "/passes/final/writes": ["screen"]}}])


def what_cannot_be_shown_is_said(test):
    for step, expected in (("colortex9", "there is no buffer colortex9 in this frame: it has colortex0"),
                           ("colortex0@composite7", "there is no pass composite7 in this frame"),
                           ("colortex0:mipx", "\"mipx\" is none of main, alt, mipN"), (":alt", "names no buffer")):
        process = test.view([{"frames": 1}, {"show": step}], 1)
        assert expected in process.stderr, (expected, process.stderr)
        run = subprocess.run([test.orris, "render", "pack", HERE / "world", "--size", "32x24", "--frames", "1",
                              "--backend", "egl", "-o", "out.png", "--show", f"{step}=a.png"], cwd=test.folder,
                             capture_output=True, text=True, timeout=TIMEOUT)
        assert run.returncode == 2 and expected in run.stderr, (run.returncode, run.stderr)
        assert not (test.folder / "a.png").exists()
    test.view([{"frames": 1}, {"show": "colortex0@composite"}, {"frames": 1},
               {"rename": "pack/shaders/composite.fsh", "to": "composite.fsh"}, {"until": {"/loads": 2}}, {"frames": 1},
               {"expect": {"/shown/problem": {"contains": "there is no pass composite"}, "/glErrors": 0}}])


def scene_is_chosen_in_its_panel(test):
    test.view([{"frames": 2}, {"key": "T"}, {"frames": 2}, {"click": "midnight"}, {"expect": {"/time": 18000}},
               {"drag": "rain", "to": 0.98}, {"expect": {"/rain": {"min": 0.9}}},
               {"click": "camera"}, {"frames": 1}, {"click": "camera top"}, {"expect": {"/camera/name": "top"}},
               {"click": "pack on"}, {"expect": {"/packOn": False}}, {"frames": 2}, {"click": "pack on"},
               {"click": "paused"}, {"expect": {"/packOn": True, "/paused": True}},
               {"click": "world"}, {"frames": 1}, {"click": "world cornell"}, {"frames": 2},
               {"expect": {"/world": "cornell", "/glErrors": 0, "/load/succeeded": True}}])


def panels_survive_any_size(test):
    test.view([{"key": key} for key in ("F1", "O", "T", "F3", "F4")] +
              [step for size in ([1, 1], [40, 30], [5, 400], [1200, 20], [320, 240])
               for step in ({"resize": size}, {"frames": 3}, {"expect": {"/width": size[0], "/glErrors": 0}})] +
              [{"key": "Escape"}, {"frames": 1}, {"expect": {"/items": []}}])


def error_is_opened_in_the_editor(test):
    editor = test.folder / "editor"
    editor.write_text('#!/bin/sh\necho "$@" > opened.txt.new\nmv opened.txt.new opened.txt\n')
    editor.chmod(0o755)
    os.environ["VISUAL"] = str(editor)
    test.view([{"frames": 1}, {"key": "E"}, {"expect": {"/said": "there is no error to open"}}, BREAK,
               {"until": {"/load/succeeded": False}}, {"key": "E"},
               {"expect": {"/said": {"contains": "opened /lib/tint.glsl:3:"}}}, {"frames": 60}, REPAIR,
               {"until": {"/load/succeeded": True}}])
    opened = (test.folder / "opened.txt").read_text()
    assert opened == f"+3 {test.folder.resolve()}/pack/shaders/lib/tint.glsl\n", opened


def load_for_longer_than_a_frame(test):
    """Gives the file that is edited a text that takes long to read."""
    tint = test.folder / "pack" / "shaders" / "lib" / "tint.glsl"
    lines = (f"float long{i}(float x) {{ return x * {i}.0 + sin(x) * (x - {i}.5) / max(x, {i}.0); }}\n" for i in range(3000))
    tint.write_text(tint.read_text() + "".join(lines))


def frames_go_on_while_an_edit_is_loaded(test):
    """The attempt begins before one frame and ends before a later one, for a good edit and for a bad one."""
    load_for_longer_than_a_frame(test)
    for damage, repair, good in ((BREAK, REPAIR, False),
                                 ({"replace": "pack/shaders/lib/tint.glsl", "old": "color;", "new": "color * 0.5;"},
                                  {"replace": "pack/shaders/lib/tint.glsl", "old": "color * 0.5;", "new": "color;"},
                                  True)):
        test.view([{"frames": 2}, damage, {"until": {"/load/cause": "tint.glsl changed"}},
                   {"expect": {"/load/succeeded": good, "/load/frames": {"min": 1}, "/doing": "",
                               "/load/longestFrame": {"min": 0.0001}}}, repair,
                   {"until": {"/load/succeeded": True, "/loads": 3}}, {"expect": {"/glErrors": 0}}])


def what_a_step_asks_for_waits_for_an_edit_in_progress(test):
    load_for_longer_than_a_frame(test)
    test.view([{"frames": 2}, {"replace": "pack/shaders/lib/tint.glsl", "old": "color;", "new": "color * 0.5;"},
               {"until": {"/doing": "tint.glsl changed"}}, {"set": {"TINT": "2"}},
               {"expect": {"/loads": 3, "/load/cause": "TINT=2", "/load/succeeded": True, "/doing": ""}}])


def write_live_options(test):
    """GAIN and STEPS are numbers in code, SIZE is that of an array, TINT is asked for by #if."""
    shaders = test.folder / "pack" / "shaders"
    (shaders / "composite.fsh").write_text("""#version 330 compatibility
#include "/lib/tint.glsl"
#define GAIN 1.0 // [0.25 0.5 0.7 1.0 2.0]
#define STEPS 3 // [1 2 3 4]
#define SIZE 2 // [1 2 3]
uniform sampler2D colortex0;
in vec2 uv;
/* RENDERTARGETS: 0 */
float shade(float gain) { return gain * 0.5 + 0.25; }
void main() {
  float weights[SIZE];
  weights[0] = 0.25;
  vec3 color = vec3(0.0);
  for (int i = 0; i < STEPS; ++i) color += texture(colortex0, uv + vec2(0.01) * float(i)).rgb * weights[0];
  gl_FragData[0] = vec4(tinted(color) * GAIN + shade(GAIN) * 0.1, 1.0);
}
""")
    (shaders / "composite.vsh").write_text("#version 330 compatibility\nout vec2 uv;\nvoid main() {"
                                           " gl_Position = ftransform(); uv = gl_MultiTexCoord0.st; }\n")
    with (shaders / "shaders.properties").open("a") as file:
        file.write("screen=GAIN STEPS TINT\nsliders=GAIN STEPS TINT\n")


def live_options_build_nothing_and_give_the_same_bytes(test):
    write_live_options(test)
    picture = [{"frames": 2}, {"picture": "NAME.png"}]

    def taken(name):
        return [dict(step, **{"picture": name + ".png"}) if "picture" in step else step for step in picture]

    values = [{"GAIN": "0.7", "STEPS": "4"}, {"GAIN": "0.25", "STEPS": "1"}, {"GAIN": "2.0"}]
    steps = [{"frames": 1}]
    for i, value in enumerate(values):
        steps += [{"set": value}] + taken(f"built{i}")
    steps += [{"set": {"GAIN": "", "STEPS": ""}}, {"live": ["GAIN", "STEPS"]},
              {"expect": {"/live": ["GAIN", "STEPS"], "/load/built": ["composite"], "/changed": {}}}]
    for i, value in enumerate(values):
        steps += [{"set": value}, {"expect": {"/load/built": [], "/live": ["GAIN", "STEPS"]}}] + taken(f"live{i}")
    steps += [{"expect": {"/values/GAIN": "2.0", "/glErrors": 0}}, {"set": {"TINT": "1"}},
              {"expect": {"/live": [], "/load/built": ["composite"], "/values/GAIN": "2.0"}}]
    test.view(steps)
    for i in range(len(values)):
        assert test.picture(f"built{i}.png") == test.picture(f"live{i}.png"), i
    assert test.picture("live0.png") != test.picture("live1.png")
    assert (test.folder / "pack.txt").read_text() == "GAIN=2.0\nSTEPS=1\nTINT=1\n"


def a_live_slider_is_followed_while_it_is_dragged(test):
    write_live_options(test)
    test.view([{"frames": 2}, {"key": "O"}, {"frames": 2}, {"drag": "GAIN", "to": 0.99}, {"frames": 1},
               {"expect": {"/changed": {"GAIN": "2.0"}, "/live": ["GAIN"], "/load/built": [], "/loads": 3}},
               {"drag": "GAIN", "to": 0.01}, {"frames": 1},
               {"expect": {"/changed": {"GAIN": "0.25"}, "/load/built": [], "/loads": 4}},
               {"drag": "TINT", "to": 0.99}, {"frames": 1},
               {"expect": {"/live": [], "/load/built": ["composite"], "/values/TINT": "2"}},
               {"key": "O"}, {"frames": 1}, {"picture": "dragged.png"}])
    assert (test.folder / "pack.txt").read_text() == "GAIN=0.25\nTINT=2\n"
    test.view([{"frames": 4}, {"picture": "again.png"}])
    assert test.picture("again.png") == test.picture("dragged.png")


def what_cannot_be_live_is_said(test):
    write_live_options(test)
    for option, expected in (("SIZE", "SIZE cannot be live: it is a size or an index (/composite.fsh:"),
                             ("TINT", "TINT cannot be live: #if asks for it in composite"),
                             ("NONE", "the pack has no option NONE")):
        process = test.view([{"frames": 1}, {"live": [option]}], 1)
        assert expected in process.stderr, process.stderr


def rows_of(picture, columns):
    """The lower rows without what stands on them, for comparing parts of a picture."""
    return [row[columns] for row in picture[len(picture) // 2 + 10:-40]]


def two_sets_are_compared(test):
    test.view([{"frames": 2}, {"expect": {"/compare": None}}, {"set": {"TINT": "1"}}, {"frames": 2},
               {"picture": "b.png"}, {"key": "C"}, {"frames": 2}, {"compare": "difference"}, {"frames": 2},
               {"expect": {"/compare/differing": 0, "/compare/values": {}, "/panels/compare": True}},
               {"set": {"TINT": "0"}}, {"frames": 2}, {"picture": "a.png"},
               {"expect": {"/compare/values": {"TINT": ["0", "1"]}, "/compare/differing": {"min": 1000},
                           "/compare/largest": {"min": 100}, "/compare/secondsA": {"min": 1e-6},
                           "/compare/secondsB": {"min": 1e-6}, "/glErrors": 0}},
               {"click": "wipe"}, {"frames": 1}, {"screenshot": "wipe.png"}, {"frames": 1},
               {"click": "flicker"}, {"frames": 1}, {"expect": {"/compare/shows": "A"}}, {"screenshot": "first.png"},
               {"frames": 1}, {"key": "X"}, {"expect": {"/compare/shows": "B"}}, {"screenshot": "second.png"},
               {"frames": 1}, {"click": "side"}, {"frames": 1}, {"screenshot": "side.png"}, {"frames": 1},
               {"resize": [200, 150]}, {"frames": 2}, {"expect": {"/glErrors": 0}}, {"resize": [320, 240]}, {"frames": 2},
               {"click": "take B"}, {"frames": 2}, {"expect": {"/values/TINT": "1", "/compare/values": {}}},
               {"key": "C"}, {"frames": 1}, {"expect": {"/compare": None, "/items": []}}])
    a, b = test.picture("a.png"), test.picture("b.png")
    everything, left, right = slice(0, 320), slice(0, 160), slice(160, 320)
    assert rows_of(test.picture("first.png"), everything) == rows_of(a, everything)
    assert rows_of(test.picture("second.png"), everything) == rows_of(b, everything)
    wipe = test.picture("wipe.png")
    assert rows_of(wipe, left) == rows_of(a, left) and rows_of(wipe, right) == rows_of(b, right)
    side = test.picture("side.png")
    assert mean([row[160:] for row in side[130:170]])[1] < 0.5 * mean([row[:160] for row in side[130:170]])[1]
    assert mean(side[-40:]) == [0, 0, 0], "above and below the halves is nothing"


def b_keeps_the_files_as_they_were(test):
    test.view([{"frames": 2}, {"compare": "difference"}, {"frames": 2}, {"expect": {"/compare/differing": 0}},
               {"replace": "pack/shaders/lib/tint.glsl", "old": "color;", "new": "color * 0.5;"},
               {"until": {"/loads": 2}}, {"frames": 2}, {"expect": {"/compare/differing": {"min": 1000}}},
               {"key": "K"}, {"frames": 1}, {"expect": {"/compare": None, "/packOn": False}}])
    process = test.view([{"compare": "both"}], 1)
    assert "there is no \"both\": sets are compared by side, wipe, flicker, difference" in process.stderr


def programs_are_read_with_the_authors_lines(test):
    composite = test.folder / "pack" / "shaders" / "composite.fsh"
    composite.write_text(composite.read_text().replace("vec4(tinted", "vec4(1f * tinted"))
    test.view([{"resize": [900, 700]}, {"frames": 1}, {"expect": {"/program": None}}, {"set": {"TINT": "2"}},
               {"key": "F5"}, {"frames": 2}, {"expect": {"/panels/program": True, "/program/name": {"contains": ".vsh"}}},
               {"program": "composite.fsh"}, {"frames": 1},
               {"expect": {"/program/options": ["TINT=2"], "/program/rules/float-literals": 1,
                           "/program/includes": ["/composite.fsh", "/lib/tint.glsl"], "/program/line": 0}},
               {"click": "find in program"}, {"text": "/lib/tint.glsl:7"}, {"click": "next line"}, {"frames": 1},
               {"expect": {"/program/author": "/lib/tint.glsl:7", "/program/text": {"contains": "vec3(0.25, 0.25, 1.0)"}}},
               {"state": "found.json"}, {"screenshot": "program.png"}, {"frames": 1}, {"click": "line 1"}, {"frames": 1},
               {"expect": {"/program/line": 1, "/program/text": {"contains": "#version"}}},
               {"set": {"TINT": "1"}}, {"frames": 2},
               {"expect": {"/program/options": ["TINT=1"], "/program/name": "composite.fsh", "/glErrors": 0}},
               {"program": ""}, {"frames": 1}, {"expect": {"/program": None, "/items": []}}])
    found = json.loads((test.folder / "found.json").read_text())["program"]
    assert found["line"] in found["linesOfAuthor"], found
    process = test.view([{"program": "none.fsh"}], 1)
    assert "there is no program none.fsh: the pack has " in process.stderr, process.stderr


def worlds_of_the_folder_and_shown_before_are_offered(test):
    shelf = test.folder / "shelf"
    for name in ("first", "second"):
        shutil.copytree(HERE / "world", shelf / name)
        text = (shelf / name / "world.json").read_text()
        (shelf / name / "world.json").write_text(text.replace('"name": "', f'"name": "{name} ', 1))
    recent = test.folder / "state" / "orris" / "recent-worlds"
    recent.parent.mkdir(parents=True)
    recent.write_text(f"{shelf}/first\n{shelf}/gone\nrelative\n")
    os.environ["XDG_STATE_HOME"] = str(test.folder / "state")
    names = [json.loads((shelf / name / "world.json").read_text())["name"] for name in ("first", "second")]
    test.view([{"resize": [900, 700]}, {"frames": 1}, {"key": "T"}, {"frames": 2}, {"click": "world"}, {"frames": 2},
               {"state": "items.json"}, {"click": f"world shown before {shelf}/first"}, {"frames": 2},
               {"expect": {"/world": names[0]}}, {"click": "world"}, {"frames": 2},
               {"click": f"world in this folder {shelf}/second"}, {"frames": 2},
               {"expect": {"/world": names[1], "/glErrors": 0}}])
    items = json.loads((test.folder / "items.json").read_text())["items"]
    assert not [item for item in items if "gone" in item or "relative" in item], items
    assert recent.read_text() == f"{shelf}/first\n{shelf}/gone\nrelative\n", "a script is no user"


def the_last_program_may_change_while_paused(test):
    final = test.folder / "pack" / "shaders" / "final.fsh"
    final.write_text(final.read_text().replace("void main", "#define SHADE 1 // [1 2 3]\nvoid main")
                     .replace("texture2D(colortex0, uv)", "texture2D(colortex0, uv) / float(SHADE)"))
    test.view([{"frames": 2}, {"key": "O"}, {"frames": 2}, {"pause": True}, {"frames": 2}, {"set": {"SHADE": "2"}},
               {"frames": 3}, {"expect": {"/load/built": ["final"], "/glErrors": 0}}, {"pause": False}, {"frames": 2},
               {"expect": {"/glErrors": 0}}])


def a_mistake_in_a_shared_file_is_one_problem(test):
    shaders = test.folder / "pack" / "shaders"
    for name in ("composite1", "composite2"):
        for ending in (".fsh", ".vsh"):
            shutil.copy(shaders / f"composite{ending}", shaders / f"{name}{ending}")
    test.view([{"frames": 2}, BREAK, {"until": {"/load/succeeded": False}}, {"state": "broken.json"}], 1)
    assert len(json.loads((test.folder / "broken.json").read_text())["problems"]) == 1


CASES = [a_mistake_in_a_shared_file_is_one_problem, the_last_program_may_change_while_paused, worlds_of_the_folder_and_shown_before_are_offered, programs_are_read_with_the_authors_lines, two_sets_are_compared, b_keeps_the_files_as_they_were, frames_go_on_while_an_edit_is_loaded, what_a_step_asks_for_waits_for_an_edit_in_progress,
         live_options_build_nothing_and_give_the_same_bytes, a_live_slider_is_followed_while_it_is_dragged,
         what_cannot_be_live_is_said, first_value_that_is_not_finite_is_named, times_of_the_last_frames_are_shown_under_the_mouse, buffers_are_shown_after_any_pass, buffers_cost_nothing_while_none_is_shown, buffers_are_chosen_by_hand,
         what_cannot_be_shown_is_said, passes_say_what_they_read_and_write, options_are_walked_changed_and_reset, problems_are_on_screen_over_the_last_good_picture,
         passes_are_timed_and_pixels_probed_only_while_shown, scene_is_chosen_in_its_panel,
         panels_survive_any_size, error_is_opened_in_the_editor,
         script_draws_what_render_draws, option_is_taken_over_saved_and_read_back, own_save_is_no_edit,
         broken_pack_keeps_the_last_good_picture, pack_off_shows_the_hosts_own_programs,
         pause_holds_the_picture_and_single_frames_go_on, time_weather_and_camera,
         tiny_and_odd_sizes_survive, mistakes_in_scripts_are_located]


def main():
    if cases.lists(CASES):
        return 0
    orris, name = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
    return cases.run(CASES, name, lambda folder: Test(orris, folder))


if __name__ == "__main__":
    sys.exit(main())
