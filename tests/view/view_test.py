"""Runs `orris view` under a virtual display while files are edited.

view_test.py --list          names of the cases
view_test.py ORRIS CASE      runs one; exit status 77 means skipped
"""

import os
import pathlib
import queue
import shutil
import signal
import struct
import subprocess
import sys
import threading
import time
import zlib

import cases

HERE = pathlib.Path(__file__).resolve().parent
WIDTH, HEIGHT = 160, 120
TIMEOUT = 60


def read_png(path):
    """Rows of (r, g, b) bytes of an 8-bit RGB or RGBA picture."""
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", f"{path} is no PNG"
    at, packed, width, height, kind = 8, b"", 0, 0, 2
    while at < len(data):
        length, name = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        at += length + 12
        if name == b"IHDR":
            width, height, bits, kind = struct.unpack(">IIBB", body[:10])
            assert bits == 8 and kind in (2, 6), (bits, kind)
        elif name == b"IDAT":
            packed += body
    size = 3 if kind == 2 else 4
    raw, stride = zlib.decompress(packed), width * size
    rows, above = [], bytearray(stride)
    for y in range(height):
        start = y * (stride + 1)
        row = unfilter(raw[start], bytearray(raw[start + 1:start + 1 + stride]), above, size)
        rows.append([tuple(row[x:x + 3]) for x in range(0, stride, size)])
        above = row
    return rows


