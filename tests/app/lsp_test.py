"""lsp_test.py ORRIS [--pack PACK --edits N --seed S]: a scripted client of `orris lsp`.

Without --pack the tests; with it a session of N random edits and undos in a copy of PACK, its times, and
whether it ends with the findings of `orris validate`.
"""
import argparse
import json
import os
import pathlib
import random
import select
import shutil
import signal
import statistics
import subprocess
import sys
import tempfile
import time
import urllib.parse

HERE = pathlib.Path(__file__).resolve().parent
TIMEOUT = 100
SEVERITIES = {1: "error", 2: "warning", 3: "note"}
FILES = {
    "shaders.properties": "screen=FOG <profile> NOTHING\nsliders=FOG\nprofile.LOW=FOG=0\nblend.composite=off\n",
    "block.properties": "block.1=stone minecraft:oak_log:axis=x\n",
    "lang/en_us.lang": "option.FOG=Fog of the day\n",
    "lib/settings.glsl": "#define FOG 1 // How thick it is [0 1 2]\n",
    "lib/math.glsl": "#define PI 3.14159\nfloat halved(float x) { return x * 0.5; }\n",
    "composite.vsh": "#version 330 compatibility\nout vec2 uv;\n"
                     "void main() { gl_Position = ftransform(); uv = gl_MultiTexCoord0.st; }\n",
    "composite.fsh": "#version 330 compatibility\n#include \"/lib/settings.glsl\"\n#include \"/lib/math.glsl\"\n"
                     "in vec2 uv;\nuniform sampler2D colortex0;\nuniform float frameTimeCounter;\n"
                     "/* RENDERTARGETS: 0 */\nvoid main() {\n"
                     "  gl_FragData[0] = texture2D(colortex0, uv) * halved(float(FOG)) * PI + frameTimeCounter;\n}\n",
    "final.vsh": "#version 330 compatibility\nout vec2 uv;\n"
                 "void main() { gl_Position = ftransform(); uv = gl_MultiTexCoord0.st; }\n",
    "final.fsh": "#version 330 compatibility\nin vec2 uv;\nuniform sampler2D colortex0;\n"
                 "void main() { gl_FragColor = texture2D(colortex0, uv); }\n",
}


def uri_of(path):
    return "file://" + urllib.parse.quote(str(path))


