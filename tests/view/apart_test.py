"""Runs `orris view` on a software rasteriser, where it draws in a process that is shut in, apart from its window.

apart_test.py --list          names of the cases
apart_test.py ORRIS CASE      runs one; exit status 77 means skipped
"""

import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time
import zipfile

import cases
from view_test import HEIGHT, TIMEOUT, Test, View, mean, read_png, read_screen, share_within_one

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "app"))
from hostile_programs import DEADLY, ENDLESS, VERSION  # noqa: E402

SECRET = "hunter2"
FRAME_LIMIT = "4s"


def doctor(test):
    environment = dict(os.environ, DISPLAY=test.display.name)
    text = subprocess.run([test.orris, "doctor", "--json"], stdout=subprocess.PIPE, text=True, env=environment,
                          timeout=TIMEOUT).stdout
    return json.loads(text)


def offered(test):
    """What this machine has for a sandbox: (Landlock, filters of system calls)."""
    kernel = doctor(test)["kernel"]
    return "Landlock: none" not in kernel, "seccomp: none" not in kernel


def drawing_process(view):
    """The number of the process that draws for the one with the window."""
    found = view.processes()
    assert len(found) == 3, found
    return found[-1]


def is_running(pid):
    try:
        return pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except FileNotFoundError:
        return False


def shaders_made_anew(test):
    """The same files in a folder that was not there before, with another tint."""
    shaders = test.pack / "shaders"
    shaders.rename(test.folder / "before")
    shutil.copytree(test.folder / "before", shaders)
    test.edit("#define TINT 0", "#define TINT 1")


def process_that_draws_has_no_secret_and_no_way_out(test):
    os.environ["TOKEN"] = SECRET
    assert doctor(test)["window"].endswith("; view draws in the sandbox, apart from its window"), doctor(test)
    view = View(test)
    view.wait_for("ready")
    process = pathlib.Path(f"/proc/{drawing_process(view)}")
    assert SECRET.encode() not in (process / "environ").read_bytes()
    # The window's connection to the display is not among what is open.
    links = (os.readlink(link) for link in (process / "fd").iterdir() if int(link.name) > 2)
    # The driver may be reading a program of its cache.
    opened = sorted(link.split(":")[0] for link in links if "/orris/driver/" not in link)
    assert opened.count("socket") == 2 and not any(name.startswith("/") for name in opened), opened
    if offered(test)[1]:
        assert "Seccomp:\t2\n" in (process / "status").read_text()
    else:
        print("not looked at: this kernel or build has no filters of system calls")
    number = int(process.name)
    view.process.kill()
    view.process.wait()
    end = time.monotonic() + TIMEOUT
    while is_running(number) and time.monotonic() < end:
        time.sleep(0.02)
    assert not is_running(number), "the process that draws is left"


def what_lies_beside_hidden_folders_is_not_read(test):
    if not offered(test)[0]:
        raise cases.Skip("this kernel has no Landlock")
    (test.pack / ".git").mkdir()
    view = View(test)
    view.wait_for("ready")
    shaders_made_anew(test)  # which is another folder than the one that may be read
    view.wait_for("not reloaded: the last good pack keeps running")
    view.end(status=1)


def folder_that_is_made_anew_is_read(test):
    view = View(test)
    view.wait_for("ready")
    shaders_made_anew(test)
    view.wait_for("reloaded")
    view.end()
    assert view.stderr() == "", view.stderr()


def files_that_are_put_in_the_place_of_others_are_read(test):
    """The option file and a zip, which lie where nothing else may be read."""
    archive = test.folder / "pack.zip"

    def pack_up(name):
        with zipfile.ZipFile(test.folder / name, "w") as file:
            for path in sorted(test.pack.rglob("*")):
                file.write(path, path.relative_to(test.pack))

    pack_up(archive.name)
    before = mean(test.picture())
    test.pack = archive
    picture = test.folder / "after.png"
    view = View(test, "--screenshot", picture)
    view.wait_for("ready")
    for value in "12":
        (test.folder / "new.txt").write_text(f"TINT={value}\n")
        (test.folder / "new.txt").rename(test.folder / "pack.zip.txt")
        view.wait_for("reloaded (pack.zip.txt changed)")
    test.pack = test.folder / "pack"
    test.edit("return color;", "return color.grb;")
    pack_up("new.zip")
    (test.folder / "new.zip").rename(archive)
    view.wait_for("reloaded (pack.zip changed)")
    view.end()
    assert view.stderr() == "", view.stderr()
    assert mean(read_png(picture)) != before


