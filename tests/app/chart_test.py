#!/usr/bin/env python3
"""chart_test.py PROGRAM [all]: a chart and a tuning of a small pack whose costs and errors are known, from
the command line to the files."""
import csv
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

from browser import Browser

VERSION = "#version 330 compatibility\n"
VERTEX = VERSION + """out vec2 uv;
void main() { gl_Position = ftransform(); uv = gl_MultiTexCoord0.st; }
"""
# colortex0 is SHARE of the reference, and costs more the larger it is; WORK costs time and changes nothing.
COMPOSITE = VERSION + """/*
const int colortex0Format = RGBA32F;
*/
#define SHARE 1.0 // [0.5 0.8 1.0]
#define WORK 200 // [200 800]
in vec2 uv;
void main() {
  float sum = 0.0;
  for (int i = 0; i < WORK * int(exp2(8.0 * SHARE - 4.0) + 0.01); ++i) sum += sin(uv.x * float(i));
  gl_FragData[0] = vec4(vec3(SHARE * (1.0 + clamp(sum, 0.0, 1e-9))), 1.0);
}
"""
FINAL = VERSION + """in vec2 uv;
uniform sampler2D colortex0;
void main() { gl_FragColor = texture2D(colortex0, uv); }
"""
FILES = {"composite.vsh": VERTEX, "composite.fsh": COMPOSITE, "final.vsh": VERTEX,
         "final.fsh": FINAL,
         "shaders.properties": "profile.FAST = SHARE=0.5 WORK=200\nprofile.FINE = SHARE=1.0 WORK=800\n"}
WORLD = {"size": [2, 2, 2], "blocks": [{"box": "stone", "min": [0, 0, 0], "max": [1, 0, 1]}],
         "cameras": [{"name": "front", "position": [1, 1.5, 4], "yaw": 180, "pitch": 0},
                     {"name": "above", "position": [1, 5, 1], "yaw": 0, "pitch": 90}]}
# Costs are compared on a machine that does nothing else.
COMPARES_COSTS = sys.argv[2:] == ["all"]
ROUNDS = 5 if COMPARES_COSTS else 2
MEASURE = (f"--size 48x32 --warm-up 2 --frames 4 --rounds {ROUNDS} --visit 2 --buffer colortex0 "
           "--clock cpu --reference SHARE=1.0 --reference-frames 4")
CHART = f"chart pack world -o out {MEASURE} --axis SHARE --axis WORK --baseline SHARE=1.0,WORK=200"


def orris(program, folder, command, status=0):
    result = subprocess.run([program, *command.split()], cwd=folder, text=True,
                            capture_output=True, timeout=200)
    assert result.returncode == status, (command, result.returncode, result.stdout, result.stderr)
    return result


def rows(path):
    with open(path, newline="") as file:
        return {row["setting"]: row for row in csv.DictReader(file)}


def check_numbers(folder):
    settings = rows(folder / "settings.csv")
    assert len(settings) == 6, list(settings)
    assert list(settings)[0] == "SHARE=1.0 WORK=200"
    for share in ("0.5", "0.8", "1.0"):
        cheap, dear = (settings[f"SHARE={share} WORK={work}"] for work in (200, 800))
        for row in (cheap, dear):
            assert abs(float(row["bias"]) - (1 - float(share)) / 1.02) < 1e-5, row
            assert abs(float(row["signed_bias"]) + (1 - float(share)) / 1.02) < 1e-5, row
            assert float(row["noise"]) < 1e-5 and row["pairs"] == str(ROUNDS) and row["frames"] == "4"
            assert float(row["ms_low"]) <= float(row["ms"]) <= float(row["ms_high"])
        if COMPARES_COSTS:
            assert float(dear["ms"]) > float(cheap["ms"]), (cheap, dear)
            assert (cheap["front"], dear["front"]) == ("1", "0"), (cheap, dear)
    baseline, dear = settings["SHARE=1.0 WORK=200"], settings["SHARE=1.0 WORK=800"]
    assert baseline["ratio"] == "1.0000", baseline
    if COMPARES_COSTS:
        assert float(dear["ratio_low"]) > 1.2, dear
    with open(folder / "passes.csv", newline="") as file:
        passes = {(row["setting"], row["pass"]): float(row["ms"]) for row in csv.DictReader(file)}
    ratio = passes["SHARE=1.0 WORK=800", "composite"] / passes["SHARE=1.0 WORK=200", "composite"]
    assert ratio > (2 if COMPARES_COSTS else 0), passes