class Client:
    """An editor: keeps what the server publishes."""

    def __init__(self, orris, encodings=("utf-16",)):
        self.process = subprocess.Popen([str(orris), "lsp", "--stdio"], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, start_new_session=True)
        self.bytes, self.next, self.published, self.checks, self.lost = b"", 0, {}, 0, 0
        self.versions, self.parts = {}, []
        self.first_news = None
        self.capabilities = self.ask("initialize", {"capabilities": {"general": {
            "positionEncodings": list(encodings)}}})["capabilities"]
        self.notify("initialized", {})

    def send(self, message):
        body = json.dumps({"jsonrpc": "2.0", **message}).encode()
        self.process.stdin.write(b"Content-Length: %d\r\n\r\n%s" % (len(body), body))
        self.process.stdin.flush()

    def receive(self, until):
        """The next message; None when there is none by `until`."""
        while True:
            head, mark, rest = self.bytes.partition(b"\r\n\r\n")
            if mark:
                length = int(head.split(b":")[1])
                if len(rest) >= length:
                    self.bytes = rest[length:]
                    return json.loads(rest[:length])
            if not select.select([self.process.stdout], [], [], max(until - time.monotonic(), 0))[0]:
                return None
            more = self.process.stdout.read1(1 << 16)
            assert more, f"the server ended: {self.process.wait()}"
            self.bytes += more

    def take(self, message):
        if message.get("method") == "textDocument/publishDiagnostics":
            self.published[message["params"]["uri"]] = message["params"]["diagnostics"]
        if message.get("method") == "orris/checked":
            self.parts.append(message["params"]["part"])
            self.first_news = self.first_news or time.monotonic()
            self.checks += message["params"]["part"] != "programs"
            self.lost += message["params"]["part"] == "lost"

    def notify(self, method, params):
        self.send({"method": method, "params": params})

    def request(self, method, params):
        self.next += 1
        self.send({"id": self.next, "method": method, "params": params})
        until = time.monotonic() + TIMEOUT
        while True:
            message = self.receive(until)
            assert message is not None, f"no answer to {method}"
            if message.get("id") == self.next:
                return message
            self.take(message)

    def ask(self, method, params):
        message = self.request(method, params)
        assert "error" not in message, message
        return message["result"]

    def settle(self, checks=1):
        """Waits until so many checks have ended."""
        wanted, until = self.checks + checks, time.monotonic() + TIMEOUT
        while self.checks < wanted:
            message = self.receive(until)
            assert message is not None, "no check ended"
            self.take(message)

    def next_part(self):
        """Waits for the next part of a check; its name."""
        seen, until = len(self.parts), time.monotonic() + TIMEOUT
        while len(self.parts) == seen:
            message = self.receive(until)
            assert message is not None, "no part of a check"
            self.take(message)
        return self.parts[-1]

    def open(self, path, text=None):
        text = path.read_text() if text is None else text
        self.notify("textDocument/didOpen", {"textDocument": {"uri": uri_of(path), "languageId": "glsl",
                                                            "version": 1, "text": text}})

    def change(self, path, text):
        self.first_news = None
        self.versions[path] = self.versions.get(path, 1) + 1
        self.notify("textDocument/didChange", {"textDocument": {"uri": uri_of(path), "version": self.versions[path]},
                                             "contentChanges": [{"text": text}]})

    def at(self, method, path, line, character, **more):
        return self.ask("textDocument/" + method, {"textDocument": {"uri": uri_of(path)},
                                                   "position": {"line": line, "character": character}, **more})

    def findings(self, root):
        """As validate lists them."""
        found = []
        for uri, diagnostics in self.published.items():
            path = urllib.parse.unquote(uri[len("file://"):])
            for one in diagnostics:
                found.append((path.removeprefix(f"{root}/shaders"), one["range"]["start"]["line"],
                              SEVERITIES[one["severity"]], one["code"], one["message"].split("\n")[0]))
        return sorted(found)

    def end(self):
        self.ask("shutdown", None)
        self.notify("exit", None)
        assert self.process.wait(timeout=TIMEOUT) == 0
        self.process.stdin.close()
        self.process.stdout.close()


def validated(orris, root):
    """The findings of `orris validate`, as Client.findings() lists them."""
    process = subprocess.run([str(orris), "validate", str(root), "--json", "--no-cache"], capture_output=True,
                             text=True, timeout=600)
    assert process.returncode in (0, 1), process.stderr
    found = []
    for one in json.loads(process.stdout)["packs"][0]["diagnostics"]:
        file = one["uri"].removeprefix(f"{root}/shaders") or "/shaders.properties"
        if one["severity"] != "note":
            found.append((file, max(one["line"] - 1, 0), one["severity"], one["id"], one["message"].split("\n")[0]))
    return sorted(found)


def write_pack(root, files=FILES):
    for name, text in files.items():
        path = root / "shaders" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


def column(file, line, word):
    """Of a character in the word."""
    return FILES[file].split("\n")[line].index(word) + 1