def unfilter(kind, row, above, size):
    for i in range(len(row)):
        a = row[i - size] if i >= size else 0
        b = above[i]
        c = above[i - size] if i >= size else 0
        if kind == 1:
            row[i] = (row[i] + a) & 255
        elif kind == 2:
            row[i] = (row[i] + b) & 255
        elif kind == 3:
            row[i] = (row[i] + (a + b) // 2) & 255
        elif kind == 4:
            pa, pb, pc = abs(b - c), abs(a - c), abs(a + b - 2 * c)
            row[i] = (row[i] + (a if pa <= pb and pa <= pc else b if pb <= pc else c)) & 255
    return row


def read_screen(path):
    """Top left part of the virtual display, which keeps its pixels in an xwd file."""
    data = path.read_bytes()
    head = struct.unpack(">25I", data[:100])
    header_size, colors, stride = head[0], head[19], head[12]
    start = header_size + colors * 12
    rows = []
    for y in range(HEIGHT):
        row = data[start + y * stride:start + y * stride + WIDTH * 4]
        rows.append([(row[x + 2], row[x + 1], row[x]) for x in range(0, WIDTH * 4, 4)])
    return rows


def share_within_one(a, b):
    """Fraction of pixels whose channels differ by at most 1 of 255."""
    assert (len(a), len(a[0])) == (len(b), len(b[0])), "the pictures differ in size"
    pairs = [pair for rows in zip(a, b) for pair in zip(*rows)]
    near = sum(all(abs(x - y) <= 1 for x, y in zip(p, q)) for p, q in pairs)
    return near / len(pairs)


def mean(picture):
    pixels = [pixel for row in picture for pixel in row]
    return [sum(pixel[c] for pixel in pixels) / len(pixels) for c in range(3)]


class Display:
    """A virtual display of our own: its number, and a file with its pixels."""

    def __init__(self, folder):
        if shutil.which("Xvfb") is None:
            raise cases.Skip("Xvfb is not installed")
        read_end, write_end = os.pipe()
        command = ["Xvfb", "-displayfd", str(write_end), "-screen", "0", "800x600x24",
                   "-fbdir", str(folder), "-nolisten", "tcp"]
        self.process = subprocess.Popen(command, pass_fds=[write_end], stderr=subprocess.DEVNULL)
        os.close(write_end)
        with os.fdopen(read_end) as answer:
            self.name = ":" + answer.readline().strip()
        assert self.name != ":", "Xvfb did not start"
        self.pixels = folder / "Xvfb_screen0"

    def stop(self):
        self.process.terminate()
        self.process.wait()


class View:
    """A running `orris view`."""

    def __init__(self, test, *arguments):
        self.test = test
        self.errors = test.folder / "errors.txt"
        command = [test.orris, "view", test.pack, HERE / "world", "--size", f"{WIDTH}x{HEIGHT}"]
        environment = dict(os.environ, DISPLAY=test.display.name)
        with open(self.errors, "w") as errors:
            self.process = subprocess.Popen(
                [str(word) for word in [*command, *arguments]], stdout=subprocess.PIPE,
                stderr=errors, text=True, cwd=test.folder, env=environment)
        test.views.append(self)
        self.lines = queue.Queue()
        self.reader = threading.Thread(target=self.read, daemon=True)
        self.reader.start()

    def read(self):
        for line in self.process.stdout:
            self.lines.put(line.rstrip("\n"))

    def wait_for(self, start):
        """The next line of output must start so."""
        try:
            line = self.lines.get(timeout=TIMEOUT)
        except queue.Empty:
            raise AssertionError(f'"{start}" did not come\n{self.stderr()}') from None
        assert line.startswith(start), f'expected "{start}", got "{line}"\n{self.stderr()}'
        return line

    def stderr(self):
        return self.errors.read_text()

    def processes(self):
        """Its own and those below it: the one with the window, one between, and last the one that draws."""
        found = [self.process.pid]
        for pid in found:
            found += [int(word) for word in open(f"/proc/{pid}/task/{pid}/children").read().split()]
        return found

    def memory(self):
        """Resident memory in MiB, of all its processes."""
        lines = [line for pid in self.processes() for line in open(f"/proc/{pid}/status") if line.startswith("VmRSS:")]
        return sum(int(line.split()[1]) for line in lines) / 1024

    def screenshot(self):
        """Presses F2 and reads the picture."""
        self.test.tell_display("key", "F2")
        line = self.wait_for("screenshot: ")
        return read_png(self.test.folder / line.removeprefix("screenshot: "))

    def end(self, status=0):
        """Interrupts it, as ^C does."""
        self.process.send_signal(signal.SIGINT)
        self.finish(status)

    def finish(self, status=0):
        """Waits until it ends by itself."""
        self.process.wait(timeout=TIMEOUT)
        self.reader.join(timeout=TIMEOUT)
        assert self.process.returncode == status, (self.process.returncode, self.stderr())


class Test:
    """What a case works with: a copy of the pack, a display, a folder that goes away."""

    def __init__(self, orris, folder):
        self.orris, self.folder = orris, folder
        self.pack = folder / "pack"
        shutil.copytree(HERE / "pack", self.pack)
        self.tint = self.pack / "shaders" / "lib" / "tint.glsl"
        self.display = Display(folder)
        self.views = []

    def stop(self):
        for view in self.views:
            if view.process.poll() is None:
                view.process.kill()
                view.process.wait()
        self.display.stop()

    def edit(self, old, new):
        text = self.tint.read_text()
        assert old in text, old
        self.tint.write_text(text.replace(old, new))

    def tell_display(self, *arguments):
        """Keys and mouse, through xdotool."""
        if shutil.which("xdotool") is None:
            raise cases.Skip("xdotool is not installed")
        environment = dict(os.environ, DISPLAY=self.display.name)
        subprocess.run(["xdotool", *arguments], env=environment, check=True, timeout=TIMEOUT,
                       stdout=subprocess.DEVNULL)

    def picture(self, *arguments):
        """What a view of three frames shows."""
        path = self.folder / "picture.png"
        view = View(self, "--frames", "3", "--screenshot", path, *arguments)
        view.finish()
        assert view.stderr() == "", view.stderr()
        return read_png(path)


def shows_what_render_draws(test):
    arguments = ["--camera", "top", "--frames", "4"]
    path = test.folder / "render.png"
    subprocess.run(
        [test.orris, "render", test.pack, HERE / "world", "--size", f"{WIDTH}x{HEIGHT}",
         *arguments, "-o", path], check=True, timeout=TIMEOUT)
    shown = test.folder / "view.png"
    View(test, *arguments, "--screenshot", shown).finish()
    share = share_within_one(read_png(shown), read_png(path))
    assert share >= 0.999, share


def window_shows_the_screenshot(test):
    path = test.folder / "screenshot.png"
    view = View(test, "--screenshot", path)
    view.wait_for("ready")
    time.sleep(1)
    screen = read_screen(test.display.pixels)
    view.end()
    picture = read_png(path)
    assert max(mean(picture)) > 20, "nothing was drawn"
    assert share_within_one(screen, picture) == 1


def edited_shader_changes_the_picture(test):
    before = test.picture()
    path = test.folder / "after.png"
    view = View(test, "--screenshot", path)
    view.wait_for("ready")
    test.edit("#define TINT 0", "#define TINT 1")
    line = view.wait_for("reloaded")
    assert line.startswith("reloaded (tint.glsl changed): 1 programs built: composite, 3 kept, "), line
    view.end()
    assert view.stderr() == "", view.stderr()
    red, green, _ = mean(read_png(path))
    assert green < 0.4 * mean(before)[1], "the tint does not show"
    assert abs(red - mean(before)[0]) < 1


def broken_edit_changes_nothing_and_is_reported_once(test):
    before = test.picture()
    path = test.folder / "after.png"
    view = View(test, "--screenshot", path)
    view.wait_for("ready")
    test.edit("return color;", "return color")
    view.wait_for("not reloaded: the last good pack keeps running")
    time.sleep(1)
    view.end(status=1)
    errors = view.stderr()
    assert errors.count(": error:") == 1, errors
    assert errors.startswith("/lib/tint.glsl:9:") and "included from /composite.fsh:2" in errors, errors
    assert share_within_one(read_png(path), before) == 1


def repaired_edit_is_taken_over(test):
    view = View(test)
    view.wait_for("ready")
    for _ in range(2):  # the same mistake made again is reported again
        test.edit("return color;", "return color")
        view.wait_for("not reloaded")
        test.edit("return color\n", "return color;\n")
        view.wait_for("reloaded (tint.glsl changed): 0 programs built, 4 kept")
    view.end()
    assert view.stderr().count(": error:") == 2, view.stderr()


def missing_include_is_located_and_changes_nothing(test):
    view = View(test)
    view.wait_for("ready")
    test.tint.rename(test.tint.with_name("moved.glsl"))
    view.wait_for("not reloaded")
    test.tint.with_name("moved.glsl").rename(test.tint)
    view.wait_for("reloaded")
    view.end()
    errors = view.stderr()
    assert errors.count(": error:") == 1 and "/composite.fsh:2:" in errors, errors


def single_frame_lasts_a_sixtieth_of_a_second(test):
    test.edit("#define TINT 0", "uniform float frameTime;\n#define TINT 0")
    test.edit("return color;", "return abs(frameTime * 60.0 - 1.0) < 1e-4 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);")
    view = View(test)
    view.wait_for("ready")
    test.tell_display("key", "comma")
    time.sleep(1)
    assert mean(view.screenshot()) == [255, 0, 0]  # of a frame that lasted as long as it took
    test.tell_display("key", "period")
    end = time.monotonic() + TIMEOUT
    while (shown := mean(view.screenshot())) != [0, 255, 0] and time.monotonic() < end:
        time.sleep(0.1)
    assert shown == [0, 255, 0], shown
    view.end()


def option_file_takes_effect(test):
    before = test.picture()
    path = test.folder / "after.png"
    view = View(test, "--screenshot", path)
    view.wait_for("ready")
    options = test.folder / "pack.txt"
    options.write_text("TINT=1\n")
    view.wait_for("reloaded (pack.txt changed): 1 programs built: composite, 3 kept")
    options.write_text("TINT=2\nNO_SUCH_OPTION=1\n")
    view.wait_for("reloaded (pack.txt changed): 1 programs built: composite, 3 kept")
    view.end()
    errors = view.stderr()
    assert errors.count("warning:") == 1 and "pack.txt:2:1: warning:" in errors, errors
    options.write_text("TINT=2\n")
    red, _, blue = mean(read_png(path))
    assert red < 0.4 * mean(before)[0] and abs(blue - mean(before)[2]) < 1
    # What the command line gets wrong is no fault of the pack.
    wrong = View(test, "--set", "TINT=9")
    wrong.finish(status=2)
    assert wrong.stderr().count(": error:") == 1, wrong.stderr()
    # What is there at the start counts too, and the command line counts more.
    assert abs(mean(test.picture())[0] - red) < 1
    assert share_within_one(test.picture("--set", "TINT=0"), before) == 1


def fifty_edits_leave_no_error_and_no_growth(test):
    view = View(test)
    view.wait_for("ready")
    measured = []
    for i in range(50):
        before, after = f"{1 - i / 100:.2f}", f"{1 - (i + 1) / 100:.2f}"
        if i == 0:
            before = "color;"
            after = "color * 0.99;"
        test.edit(f"return color * {before};" if i else "return color;",
                  f"return color * {after};" if i else "return color * 0.99;")
        view.wait_for("reloaded (tint.glsl changed): 1 programs built: composite, 3 kept")
        measured.append(view.memory())
    view.end()
    assert view.stderr() == "", view.stderr()
    growth = measured[-1] - measured[9]
    print(f"resident: {measured[0]:.1f} MiB, {measured[9]:.1f} after 10, {measured[-1]:.1f} after 50")
    assert growth < 8, measured


def events_of_the_world_happen(test):
    world = test.folder / "world"
    shutil.copytree(HERE / "world", world)
    text = (world / "world.json").read_text().rstrip().removesuffix("}").rstrip()
    events = '"events": [{ "frame": 2, "option": { "name": "TINT", "value": "1" } }]'
    (world / "world.json").write_text(text + ",\n" + events + "\n}\n")
    pictures = []
    for frames in ("2", "3"):
        path = test.folder / f"{frames}.png"
        process = subprocess.run(
            [test.orris, "view", test.pack, world, "--size", f"{WIDTH}x{HEIGHT}", "--frames",
             frames, "--screenshot", path], env=dict(os.environ, DISPLAY=test.display.name),
            capture_output=True, text=True, timeout=TIMEOUT)
        assert process.returncode == 0 and process.stderr == "", process.stderr
        pictures.append(read_png(path))
    assert mean(pictures[1])[1] < 0.4 * mean(pictures[0])[1]


def keys_reload_step_profiles_and_take_screenshots(test):
    before, top = test.picture(), test.picture("--camera", "top")
    view = View(test)
    view.wait_for("ready")
    time.sleep(1)
    test.tell_display("key", "r")
    view.wait_for("reloaded (R pressed): 0 programs built, 4 kept")
    test.tell_display("key", "p")
    view.wait_for("reloaded (profile RED): 1 programs built: composite, 3 kept")
    assert mean(view.screenshot())[1] < 0.4 * mean(before)[1]
    time.sleep(1)  # the title follows twice a second
    test.tell_display("search", "--name", "^Orris - pack - RED - [0-9.]+ ms/frame$")
    for profile in ("BLUE", "PLAIN"):
        test.tell_display("key", "p")
        view.wait_for(f"reloaded (profile {profile})")
    test.tell_display("key", "2")
    time.sleep(1)
    assert share_within_one(view.screenshot(), top) == 1
    test.tell_display("key", "Escape")
    view.finish()


def keys_and_mouse_fly(test):
    view = View(test)
    view.wait_for("ready")
    time.sleep(1)
    pictures = [view.screenshot()]
    for action in (["keydown", "w"], ["keydown", "a"], ["keydown", "space"]):
        test.tell_display(*action)
        time.sleep(0.3)
        test.tell_display("keyup", action[1])
        time.sleep(0.5)
        pictures.append(view.screenshot())
    test.tell_display("mousemove", "60", "60", "click", "1")
    time.sleep(0.5)
    test.tell_display("mousemove_relative", "40", "20")
    time.sleep(0.5)
    pictures.append(view.screenshot())
    for before, after in zip(pictures, pictures[1:]):
        assert share_within_one(before, after) < 0.98
    # Esc first gives the mouse back, then ends.
    test.tell_display("key", "Escape")
    time.sleep(0.5)
    still = view.screenshot()
    test.tell_display("mousemove_relative", "30", "30")
    time.sleep(0.5)
    assert share_within_one(still, view.screenshot()) == 1
    test.tell_display("key", "Escape")
    view.finish()


def ends_by_the_window_needing_a_display(test):
    environment = cases.without_display()
    process = subprocess.run([test.orris, "view", test.pack, HERE / "world"], env=environment,
                             stderr=subprocess.PIPE, text=True, timeout=TIMEOUT)
    assert process.returncode == 3, process
    assert process.stderr.startswith("error: cannot start GLFW: "), process.stderr
    assert "hint: a display is needed" in process.stderr, process.stderr
    process = subprocess.run(
        [test.orris, "view", test.pack, HERE / "world", "--backend", "osmesa"], env=environment,
        stderr=subprocess.PIPE, text=True, timeout=TIMEOUT)
    assert process.returncode == 2, process
    assert "view needs a window: glfw, or egl with --script" in process.stderr, process.stderr


def worlds_are_remembered(test):
    test.picture()
    assert (pathlib.Path(os.environ["XDG_STATE_HOME"]) / "orris" / "recent-worlds").read_text() == f"{HERE / 'world'}\n"


CASES = [worlds_are_remembered, shows_what_render_draws, window_shows_the_screenshot,
         edited_shader_changes_the_picture,
         broken_edit_changes_nothing_and_is_reported_once, repaired_edit_is_taken_over,
         missing_include_is_located_and_changes_nothing, option_file_takes_effect, single_frame_lasts_a_sixtieth_of_a_second,
         fifty_edits_leave_no_error_and_no_growth, events_of_the_world_happen,
         keys_reload_step_profiles_and_take_screenshots, keys_and_mouse_fly,
         ends_by_the_window_needing_a_display]


if __name__ == "__main__":
    sys.exit(cases.main(CASES, Test))