def check_page(folder, scratch):
    page = folder / "index.html"
    text = page.read_text()
    assert 'src="http' not in text and "href=" not in text
    browser = Browser.start(scratch)
    if browser is None:
        return
    plots = 3 if shutil.which("gnuplot") else 0
    with browser as shown:
        shown.open(page)
        # two that are compared; frame, mean and error of each setting; one reference
        assert shown.check_pictures() == plots + 2 + 3 * 6 + 1
        assert shown.evaluate("document.querySelectorAll('tr').length") == 7
        assert "A/A: the first setting measured twice" in shown.evaluate("document.body.textContent")
        shown.check_names()
        check_comparison(shown)
        shown.open(page, width=360, height=740)
        shown.check_pictures()
        shown.check_fits()
        for dark in (False, True):
            shown.open(page, dark=dark)
            contrast, back = shown.contrast()
            assert contrast > 7 and (back < 0.1 if dark else back > 0.8), (dark, contrast, back)
        assert not shown.problems, shown.problems
        assert all(url.startswith(("file:", "data:", "about:")) for url in shown.requests), shown.requests


def check_comparison(shown):
    """The slider moves the border of the two pictures, the lists choose them."""
    border = "document.querySelector('#compare').style.getPropertyValue('--at')"
    assert shown.evaluate(border) == "50%"
    shown.evaluate("document.querySelector('#slider').focus()")
    shown.press("ArrowRight", 39)
    assert shown.evaluate(border) == "51%"
    source = "document.querySelector('#over').src"
    before = shown.evaluate(source)
    dark = shown.evaluate("[...document.querySelector('#left').options].findIndex((o) => o.text == 'SHARE=0.5 WORK=200')")
    shown.evaluate("document.querySelector('#left').focus()")
    for _ in range(dark):
        shown.press("ArrowDown", 40)
    assert shown.evaluate("document.querySelector('#left').value") == str(dark)
    half = shown.evaluate(source)
    assert half != before
    shown.evaluate("document.querySelector('#kind').focus()")
    for _ in range(2):
        shown.press("ArrowDown", 40)
    assert shown.evaluate("document.querySelector('#kind').value") == "difference"
    assert shown.evaluate(source) not in (half, before)


def test_chart(program, folder):
    result = orris(program, folder, CHART + " --mark SHARE=0.8:0.75 --json")
    answer = json.loads(result.stdout)
    assert (answer["settings"], answer["measured"], len(answer["points"])) == (6, 6, 6)
    assert (0.5 if COMPARES_COSTS else 0) < answer["again"]["ratio"] < (2 if COMPARES_COSTS else 100)
    out = folder / "out"
    check_numbers(out)
    settings = rows(out / "settings.csv")
    assert settings["SHARE=0.8 WORK=200"]["published_ratio"] == "0.75"
    assert settings["SHARE=0.5 WORK=200"]["published_ratio"] == ""
    if shutil.which("gnuplot"):
        for name in ("cost-error", "frames", "passes"):
            assert (out / f"{name}.svg").read_text().rstrip().endswith("</svg>")
            assert (out / f"{name}.png").read_bytes().startswith(b"\x89PNG")
        assert "A/A" in (out / "cost-error.svg").read_text()
    else:
        print("SKIPPED: no gnuplot to draw plots with")
        assert "gnuplot-nox" in result.stderr
    check_page(out, folder)


def test_gnuplot_is_shut_in(program, folder):
    """A driver that was taken over could have any script plotted: gnuplot's own place is one that no program is run from."""
    kernel = json.loads(subprocess.run([program, "doctor", "--json"], text=True, capture_output=True, timeout=60).stdout)["kernel"]
    if "Landlock: none" in kernel:
        print("SKIPPED: this kernel has no Landlock")
        return
    shutil.copytree(folder / "out", folder / "shut/out")
    for name in ("pack", "world"):
        (folder / "shut" / name).symlink_to(folder / name)
    fake = folder / "shut/gnuplot"
    fake.write_text("#!/bin/sh\necho run > ran\n")
    fake.chmod(0o755)
    result = subprocess.run([program, *CHART.split()], cwd=folder / "shut", text=True, capture_output=True, timeout=200,
                            env={**os.environ, "PATH": f"{fake.parent}:{os.environ['PATH']}"})
    assert result.returncode == 0 and not (folder / "shut/ran").exists(), result.stderr