def findings_come_while_typing(orris, root):
    client, file = Client(orris), root / "shaders" / "lib" / "math.glsl"
    client.open(file)
    client.settle()
    assert client.findings(root) == validated(orris, root)
    before = client.findings(root)
    client.change(file, FILES["lib/math.glsl"].replace("x * 0.5", "x * 0.5 + undeclared"))
    client.settle()
    errors = [one for one in client.published[uri_of(file)] if one["severity"] == 1]
    assert len(errors) == 1 and "undeclared" in errors[0]["message"], errors
    assert errors[0]["range"] == {"start": {"line": 1, "character": 41}, "end": {"line": 1, "character": 51}}, errors
    assert errors[0]["relatedInformation"][0]["location"]["uri"] == uri_of(root / "shaders" / "composite.fsh")
    client.change(file, FILES["lib/math.glsl"])
    client.settle()
    assert client.findings(root) == before
    # What is on the disk counts again once the editor lets go of the file.
    client.change(file, "broken")
    client.settle()
    assert client.findings(root) != before
    client.notify("textDocument/didClose", {"textDocument": {"uri": uri_of(file)}})
    client.settle()
    assert client.findings(root) == before and client.lost == 0
    client.end()


def errors_of_some_programs_come_first(orris, root):
    client, file = Client(orris), root / "shaders" / "lib" / "math.glsl"
    # The file of more programs than are checked first.
    for i in range(12):
        for stage in ("vsh", "fsh"):
            (root / "shaders" / f"composite{i + 1}.{stage}").write_text(FILES[f"composite.{stage}"])
    client.open(file)
    client.settle()
    before = client.findings(root)

    def errors():
        return [one for one in client.published.get(uri_of(file), []) if one["severity"] == 1]

    client.change(file, FILES["lib/math.glsl"].replace("x * 0.5", "x * 0.5 + undeclared"))
    assert client.next_part() == "programs" and len(errors()) == 1, client.published
    assert client.next_part() == "whole" and len(errors()) == 1, client.published
    client.change(file, FILES["lib/math.glsl"])
    assert client.next_part() == "programs" and not errors(), client.published
    assert client.next_part() == "whole" and client.findings(root) == before
    file.write_text(FILES["lib/math.glsl"] + "\n#error halted\n")
    client.change(file, file.read_text())
    client.settle()
    assert client.findings(root) == validated(orris, root)
    client.end()


def helpers(client):
    """Ids of the server's processes, whoever their parent is by now."""
    found = []
    for status in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            state, _, _, session = status.read_text().rpartition(")")[2].split()[:4]
        except OSError:
            continue
        if state != "Z" and int(session) == client.process.pid and int(status.parent.name) != client.process.pid:
            found.append(int(status.parent.name))
    return found


def resting_helper(client):
    """The one process that stays between checks: one that has sent its findings takes a while to end."""
    until = time.monotonic() + TIMEOUT
    while len(found := helpers(client)) != 1:
        assert time.monotonic() < until, found
        time.sleep(0.02)
    return found[0]


def processes_that_are_killed_cost_the_findings_of_one_check(orris, root):
    client, file = Client(orris), root / "shaders" / "final.fsh"
    client.open(file)
    client.settle()
    before = client.findings(root)
    os.kill(resting_helper(client), signal.SIGKILL)
    client.change(file, FILES["final.fsh"] + "nonsense")
    client.settle()
    while client.parts[-1] == "lost":  # it was killed before its death was known
        client.change(file, FILES["final.fsh"] + "nonsense" + " " * len(client.parts))
        client.settle()
    assert client.findings(root) != before
    client.change(file, FILES["final.fsh"])
    client.settle()
    assert client.findings(root) == before
    client.end()


def a_check_that_is_killed_is_reported_lost(orris, root):
    client, shaders = Client(orris), root / "shaders"
    # Enough programs for a check that is met at work.
    for i in range(60):
        for stage in ("vsh", "fsh"):
            (shaders / f"composite{i + 1}.{stage}").write_text(FILES[f"composite.{stage}"])
    file = shaders / "lib" / "math.glsl"
    client.open(file)
    client.settle()
    before = client.findings(root)
    resting = resting_helper(client)
    for attempt in range(20):
        client.change(file, FILES["lib/math.glsl"].replace("0.5", f"0.{attempt}1 + undeclared"))
        at_work, until = [], time.monotonic() + TIMEOUT
        while not at_work and time.monotonic() < until:
            at_work = [one for one in helpers(client) if one != resting]
        os.kill(at_work[0], signal.SIGKILL)
        client.settle()
        if client.parts[-1] == "lost":
            break
        resting = resting_helper(client)  # that check had ended, and rested
    assert client.lost == 1, client.parts
    client.change(file, FILES["lib/math.glsl"])
    client.settle()
    assert client.parts[-1] == "whole" and client.findings(root) == before
    client.end()


