"""A page in a headless Chromium, driven through its remote debugging pipe (NUL-separated JSON on the file
descriptors 3 and 4): no package besides the browser is needed.

    with Browser.start(scratch) as page:      # None and a printed reason where there is no browser
        page.open(path, width=390)
        page.evaluate("document.title")
"""
import base64
import json
import os
import select
import shutil
import subprocess
import time

NAMES = ("chromium", "chromium-browser", "google-chrome")
FLAGS = ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars", "--no-first-run",
         "--disable-background-networking", "--disable-component-update", "--disable-extensions", "--remote-debugging-pipe")
SECONDS = 90


class Browser:
    @classmethod
    def start(cls, scratch):
        program = next(filter(None, map(shutil.which, NAMES)), None)
        if program is None:
            print("SKIPPED: no chromium to open pages with (Debian: chromium)")
            return None
        return cls(program, scratch)

    def __init__(self, program, scratch):
        to_browser, self.writes = os.pipe()
        self.reads, from_browser = os.pipe()
        # The shell puts the pipes where the browser looks for them, whatever their numbers are here.
        self.process = subprocess.Popen(
            ["sh", "-c", f'exec "$@" 3<&{to_browser} 4>&{from_browser}', "sh", program, *FLAGS,
             f"--user-data-dir={scratch}/profile", "about:blank"],
            pass_fds=(to_browser, from_browser), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL, env={**os.environ, "HOME": str(scratch)})
        os.close(to_browser)
        os.close(from_browser)
        self.buffer, self.number, self.session = b"", 0, None
        self.problems = []  # errors of scripts, of the console and of loading
        self.requests = []  # everything that is fetched
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        try:
            self.session = None
            self.call("Browser.close")
        finally:
            os.close(self.writes)
            os.close(self.reads)
            try:
                self.process.wait(10)
            except subprocess.TimeoutExpired:
                self.process.kill()
                self.process.wait()

    def receive(self, deadline):
        while b"\0" not in self.buffer:
            ready, _, _ = select.select([self.reads], [], [], max(0, deadline - time.monotonic()))
            part = os.read(self.reads, 1 << 20) if ready else b""
            assert part, "the browser does not answer"
            self.buffer += part
        text, _, self.buffer = self.buffer.partition(b"\0")
        return json.loads(text)

    def note(self, message):
        method, values = message.get("method"), message.get("params", {})
        if method == "Runtime.exceptionThrown":
            details = values["exceptionDetails"]
            self.problems.append(details.get("exception", {}).get("description", details["text"]))
        elif method == "Runtime.consoleAPICalled" and values["type"] in ("error", "warning", "assert"):
            self.problems.append(str(values["args"]))
        elif method == "Log.entryAdded" and values["entry"]["level"] in ("error", "warning"):
            self.problems.append(values["entry"]["text"])
        elif method == "Network.requestWillBeSent":
            self.requests.append(values["request"]["url"])

    def call(self, method, **values):
        self.number += 1
        message = {"id": self.number, "method": method, "params": values}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.writes, json.dumps(message).encode() + b"\0")
        deadline = time.monotonic() + SECONDS
        while True:
            answer = self.receive(deadline)
            if answer.get("id") == self.number:
                assert "error" not in answer, (method, answer["error"])
                return answer["result"]
            self.note(answer)

    def evaluate(self, expression):
        result = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        assert "exceptionDetails" not in result, (expression, result["exceptionDetails"])
        return result["result"].get("value")

    def until(self, expression):
        deadline = time.monotonic() + SECONDS
        while not (value := self.evaluate(expression)):
            assert time.monotonic() < deadline, expression
            time.sleep(0.05)
        return value

    def open(self, path, width=1200, height=900, dark=False, scripts=True):
        """Loads a file of this machine as a screen of that width shows it."""
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1,
                  mobile=width < 600)
        self.call("Emulation.setEmulatedMedia",
                  features=[{"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])
        self.call("Emulation.setScriptExecutionDisabled", value=not scripts)
        self.call("Page.navigate", url=path.resolve().as_uri())
        self.until("document.readyState == 'complete' && location.href != 'about:blank'")

    def press(self, key, code):
        for kind in ("keyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key=key, code=key, windowsVirtualKeyCode=code)

    def mouse(self, kind, x, y):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1,
                  buttons=0 if kind == "mouseReleased" else 1)

    def screenshot(self, path, whole=True):
        data = self.call("Page.captureScreenshot", captureBeyondViewport=whole)["data"]
        path.write_bytes(base64.b64decode(data))

    # What any page must fulfil.

    def check_pictures(self):
        """All pictures were decoded; how many there are."""
        pictures = int(self.until("document.body.dataset.pictures"))
        loaded = int(self.evaluate("document.body.dataset.loaded"))
        assert loaded == pictures, (loaded, pictures)
        return pictures

    def check_fits(self):
        """Nothing is wider than the screen, and no text smaller than 12 pixels."""
        width, shown = self.evaluate("[document.documentElement.scrollWidth, innerWidth]")
        assert width <= shown, (width, shown)
        sizes = self.evaluate("[...document.querySelectorAll('p, td, th, figcaption, label, summary, pre')].map("
                              "(e) => parseFloat(getComputedStyle(e).fontSize))")
        assert min(sizes) >= 12, min(sizes)

    def contrast(self):
        """Of text on its page, as WCAG defines it."""
        def luminance(colour):
            parts = [float(part) / 255 for part in colour[colour.index("(") + 1:-1].split(",")[:3]]
            linear = [p / 12.92 if p <= 0.04045 else ((p + 0.055) / 1.055) ** 2.4 for p in parts]
            return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
        text, back = map(luminance, self.evaluate(
            "[getComputedStyle(document.body).color, getComputedStyle(document.body).backgroundColor]"))
        return (max(text, back) + 0.05) / (min(text, back) + 0.05), back

    def check_names(self):
        """Each picture has a text, each control a label."""
        unnamed = self.evaluate("[...document.querySelectorAll('img')].filter((e) => !e.alt).length + "
                                "[...document.querySelectorAll('input, select')].filter("
                                "(e) => !e.labels.length && !e.ariaLabel).length")
        assert unnamed == 0, unnamed
