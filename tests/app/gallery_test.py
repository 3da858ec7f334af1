#!/usr/bin/env python3
"""gallery_test.py PROGRAM SOURCE_DIR [TEST...]: two revisions of a small pack whose differences are known, from the command line
to the page in a browser."""
import base64
import json
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from browser import Browser
from cases import FINAL, FINAL_VERTEX, VERSION
from hostile_programs import DEADLY, ENDLESS

PROGRAM, SOURCE = (str(Path(word).resolve()) for word in sys.argv[1:3])
LIB = "vec3 tinted(vec3 c) { return c * TINT; }\n"
COMPOSITE = VERSION + """#define TINT 0.5 // [0.25 0.5 1.0]
#include "/lib/tint.glsl"
in vec2 texcoord;
uniform sampler2D colortex0;
void main() {
  gl_FragData[0] = vec4(tinted(texture2D(colortex0, texcoord).rgb), 1.0);
}
"""
OLD = {"final.vsh": FINAL_VERTEX, "final.fsh": FINAL, "composite.vsh": FINAL_VERTEX, "composite.fsh": COMPOSITE,
       "composite3.vsh": FINAL_VERTEX, "composite3.fsh": FINAL, "lib/tint.glsl": LIB,
       "shaders.properties": "profile.DARK = TINT=0.25\nprofile.BRIGHT = TINT=1.0\n"}
NEW = {**{name: text for name, text in OLD.items() if "composite3" not in name},
       "lib/tint.glsl": LIB.replace("c * TINT", "TINT < 0.9 ? c * TINT : 0.6 * c.brg"),
       "composite1.vsh": FINAL_VERTEX, "composite1.fsh": FINAL}
SET = {"size": "64x36", "frames": 4,
       "scenes": [{"world": "cornell", "cameras": ["front"], "profiles": ["DARK", "BRIGHT"]}]}
FAST = ["--size", "48x27", "--frames", "2"]


class Gallery(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.path = Path(temporary.name)
        self.write("old/shaders", OLD)
        self.write("new/shaders", NEW)
        self.write("", {"set.json": json.dumps(SET)})

    def write(self, folder, files):
        for name, text in files.items():
            file = self.path / folder / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)

    def orris(self, *words, status=0):
        result = subprocess.run([PROGRAM, *map(str, words)], cwd=self.path, text=True, errors="replace",
                                capture_output=True, timeout=150)
        self.assertEqual(result.returncode, status, result.stdout + result.stderr)
        return result

    def gallery(self, *words, pack="new", out="out.html", set_file="set.json", status=0):
        sets = ["--set-file", set_file] if set_file else []
        result = self.orris("gallery", pack, "-o", out, *sets, "--json", *words, status=status)
        return json.loads(result.stdout), result.stderr

    def pictures(self):
        """PNG files of the page by their texts."""
        found = re.findall(r'<img src="data:image/png;base64,([^"]*)" alt="([^"]*)">',
                           (self.path / "out.html").read_text())
        return {name: base64.b64decode(data) for data, name in found}

    def compared(self, one, other):
        self.write_bytes({"one.png": one, "other.png": other})
        return json.loads(self.orris("compare", "one.png", "other.png", "--json").stdout)

    def write_bytes(self, files):
        for name, data in files.items():
            (self.path / name).write_bytes(data)