def no_process_is_left(orris, root):
    other = root.parent / "other"
    write_pack(other)
    client = Client(orris)
    files = [one / "shaders" / "final.fsh" for one in (root, other)]
    for file in files:
        client.open(file)
        client.settle()
        # Whose first processes have given way to others.
        for text in ("\n", "\n\n"):
            client.change(file, FILES["final.fsh"] + text)
            client.settle()
    client.change(files[0], FILES["final.fsh"])
    client.end()
    until = time.monotonic() + 20
    while helpers(client) and time.monotonic() < until:
        time.sleep(0.02)
    assert not helpers(client)


def names_are_explained(orris, root):
    client, shaders = Client(orris), root / "shaders"
    (root.parent / (root.name + ".txt")).write_text("FOG=2\n")

    def hover(file, line, character):
        answer = client.at("hover", shaders / file, line, character)
        return answer["contents"]["value"] if answer else ""

    client.open(shaders / "composite.fsh")
    fog = hover("composite.fsh", 8, column("composite.fsh", 8, "FOG"))
    assert f"option `FOG` = `2`, default `1` (set in {root}.txt)" in fog and "/lib/settings.glsl:1" in fog, fog
    assert "How thick it is" in fog and "`0` `1` `2`" in fog, fog
    assert "uniform float frameTimeCounter;" in hover("composite.fsh", 5, 18)
    assert "*Uniforms*" in hover("composite.fsh", 5, 18)
    halved = hover("composite.fsh", 8, column("composite.fsh", 8, "halved"))
    assert "float halved(float x)" in halved and "/lib/math.glsl:2" in halved, halved
    assert "#define PI 3.14159" in hover("composite.fsh", 8, column("composite.fsh", 8, "PI"))
    assert hover("composite.fsh", 5, column("composite.fsh", 5, "float")) == ""
    assert "blend" in hover("shaders.properties", 3, 2)
    assert "minecraft:oak_log" in hover("block.properties", 0, 24)
    assert "option `FOG`" in hover("lang/en_us.lang", 0, 8)
    assert hover("composite.fsh", 7, 12) == "" and hover("composite.fsh", 999, 0) == ""
    client.end()


def definitions_are_found_across_files(orris, root):
    client, shaders = Client(orris), root / "shaders"
    client.open(shaders / "composite.fsh")

    def places(file, line, character):
        found = client.at("definition", shaders / file, line, character)
        return [(one["uri"].split("/shaders/")[1], one["range"]["start"]["line"], one["range"]["start"]["character"])
                for one in found]

    assert places("composite.fsh", 2, 15) == [("lib/math.glsl", 0, 0)]
    assert places("composite.fsh", 8, column("composite.fsh", 8, "halved")) == [("lib/math.glsl", 1, 6)]
    assert places("composite.fsh", 8, column("composite.fsh", 8, "FOG")) == [("lib/settings.glsl", 0, 8)]
    assert places("shaders.properties", 0, 8) == [("lib/settings.glsl", 0, 8)]
    assert places("lang/en_us.lang", 0, 8) == [("lib/settings.glsl", 0, 8)]
    assert places("composite.fsh", 7, 3) == []
    # A definition that nobody has saved.
    client.open(shaders / "lib" / "math.glsl", "\n\nfloat halved(float x) { return x; }\n#define PI 3\n")
    assert places("composite.fsh", 8, column("composite.fsh", 8, "halved")) == [("lib/math.glsl", 2, 6)]
    symbols = client.ask("textDocument/documentSymbol", {"textDocument": {"uri": uri_of(shaders / "lib/math.glsl")}})
    found = [(one["name"], one["kind"], one["range"]["start"], one["range"]["end"]) for one in symbols]
    assert sorted(found, key=lambda one: one[0]) == [
        ("PI", 14, {"line": 3, "character": 8}, {"line": 3, "character": 10}),
        ("halved", 12, {"line": 2, "character": 6}, {"line": 2, "character": 12})], symbols
    symbols = client.ask("textDocument/documentSymbol", {"textDocument": {"uri": uri_of(shaders / "shaders.properties")}})
    assert [(one["name"], one["range"]["start"]["line"]) for one in symbols] == [
        ("screen", 0), ("sliders", 1), ("profile.LOW", 2), ("blend.composite", 3)], symbols
    client.end()