def test_second_run_measures_nothing(program, folder):
    before = rows(folder / "out/settings.csv")
    times = {path: path.stat().st_mtime_ns for path in (folder / "out/settings").glob("*.json")}
    orris(program, folder, CHART + " --quiet")
    changed = [path.name for path, time in times.items() if path.stat().st_mtime_ns != time]
    assert not changed, changed
    after = rows(folder / "out/settings.csv")
    for row in (*before.values(), *after.values()):  # no --mark this time
        row["published"] = row["published_ratio"] = ""
    assert after == before


def test_changed_pack_is_measured_again(program, folder):
    changed = folder / "changed"
    shutil.copytree(folder / "out", changed)
    composite = folder / "pack/shaders/composite.fsh"
    composite.write_text(COMPOSITE.replace("SHARE *", "0.9 * SHARE *"))
    result = orris(program, folder, CHART.replace("-o out", "-o changed"))
    assert "measured again" in result.stderr
    composite.write_text(COMPOSITE)
    # The reference is drawn again too: shares stay shares of it.
    check_numbers(changed)


def test_shards_make_the_whole(program, folder):
    for shard in (1, 2):
        command = CHART.replace("-o out", f"-o part{shard}") + f" --shard {shard}/2"
        result = orris(program, folder, command)
        assert "of 6 settings are measured whole" in result.stderr, result.stderr
        assert len(rows(folder / f"part{shard}/settings.csv")) in (3, 4)
    merged = folder / "merged/settings"
    merged.mkdir(parents=True)
    for shard in (1, 2):
        for path in (folder / f"part{shard}/settings").iterdir():
            shutil.copy(path, merged)
    result = orris(program, folder, CHART.replace("-o out", "-o merged"))
    assert "measured whole" not in result.stderr, result.stderr
    check_numbers(folder / "merged")


def test_budget_is_kept_and_the_next_run_goes_on(program, folder):
    slow = CHART.replace("-o out", "-o slow").replace(f"--rounds {ROUNDS}", "--rounds 400")
    result = orris(program, folder, slow + " --budget 3s")
    assert "settings are measured whole" in result.stderr, result.stderr
    orris(program, folder, CHART.replace("-o out", "-o slow"))
    assert len(rows(folder / "slow/settings.csv")) == 6


def test_cameras_are_judged_together(program, folder):
    command = CHART.replace("-o out", "-o cameras") + " --cameras front,above,front --json"
    answer = json.loads(orris(program, folder, command).stdout)
    assert answer["measured"] == 6
    check_numbers(folder / "cameras")  # the picture is the same from everywhere
    files = [path.name for path in (folder / "cameras/settings").glob("*.json")]
    assert len(files) == 2 * 6 + 1 and sum("_from_above" in name for name in files) == 6, files


def test_scenes_are_rows_of_one_table(program, folder):
    command = ("chart pack --scenes world@above,random:1:2 -o scenes --size 16x9 --runs 3 --warm-up 1 --frames 4 "
               "--rounds 2 --visit 1 --buffer colortex0 --axis SHARE=1.0,0.5 --trace-seconds 0.1")
    result = orris(program, folder, command)
    assert "* " in result.stdout and "SHARE=0.5" in result.stdout, result.stdout
    with open(folder / "scenes/scenes.csv", newline="") as file:
        table = list(csv.DictReader(file))
    assert [(row["scene"], row["setting"]) for row in table] == [
        (scene, f"SHARE={share}") for scene in ("world", "random:1", "random:3") for share in ("1.0", "0.5")], table
    for whole, half in zip(table[::2], table[1::2]):
        assert whole["camera"] == ("above" if whole["scene"] == "world" else "room")
        assert float(whole["signed_red"]) > float(half["signed_red"]), (whole, half)
        for row in (whole, half):  # every picture is the same
            assert float(row["noise_red"]) < 1e-4 and float(row["noise_of_mean_red"]) < 1e-4, row
            assert float(row["drift_red"]) == 0 and row["lag"] == "-1", row
            assert float(row["rms_low_red"]) <= float(row["rms_red"]) <= float(row["rms_high_red"]), row
            for number in ("ratio", "editing_ratio", "moving_ratio", "megabytes"):
                assert float(row[number]) > 0, (number, row)
        assert whole["ratio"] == whole["editing_ratio"] == whole["moving_ratio"] == "1.0000"
    pictures = {path: path.stat().st_mtime_ns for path in (folder / "scenes/settings").glob("*.exr")}
    assert len(pictures) == 3, pictures
    orris(program, folder, command + " --no-costs --quiet")
    assert all(path.stat().st_mtime_ns == time for path, time in pictures.items()), "traced again"


