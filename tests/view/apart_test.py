"""Runs `orris view` on a software rasteriser, where it draws in a process that is shut in, apart from its window.

apart_test.py --list          names of the cases
apart_test.py ORRIS CASE      runs one; exit status 77 means skipped
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import time
import zipfile

import cases
from view_test import HEIGHT, TIMEOUT, Test, View, mean, read_png

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "app"))
from hostile_programs import DEADLY, ENDLESS  # noqa: E402

SECRET = "hunter2"


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
    found = pathlib.Path(f"/proc/{view.process.pid}/task/{view.process.pid}/children").read_text().split()
    assert len(found) == 1, found
    return int(found[0])


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
    opened = sorted(os.readlink(link).split(":")[0] for link in (process / "fd").iterdir() if int(link.name) > 2)
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
    view = View(test, "--frame-limit", "8s")
    view.finish(status=3)
    errors = view.stderr()
    assert "/composite1.csh: error: the driver took longer than 8 s while drawing frame 1, in composite1" in errors, errors
    (test.pack / "shaders" / "composite1.csh").unlink()
    (test.pack / "shaders" / "composite.fsh").write_text(DEADLY)
    view = View(test, "--memory-limit", "2G", "--frame-limit", "30s")
    view.finish(status=3)
    errors = view.stderr()
    assert "/composite.fsh: error: the driver died while " in errors and "[driver-died]" in errors, errors


def pause_is_no_frame_that_takes_long(test):
    view = View(test, "--frame-limit", "8s")
    view.wait_for("ready")
    time.sleep(1)
    test.tell_display("key", "comma")
    time.sleep(10)
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
         driver_that_dies_or_does_not_end_is_reported, pause_is_no_frame_that_takes_long, editor_is_the_users_own,
         options_are_chosen_in_a_panel_and_saved]


if __name__ == "__main__":
    sys.exit(cases.main(CASES, Test))