def names_are_completed(orris, root):
    client, shaders = Client(orris), root / "shaders"

    def labels(file, text):
        """At the "|" of the text."""
        path = shaders / file
        client.open(path, text.replace("|", ""))
        line = text[:text.index("|")].count("\n")
        character = len(text[:text.index("|")].split("\n")[-1])
        return [one["label"] for one in client.at("completion", path, line, character)["items"]]

    assert "sunPosition" in labels("final.fsh", "#version 330\nuniform vec3 sunP|\n")
    names = labels("final.fsh", "#version 330\n#include \"/lib/math.glsl\"\nvoid main() { x = hal|; }\n")
    assert "halved" in names, names
    assert "FOG" in labels("final.fsh", "#version 330\nvoid main() { x = FO|; }\n")
    assert "colortex0" in labels("final.fsh", "uniform sampler2D colort|")
    assert "mc_Entity" in labels("final.vsh", "in vec4 mc_|")
    assert "/lib/math.glsl" in labels("final.fsh", "#include \"|")
    assert "ifdef" in labels("final.fsh", "#if|")
    assert "RENDERTARGETS: " in labels("final.fsh", "/* REN|")
    assert "shadowMapResolution" in labels("final.fsh", "const int shadowM|")
    assert "smoothstep" in labels("final.fsh", "void main() { smooths|")
    assert "separateAo" in labels("shaders.properties", "sepa|")
    assert "blend.gbuffers_water" in labels("shaders.properties", "blend.gb|")
    screen = labels("shaders.properties", "screen=|")
    assert "FOG" in screen and "<profile>" in screen, screen
    assert "stone" in labels("block.properties", "block.1=sto|")
    assert "minecraft:stone" in labels("block.properties", "block.1=minecraft:sto|")
    assert "value.FOG.2" in labels("lang/en_us.lang", "value.F|") and \
        "profile.LOW" in labels("lang/en_us.lang", "prof|")
    client.end()


def edited(text, edit):
    lines = text.split("\n")
    start, end = edit["range"]["start"], edit["range"]["end"]
    before = "\n".join(lines[:start["line"]] + [lines[start["line"]][:start["character"]]])
    after = "\n".join([lines[end["line"]][end["character"]:]] + lines[end["line"] + 1:])
    return before + edit["newText"] + after


def hints_are_edits(orris, root):
    client, file = Client(orris), root / "shaders" / "composite.fsh"
    good = FILES["composite.fsh"]
    client.open(file)
    client.settle()
    for bad, title in ((good.replace("* PI + frame", "* PI + fram"), "write frameTimeCounter"),
                       (good.replace("uniform float frameTimeCounter;\n", ""), "declare: "),
                       (good.replace("#include \"/lib/math.glsl\"\n", ""), "insert #include \"/lib/math.glsl\"")):
        client.change(file, bad)
        client.settle()
        actions = client.ask("textDocument/codeAction", {
            "textDocument": {"uri": uri_of(file)}, "context": {"diagnostics": []},
            "range": {"start": {"line": 0, "character": 0}, "end": {"line": 99, "character": 0}}})
        action = next((one for one in actions if one["title"].startswith(title)), None)
        assert action, (title, [one["title"] for one in actions], client.published[uri_of(file)])
        (target, edits), = action["edit"]["changes"].items()
        assert target == uri_of(file) and len(edits) == 1, action
        client.change(file, edited(bad, edits[0]))
        client.settle()
        assert not [one for one in client.published.get(uri_of(file), []) if one["severity"] == 1], title
    client.change(file, good.replace("halved(float(FOG))", "halfed(float(FOG))"))
    client.settle()
    ignore = [one for one in client.ask("textDocument/codeAction", {
        "textDocument": {"uri": uri_of(file)}, "context": {"diagnostics": []},
        "range": {"start": {"line": 8, "character": 0}, "end": {"line": 8, "character": 9}}})
        if one["title"].startswith("ignore ")]
    assert ignore and ignore[0]["edit"]["changes"][uri_of(file)][0]["newText"].startswith("  // orris: ignore("), ignore
    client.end()