def driver_that_dies_or_does_not_end_is_reported(test):
    (test.pack / "shaders" / "composite1.csh").write_text(ENDLESS)
    view = View(test, "--frame-limit", FRAME_LIMIT)
    view.finish(status=3)
    errors = view.stderr()
    assert "/composite1.csh: error: the driver took longer than 4 s while drawing frame 1, in composite1" in errors, errors
    (test.pack / "shaders" / "composite1.csh").unlink()
    (test.pack / "shaders" / "composite.fsh").write_text(DEADLY)
    view = View(test, "--memory-limit", "2G", "--frame-limit", "30s")
    view.finish(status=3)
    errors = view.stderr()
    assert "/composite.fsh: error: the driver died while " in errors and "[driver-died]" in errors, errors


def wait_until_taken_back(view, cause):
    """Linking may go well, so that the driver dies of the frame."""
    line = view.lines.get(timeout=TIMEOUT)
    if line.startswith(f"reloaded ({cause} changed)"):
        line = view.lines.get(timeout=TIMEOUT)
    assert line == "taken back: the last good pack draws again", (line, view.stderr())


def edit_that_the_driver_dies_of_leaves_the_last_good_pack(test):
    shaders = test.pack / "shaders"
    good = (shaders / "composite.fsh").read_text()
    view = View(test, "--memory-limit", "2G", "--frame-limit", FRAME_LIMIT)
    view.wait_for("ready")
    start = before = view.screenshot()
    test.tell_display("key", "2")  # the second of the world's cameras, from the next frame on
    end = time.monotonic() + TIMEOUT
    while before == start and time.monotonic() < end:
        before = view.screenshot()
    assert before != start
    window = view.process.pid
    # The same edit, mended and made again; then a file more, which stalls the driver.
    for _ in range(2):
        (shaders / "composite.fsh").write_text(DEADLY)
        wait_until_taken_back(view, "composite.fsh")
        assert share_within_one(view.screenshot(), before) == 1
        (shaders / "composite.fsh").write_text(good)
        view.wait_for("reloaded (composite.fsh changed)")
    (shaders / "composite1.csh").write_text(ENDLESS)
    wait_until_taken_back(view, "composite1.csh")
    assert share_within_one(view.screenshot(), before) == 1
    errors = view.stderr()
    assert errors.count("/composite.fsh: error: the driver ") == 2, errors  # it dies, or without a limit takes long
    assert errors.count("/composite1.csh: error: the driver took longer than 4 s") == 1, errors
    assert errors.count(": error:") == 3 and view.process.pid == window, errors
    view.end(status=1)


def time_of_day_and_panels_outlive_the_driver(test):
    test.edit("#define TINT 0", "uniform int worldTime;\n#define TINT 0")
    test.edit("return color;", "return color * (worldTime > 12000 ? 0.3 : 1.0);")
    view = View(test, "--memory-limit", "2G", "--frame-limit", FRAME_LIMIT)
    view.wait_for("ready")
    noon = night = view.screenshot()
    test.tell_display("key", "t")
    end = time.monotonic() + TIMEOUT
    while share_within_one(night, noon) > 0.5 and time.monotonic() < end:
        test.tell_display("mousemove", "100", "40", "click", "1")  # near the end of the slider of time
        time.sleep(0.2)
        night = view.screenshot()
    (test.pack / "shaders" / "composite.fsh").write_text(DEADLY)
    wait_until_taken_back(view, "composite.fsh")
    assert share_within_one(view.screenshot(), night) == 1
    # The title of the panel lies over the first lines of the picture.
    title = read_screen(test.display.pixels)[:14]
    assert share_within_one(title, night[:14]) < 0.5
    view.end(status=1)