class TwoRevisions(Gallery):
    def test_pictures_are_those_of_render_and_changes_those_of_compare(self):
        answer, _ = self.gallery("--against", "old", "--frames", "1")
        self.assertEqual([(p["name"], p["equal"]) for p in answer["pictures"]],
                         [("cornell, front, DARK", True), ("cornell, front, BRIGHT", False)])
        shown = self.pictures()
        for folder, kind in (("old", "before"), ("new", "after")):
            self.orris("render", folder, f"{SOURCE}/worlds/cornell", "-o", "render.png", "--camera", "front",
                       "--profile", "BRIGHT", "--size", "64x36", "--frames", "1")
            drawn = (self.path / "render.png").read_bytes()
            same = self.compared(shown[f"cornell, front, BRIGHT, {kind}"], drawn)
            self.assertEqual(same["maxAbsolute"], 0)
        difference = self.compared(shown["cornell, front, BRIGHT, after"], shown["cornell, front, BRIGHT, before"])
        bright = answer["pictures"][1]
        self.assertAlmostEqual(bright["rmse"], difference["rmse"], places=6)
        self.assertAlmostEqual(bright["fractionAbove"], difference["fractionAbove"], places=6)
        self.assertGreater(bright["change"], 0.01)
        self.assertNotIn("cornell, front, DARK, difference", shown)
        self.assertIn("cornell, front, BRIGHT, difference", shown)

    def test_passes_programs_and_files_that_differ_are_named(self):
        answer, _ = self.gallery("--against", "old")
        self.assertEqual({p["pass"]: (p["kind"], p["why"]) for p in answer["pictures"][0]["passesChanged"]},
                         {"composite": ("changed", "fragment, by /lib/tint.glsl"), "composite1": ("added", ""),
                          "composite3": ("removed", "")})
        self.assertEqual({f["file"]: f["kind"] for f in answer["files"]},
                         {"/lib/tint.glsl": "changed", "/composite1.vsh": "added", "/composite1.fsh": "added",
                          "/composite3.vsh": "removed", "/composite3.fsh": "removed"})

    def test_a_limit_is_kept(self):
        answer, errors = self.gallery("--against", "old", "--fail-above", "0.0001", status=1)
        self.assertRegex(errors, r"error: cornell, front, BRIGHT changed by 0\.\d+, --fail-above allows 0\.0001")
        self.assertEqual(errors.count("error: "), 1)
        self.assertTrue((self.path / "out.html").exists())
        self.gallery("--against", "old", "--fail-above", "2")

    def test_a_zip_is_a_revision(self):
        shutil.make_archive(str(self.path / "old"), "zip", self.path / "old")
        answer, _ = self.gallery("--against", "old.zip")
        self.assertEqual([p["equal"] for p in answer["pictures"]], [True, False])


class Gaps(Gallery):
    def test_of_one_program_leave_the_others(self):
        broken = COMPOSITE.replace("void main() {", "void main() {\n#if TINT == 1\n  lost();\n#endif").replace(
            "TINT 0.5 // [0.25 0.5 1.0]", "TINT 2 // [1 2]")
        self.write("new/shaders", {"composite.fsh": broken,
                                   "shaders.properties": "profile.DARK = TINT=1\nprofile.BRIGHT = TINT=2\n"})
        answer, errors = self.gallery("--against", "old", status=1)
        self.assertRegex(errors, r"(?m)^\S*composite\.fsh:8:3: error: .*lost")
        self.assertEqual([p["drawn"] for p in answer["pictures"]], [False, True])
        page = (self.path / "out.html").read_text()
        self.assertIn("not drawn", page)
        self.assertRegex(page, r"composite\.fsh:8:3: error")
        self.assertIn("cornell, front, DARK, before", self.pictures())

    def test_of_the_older_revision_are_warnings(self):
        self.write("old/shaders", {"composite.fsh": COMPOSITE.replace("tinted(", "lost(")})
        answer, errors = self.gallery("--against", "old")
        self.assertNotIn("error: ", re.sub(r"note: .*", "", errors))
        self.assertRegex(errors, r"warning: cornell, front, DARK could not be drawn of old")
        self.assertEqual([p["drawn"] for p in answer["pictures"]], [True, True])

    def test_of_drivers_that_die_or_do_not_end_leave_the_others(self):
        scenes = [{"world": "cornell", "cameras": ["front"], "profiles": ["DARK"]},
                  {"world": "cornell", "cameras": ["red"], "profiles": ["BRIGHT"]}]
        self.write("", {"set.json": json.dumps({"scenes": scenes})})
        properties = "profile.DARK = !program.composite9\nprofile.BRIGHT = TINT=1.0\n"
        self.write("new/shaders", {"shaders.properties": properties, "composite9.vsh": FINAL_VERTEX,
                                   "composite9.fsh": DEADLY})
        answer, errors = self.gallery(*FAST, "--memory-limit", "2G", "--frame-limit", "30s", status=1)
        self.assertRegex(errors, r"composite9\.fsh: error: the driver died")
        self.assertEqual([p["drawn"] for p in answer["pictures"]], [True, False])
        for name in ("composite9.vsh", "composite9.fsh"):
            (self.path / "new/shaders" / name).unlink()
        self.write("new/shaders", {"composite9.csh": ENDLESS})
        answer, errors = self.gallery(*FAST, "--frame-limit", "2s", status=1)
        self.assertRegex(errors, r"composite9\.csh: error: the driver took longer than 2 s of processor time")
        self.assertEqual([p["drawn"] for p in answer["pictures"]], [True, False])

    def test_of_a_scene_are_located_in_the_set(self):
        self.write("", {"set.json": '{"scenes": [\n {"world": "cornell", "cameras": ["front", "bakc"]}]}'})
        answer, errors = self.gallery(*FAST, status=1)
        self.assertRegex(errors, r'set\.json:2:44: error: cameras: "bakc" is no camera of this world')
        self.assertEqual([p["drawn"] for p in answer["pictures"]], [True, False])