def columns_are_counted_as_the_editor_does(orris, root):
    text = "#version 330 compatibility\n/* \U0001F319\u00e4 */ uniform float frameTimeCounter; float x = nothing;\nvoid main() {}\n"
    file = root / "shaders" / "final.fsh"
    for encodings, moon in ((("utf-16",), 2), (("utf-16", "utf-8"), 4)):
        client = Client(orris, encodings)
        assert client.capabilities["positionEncoding"] == encodings[-1]
        client.open(file, text)
        client.settle()
        error = next(one for one in client.published[uri_of(file)] if one["severity"] == 1)
        begin = len("/* ") + moon + (1 if moon == 2 else 2) + len(" */ uniform float frameTimeCounter; float x = ")
        assert error["range"]["start"]["character"] == begin, (error, begin)
        assert "frameTimeCounter" in client.at("hover", file, 1, begin - 20)["contents"]["value"]
        client.end()


def nonsense_ends_nothing(orris, root):
    client = Client(orris)
    assert client.request("textDocument/nothing", {})["error"]["code"] == -32601
    assert client.request("textDocument/hover", {"textDocument": 5})["error"]["code"] == -32602
    assert client.request("textDocument/hover", {})["error"]["code"] == -32602
    client.process.stdin.write(b"Content-Length: 7\r\n\r\nnothing")
    assert client.at("hover", pathlib.Path("/nowhere/a.fsh"), 0, 0) is None
    client.open(pathlib.Path("/nowhere/a.fsh"), "text")
    client.open(root / "shaders" / "final.fsh", "\0\xff\n\t#include \"\n/*")
    client.settle()
    assert client.lost == 0
    assert client.at("completion", root / "shaders" / "final.fsh", 1, 500)["items"] is not None
    client.end()
    process = subprocess.run([str(orris), "lsp"], input=b"Content-Length: x\r\n\r\n", capture_output=True, timeout=TIMEOUT)
    assert process.returncode == 1 and process.stdout == b"", process
    assert subprocess.run([str(orris), "lsp"], input=b"", capture_output=True, timeout=TIMEOUT).returncode == 1


def random_edit(text, dice):
    """As a person's slip: a character, a word or a line goes, comes or changes."""
    if not text:
        return "x"
    at = dice.randrange(len(text))
    lines = text.split("\n")
    row = dice.randrange(len(lines))
    kind = dice.randrange(6)
    if kind == 0:
        return text[:at] + text[at + 1:]
    if kind == 1:
        return text[:at] + dice.choice("(){};,.+-*/#\"x0 \n") + text[at:]
    if kind == 2:
        return "\n".join(lines[:row] + lines[row + 1:])
    if kind == 3:
        return "\n".join(lines[:row] + [lines[row]] + lines[row:])
    if kind == 4:
        return text[:at] + dice.choice(["float", "undeclared", "#endif\n", "/*", "*/", "return", "1.0"]) + text[at:]
    return "\n".join(lines[:row] + lines[row + 1:row + 2] + lines[row:row + 1] + lines[row + 2:])