def option_that_the_driver_dies_of_is_taken_back(test):
    """The option file stays as it was written; what is drawn are the values before."""
    program = test.pack / "shaders" / "composite.fsh"
    version, good = program.read_text().split("\n", 1)
    program.write_text(f"{version}\n#include \"/lib/tint.glsl\"\n#if TINT == 2\n{DEADLY.removeprefix(VERSION)}\n"
                       f"#else\n{good.replace('#include', '//')}\n#endif\n")
    options = test.folder / "pack.txt"
    options.write_text("TINT=1\n")
    view = View(test, "--memory-limit", "2G", "--frame-limit", "30s")
    view.wait_for("ready")
    before = view.screenshot()
    options.write_text("TINT=2\n")
    wait_until_taken_back(view, "pack.txt")
    assert options.read_text() == "TINT=2\n" and share_within_one(view.screenshot(), before) == 1
    options.write_text("TINT=0\n")
    view.wait_for("reloaded (pack.txt changed)")
    assert share_within_one(view.screenshot(), before) < 1
    view.end()


def edit_while_the_driver_stalls_is_read(test):
    view = View(test, "--frame-limit", FRAME_LIMIT)
    view.wait_for("ready")
    stall = test.pack / "shaders" / "composite1.csh"
    stall.write_text(ENDLESS)
    view.wait_for("reloaded (composite1.csh changed)")  # and its first frame stalls
    stall.unlink()
    test.edit("#define TINT 0", "#define TINT 1")
    view.wait_for("taken back: the last good pack draws again")
    view.wait_for("reloaded (files changed)")
    view.end()


def window_ends_when_the_last_good_pack_dies_too(test):
    """Here the process that draws is killed from outside."""
    view = View(test)
    view.wait_for("ready")
    view.screenshot()
    os.kill(drawing_process(view), signal.SIGKILL)
    view.finish(status=3)
    assert "error: the driver died" in view.stderr(), view.stderr()


def pause_is_no_frame_that_takes_long(test):
    view = View(test, "--frame-limit", FRAME_LIMIT)
    view.wait_for("ready")
    view.screenshot()
    test.tell_display("key", "comma")
    time.sleep(5)
    view.screenshot()
    view.end()
    assert view.stderr() == "", view.stderr()


def editor_is_the_users_own(test):
    """It has the environment and the rights that the process which draws has not."""
    editor = test.folder / "editor"
    editor.write_text('#!/bin/sh\necho "$HOME $@" > opened.new\nmv opened.new opened\n')
    editor.chmod(0o755)
    os.environ["VISUAL"] = str(editor)
    view = View(test)
    view.wait_for("ready")
    time.sleep(1)
    test.edit("return color;", "return color")
    view.wait_for("not reloaded")
    test.tell_display("key", "e")
    view.wait_for("opened /lib/tint.glsl:9:")
    opened = test.folder / "opened"
    end = time.monotonic() + TIMEOUT
    while not opened.exists() and time.monotonic() < end:
        time.sleep(0.02)
    assert opened.read_text() == f"{os.environ['HOME']} +9 {test.tint}\n", opened.read_text()
    view.end(status=1)


def options_are_chosen_in_a_panel_and_saved(test):
    view = View(test)
    view.wait_for("ready")
    time.sleep(1)
    test.tell_display("key", "o")
    saved = test.folder / "pack.txt"
    end = time.monotonic() + TIMEOUT
    while not saved.exists() and time.monotonic() < end:
        for y in range(20, HEIGHT, 10):  # the one option is on one of these lines
            test.tell_display("mousemove", "60", str(y), "click", "1")
        time.sleep(1)
    assert saved.exists()
    view.wait_for("reloaded (TINT=1)")
    view.end()
    assert view.stderr() == "", view.stderr()


CASES = [process_that_draws_has_no_secret_and_no_way_out, what_lies_beside_hidden_folders_is_not_read,
         folder_that_is_made_anew_is_read, files_that_are_put_in_the_place_of_others_are_read,
         driver_that_dies_or_does_not_end_is_reported, edit_that_the_driver_dies_of_leaves_the_last_good_pack,
         time_of_day_and_panels_outlive_the_driver, option_that_the_driver_dies_of_is_taken_back, edit_while_the_driver_stalls_is_read,
         window_ends_when_the_last_good_pack_dies_too, pause_is_no_frame_that_takes_long, editor_is_the_users_own,
         options_are_chosen_in_a_panel_and_saved]


if __name__ == "__main__":
    sys.exit(cases.main(CASES, Test))