class Sets(Gallery):
    def test_beside_the_shaders_are_read(self):
        self.write("new", {"gallery.json": json.dumps(SET)})
        answer, _ = self.gallery(*FAST, set_file="")
        self.assertEqual((answer["set"], len(answer["pictures"])), ("new/gallery.json", 2))

    def test_mistakes_end_it_before_anything_is_drawn(self):
        for text, place in (('{"scenes": [{"world": "cornel"}]}', r':1:23: error: there is no world "cornel"'),
                            ('{"scenes": [{"world": "cornell", "profiles": ["X"]}]}', r':1:47: error: "profiles" has no "X"'),
                            ('{"scenes": 1', r":1:\d+: error: "), (" " * 300000, ": error: is larger than 262144 bytes")):
            self.write("", {"set.json": text})
            result = self.orris("gallery", "new", "-o", "out.html", "--set-file", "set.json", status=2)
            self.assertRegex(result.stderr, r"set\.json" + place)
            self.write("new", {"gallery.json": text})
            result = self.orris("gallery", "new", "-o", "out.html", status=2 if "larger" in place else 1)
            self.assertRegex(result.stderr, r"new/gallery\.json" + place)
            self.assertFalse((self.path / "out.html").exists())

    def test_name_no_world_outside_of_their_folder(self):
        self.write("outside", {"world.json": Path(f"{SOURCE}/worlds/cornell/world.json").read_text()})
        (self.path / "new/link").symlink_to(self.path / "outside")
        for world in ("../outside", "link", str(self.path / "outside"), ""):
            self.write("new", {"gallery.json": json.dumps({"scenes": [{"world": world}]})})
            result = self.orris("gallery", "new", "-o", "out.html", *FAST, status=1)
            self.assertIn(f'there is no world "{world}"', result.stderr)
        shutil.copytree(self.path / "outside", self.path / "new/inside")
        self.write("new", {"gallery.json": json.dumps({"scenes": [{"world": "inside"}]})})
        answer, _ = self.gallery(*FAST, set_file="")
        self.assertEqual([p["drawn"] for p in answer["pictures"]], [True])


class Folders(Gallery):
    def times(self, folder):
        return {path.name: path.stat().st_mtime_ns for path in (self.path / folder / "pictures").iterdir()}

    def test_keep_what_is_known(self):
        self.gallery("--against", "old", out="all")
        known = self.times("all")
        self.assertEqual(len(known), 8)
        self.gallery("--against", "old", out="all")
        self.assertEqual(self.times("all"), known)
        self.write("new/shaders", {"lib/tint.glsl": LIB})
        answer, _ = self.gallery("--against", "old", out="all")
        self.assertEqual([p["equal"] for p in answer["pictures"]], [True, True])
        drawn = {name for name, time in self.times("all").items() if time != known[name]}
        self.assertEqual(len(drawn), 4)
        self.assertFalse([name for name in drawn if "before" in name])

    def test_of_shards_make_the_whole(self):
        whole, _ = self.gallery("--against", "old", out="all")
        for part in "12":
            answer, errors = self.gallery("--against", "old", "--shard", f"{part}/2", out=f"part{part}")
            self.assertEqual(len(answer["pictures"]), 1)
            self.assertIn("1 of 2 pictures are not drawn", errors)
            shutil.copytree(self.path / f"part{part}/pictures", self.path / "merged/pictures", dirs_exist_ok=True)
        known = self.times("merged")
        merged, errors = self.gallery("--against", "old", out="merged")
        self.assertEqual((self.times("merged"), errors), (known, ""))
        self.assertEqual([(p["name"], p["change"]) for p in merged["pictures"]],
                         [(p["name"], p["change"]) for p in whole["pictures"]])

    def test_a_damaged_picture_is_drawn_again(self):
        self.gallery(out="all")
        for path in (self.path / "all/pictures").iterdir():
            path.write_bytes(path.read_bytes()[:100])
        answer, errors = self.gallery(out="all")
        self.assertEqual(([p["drawn"] for p in answer["pictures"]], errors), ([True, True], ""))