def test_scenes_are_read_one_after_another(program, folder):
    """When the process is shut in: the pack from a zip, options from a file, which lie where nothing else may be read."""
    with zipfile.ZipFile(folder / "pack.zip", "w") as archive:
        for name, text in FILES.items():
            archive.writestr(f"shaders/{name}", text)
    (folder / "half.txt").write_text("SHARE=0.5\n")
    orris(program, folder, "chart pack.zip --scenes world,random:1:1 -o zipped --size 16x9 --runs 3 --warm-up 1 --frames 2 "
                           "--no-costs --trace-seconds 0.1 --settings half.txt --quiet")
    with open(folder / "zipped/scenes.csv", newline="") as file:
        assert len(list(csv.DictReader(file))) == 2


def test_tracing_a_scene_may_take_longer_than_a_frame(program, folder):
    orris(program, folder, "chart pack --scenes world -o slow --size 16x9 --runs 3 --warm-up 1 --frames 2 --no-costs "
                           "--trace-seconds 5 --trace-noise 1e-9 --frame-limit 4s --quiet")


def test_runs_of_scenes_share_no_random_numbers(program, folder):
    noisy = folder / "noisy/shaders"
    shutil.copytree(folder / "pack/shaders", noisy)
    text = (noisy / "composite.fsh").read_text()
    text = text.replace("in vec2 uv;", "in vec2 uv;\nuniform int frameCounter;")
    text = text.replace("vec4(vec3(SHARE", "vec4(vec3((0.5 + 0.5 * fract(float(frameCounter) * 0.137)) * SHARE")
    (noisy / "composite.fsh").write_text(text)
    orris(program, folder, "chart noisy --scenes world -o apart --size 16x9 --runs 4 --warm-up 1 --frames 2 --no-costs "
                           "--buffer colortex0 --trace-seconds 0.1 --quiet")
    with open(folder / "apart/scenes.csv", newline="") as file:
        row = next(csv.DictReader(file))
    assert float(row["noise_of_mean_red"]) > 0.02, row  # 0 where all runs draw the same frames
    assert float(row["signed_high_red"]) - float(row["signed_low_red"]) > 0.05, row


def test_tune(program, folder):
    tune = f"tune pack world -o pack.txt {MEASURE} --axis SHARE --axis WORK "
    result = orris(program, folder, tune + "--error 0.3")
    text = (folder / "pack.txt").read_text()
    assert text == "SHARE=0.8\n", text  # WORK=200 is the default
    assert result.stdout.startswith("SHARE=0.8 WORK=200: "), result.stdout
    assert "the cheapest found with an error of at most 0.3" in result.stdout
    assert re.search(r"SHARE=0\.5 WORK=200: .*too wrong", result.stdout), result.stdout
    assert re.search(r"SHARE=0\.8 WORK=800: .* times the cost", result.stdout), result.stdout
    orris(program, folder, "render pack world -o tuned.exr --size 8x8 --frames 1 "
                           "--settings pack.txt")

    milliseconds = 1.3 * float(rows(folder / "out/settings.csv")["SHARE=1.0 WORK=200"]["ms"])
    answer = json.loads(orris(program, folder, tune + f"--ms {milliseconds} --json").stdout)
    assert not COMPARES_COSTS or answer["values"]["SHARE"] == "1.0", answer
    result = orris(program, folder, tune.replace("pack.txt", "none.txt") + "--ms 0.000001", 1)
    assert "no setting tried takes at most 1e-06 ms a frame" in result.stderr, result.stderr
    assert "nearest is SHARE=" in result.stderr
    assert not (folder / "none.txt").exists()


def test_tune_takes_the_profiles(program, folder):
    orris(program, folder, f"tune pack world -o profile.txt {MEASURE} --error 0.001")
    assert (folder / "profile.txt").read_text() == "WORK=800\n"


FURTHER = (test_changed_pack_is_measured_again, test_shards_make_the_whole, test_budget_is_kept_and_the_next_run_goes_on,
           test_cameras_are_judged_together, test_tune_takes_the_profiles)


def main():
    program = os.path.abspath(sys.argv[1])
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        (folder / "pack/shaders").mkdir(parents=True)
        for name, text in FILES.items():
            (folder / "pack/shaders" / name).write_text(text)
        (folder / "world").mkdir()
        (folder / "world/world.json").write_text(json.dumps(WORLD))
        for name, test in list(globals().items()):
            if name.startswith("test_") and (COMPARES_COSTS or test not in FURTHER):
                test(program, folder)
                print("passed", name)


if __name__ == "__main__":
    main()