def random_session(orris, root, edits, seed, say=lambda *_: None):
    """Times in seconds from an edit to the first news and to the end of its check."""
    dice = random.Random(seed)
    files = sorted(path for path in (root / "shaders").rglob("*")
                   if path.suffix in (".fsh", ".vsh", ".glsl", ".csh", ".gsh", ".inc", ".properties", ".lang")
                   and path.stat().st_size < 1 << 20)
    client, undo, texts, news, whole = Client(orris), [], {}, [], []
    client.open(files[0])
    client.settle()
    texts[files[0]] = files[0].read_text(errors="replace")
    for number in range(edits):
        began = time.monotonic()
        if undo and dice.random() < 0.5:
            path, text = undo.pop()
        else:
            path = dice.choice(files)
            if path not in texts:
                texts[path] = path.read_text(errors="replace")
                client.open(path, texts[path])
                client.settle()
            undo.append((path, texts[path]))
            text = random_edit(texts[path], dice)
        began = time.monotonic()
        same, texts[path] = texts[path] == text, text
        client.change(path, text)
        if same:
            continue
        client.settle()
        whole.append(time.monotonic() - began)
        news.append(client.first_news - began)
        say(number, path.name, f"{news[-1]:.3f} {whole[-1]:.3f}")
    for path, text in texts.items():
        path.write_text(text)
    end = client.findings(root)
    lost = client.lost
    client.end()
    return news, whole, end, lost


def random_edits_end_with_the_findings_of_validate(orris, root):
    _, _, end, lost = random_session(orris, root, 40, 7)
    assert lost == 0
    expected = validated(orris, root)
    assert end == expected, (set(end) ^ set(expected))


def a_thousand_edits_and_undos_end_with_the_findings_of_validate(orris, root):
    """The heavy label's: also how long news take, though of a small pack."""
    news, whole, end, lost = random_session(orris, root, 1000, 11)
    print(f"{len(whole)} edits, news: median {statistics.median(news):.3f} s, checked: median"
          f" {statistics.median(whole):.3f} s, {lost} checks lost, {len(end)} findings")
    assert lost == 0
    expected = validated(orris, root)
    assert end == expected, (set(end) ^ set(expected))


HEAVY = [a_thousand_edits_and_undos_end_with_the_findings_of_validate]
CASES = [findings_come_while_typing, errors_of_some_programs_come_first,
         processes_that_are_killed_cost_the_findings_of_one_check, a_check_that_is_killed_is_reported_lost, no_process_is_left,
         names_are_explained, definitions_are_found_across_files, names_are_completed,
         hints_are_edits, columns_are_counted_as_the_editor_does, nonsense_ends_nothing,
         random_edits_end_with_the_findings_of_validate]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("orris")
    parser.add_argument("--pack")
    parser.add_argument("--edits", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--case", default="")
    parser.add_argument("--heavy", action="store_true", help="the long case alone")
    arguments = parser.parse_args()
    orris = pathlib.Path(arguments.orris).resolve()
    if arguments.pack:
        with tempfile.TemporaryDirectory() as name:
            root = pathlib.Path(name).resolve() / "pack"
            shutil.copytree(arguments.pack, root)
            news, whole, end, lost = random_session(orris, root, arguments.edits, arguments.seed, print)
            expected = validated(orris, root)
            print(f"news: median {statistics.median(news):.3f} s, checked: median {statistics.median(whole):.3f} s, "
                  f"{len(whole)} edits, {lost} checks lost, {len(end)} findings, "
                  f"{'as' if end == expected else 'not as'} validate")
            for one in sorted(set(end) ^ set(expected))[:10]:
                print("only here" if one in end else "only validate", one)
        return 0
    for case in HEAVY if arguments.heavy else CASES:
        if arguments.case in case.__name__:
            with tempfile.TemporaryDirectory() as name:
                root = pathlib.Path(name).resolve() / "pack"
                write_pack(root)
                case(orris, root)
    return 0


if __name__ == "__main__":
    sys.exit(main())