class Page(Gallery):
    def test_in_a_browser(self):
        self.write("new/shaders", {"composite2.vsh": FINAL_VERTEX,
                                   "composite2.fsh": FINAL.replace("void", "#define ODD 0 // [0 1]\n#if ODD == 1\nlost\n#endif\nvoid")})
        scenes = [*SET["scenes"], {"world": "cornell", "name": "lost </pre><b>", "set": {"ODD": "1"}}]
        self.write("", {"set.json": json.dumps({**SET, "scenes": scenes})})
        self.gallery("--against", "old", status=1)
        browser = Browser.start(self.path)
        if browser is None:
            return
        with browser as page:
            page.open(self.path / "out.html")
            self.assertEqual(page.check_pictures(), 2 * 2 + 1)
            page.check_names()
            self.check_order(page)
            self.check_slider(page)
            self.check_phone(page)
            self.check_colours(page)
            self.check_without_scripts(page)
            self.assertEqual(page.problems, [])
            self.assertEqual([url for url in page.requests if not url.startswith(("data:", "file:", "about:"))], [])

    def titles(self, page):
        return page.evaluate("[...document.querySelectorAll('h2')].map((e) => e.textContent)")

    def check_order(self, page):
        dark, bright, lost = "cornell, front, DARK", "cornell, front, BRIGHT", "lost </pre><b>"
        self.assertEqual(self.titles(page), [lost, bright, dark])
        page.evaluate("document.querySelector('#order').focus()")
        page.press("ArrowDown", 40)
        self.assertEqual(page.evaluate("document.querySelector('#order').value"), "set")
        self.assertEqual(self.titles(page), [dark, bright, lost])
        page.press("ArrowUp", 38)
        self.assertEqual(self.titles(page), [lost, bright, dark])

    def check_slider(self, page):
        clip = "getComputedStyle(document.querySelector('.compare img:last-of-type')).clipPath"
        self.assertIn("50%", page.evaluate(clip))
        page.evaluate("document.querySelector('.slide input').focus()")
        page.press("ArrowRight", 39)
        self.assertIn("51%", page.evaluate(clip))
        x, y, width = page.evaluate("(() => { const box = document.querySelector('.compare'); box.scrollIntoView();"
                                    " const r = box.getBoundingClientRect(); return [r.x, r.y + r.height / 2, r.width]; })()")
        page.mouse("mousePressed", x + width / 4, y)
        self.assertIn("25%", page.evaluate(clip))
        page.mouse("mouseMoved", x + 3 * width / 4, y)
        page.mouse("mouseReleased", x + 3 * width / 4, y)
        self.assertIn("75%", page.evaluate(clip))

    def check_phone(self, page):
        page.open(self.path / "out.html", width=360, height=740)
        page.check_pictures()
        page.check_fits()
        columns = page.evaluate("getComputedStyle(document.querySelector('.shots')).gridTemplateColumns.split(' ').length")
        self.assertEqual(columns, 1)

    def check_colours(self, page):
        backs = {}
        for dark in (False, True):
            page.open(self.path / "out.html", dark=dark)
            contrast, backs[dark] = page.contrast()
            self.assertGreater(contrast, 7)
        self.assertGreater(backs[False], 0.8)
        self.assertLess(backs[True], 0.1)

    def check_without_scripts(self, page):
        """All is there to be read, and nothing to be operated."""
        page.open(self.path / "out.html", scripts=False)
        shown = page.call("DOM.getOuterHTML", nodeId=page.call("DOM.getDocument", depth=1)["root"]["nodeId"])["outerHTML"]
        self.assertEqual(len(re.findall(r"<img ", shown)), 5)
        self.assertNotIn("<input", shown.replace('"input"', ""))
        self.assertNotIn("<select", shown)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
