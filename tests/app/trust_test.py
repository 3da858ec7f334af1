#!/usr/bin/env python3
"""trust_test.py PROGRAM SOURCE_DIR: a folder that a stranger filled. Nothing outside of it is read, quoted or
written, nothing in it speaks for the program, and what it turns off is said."""
import os
import re
import stat
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from cases import FINAL, FINAL_VERTEX, PACK, VERSION

PROGRAM, SOURCE = (str(Path(word).resolve()) for word in sys.argv[1:3])
SECRET = "TOKEN=hunter2"
CORNELL = f"{SOURCE}/worlds/cornell"


class Checkout(unittest.TestCase):
    """`checkout` is the stranger's folder, `secret` lies beside it."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.path = Path(temporary.name) / "checkout"
        self.secret = Path(temporary.name) / "secret"
        self.secret.mkdir()
        (self.secret / "file").write_text(SECRET + "\n")
        self.write(PACK)

    def write(self, files):
        for name, text in files.items():
            file = self.path / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)

    def orris(self, *words, status, timeout=60):
        result = subprocess.run([PROGRAM, *words], cwd=self.path, capture_output=True, timeout=timeout,
                                text=True, errors="replace", env={**os.environ, "TOKEN": "hunter2"})
        self.assertEqual(result.returncode, status, result.stdout + result.stderr)
        self.assertNotIn("hunter2", result.stdout + result.stderr)
        return result

    def files(self):
        return sorted(str(path.relative_to(self.path.parent)) for path in self.path.parent.rglob("*"))


class FolderConfig(Checkout):
    def config(self, line):
        self.write({"orris.toml": f"[validate]\n{line}\n"})

    def test_names_no_file(self):
        for key, value in (("settings", '"/proc/self/environ"'), ("output", '"../victim"'),
                           ("report", '["json=../victim"]'), ("write-baseline", '"../victim"'),
                           ("baseline", '"../secret/file"'), ("patched", '"../victim"'),
                           ("explain-log", '"../secret/file"'), ("o", '"../victim"'),
                           ("pack", '"../secret"'), ("config", '"x"'), ("jobs", "200")):
            with self.subTest(key=key):
                self.config(f"strict = true\n{key} = {value}")
                before = self.files()
                errors = self.orris("validate", "pack", status=2).stderr
                self.assertIn(f'orris.toml:3:1: error: "{key}" is not taken', errors)
                self.assertIn("--config orris.toml", errors)
                self.assertEqual(self.files(), before)

    def test_of_the_command_line_may_name_files(self):
        self.config('output = "out.txt"')
        self.orris("validate", "pack", "--config", "orris.toml", status=0)
        self.assertTrue((self.path / "out.txt").exists())

    def test_of_the_command_line_ends(self):
        (self.path / "zero.toml").symlink_to("/dev/zero")
        os.mkfifo(self.path / "pipe.toml")
        for word in (["--config", "zero.toml"], ["--config=pipe.toml"]):
            self.assertRegex(self.orris("validate", "pack", *word, status=2, timeout=20).stderr,
                             r"^(zero|pipe)\.toml: error: is a folder, device or pipe")

    def test_may_be_left_out(self):
        self.config('output = "out.txt"')
        self.orris("validate", "pack", "--no-config", status=0)
        self.assertFalse((self.path / "out.txt").exists())

    def test_what_it_silences_is_said(self):
        self.write({"pack/shaders/composite.fsh": VERSION + "void main() { broken }\n",
                    "pack/shaders/shaders.properties": "screen = NOPE\n"})
        self.config('ignore = ["glsl-compile"]\nseverity = ["screen-option=note"]')
        for words in ([], ["--quiet"], ["--format", "github"], ["--json"]):
            self.assertIn("orris.toml: turned off or lowered: 1 glsl-compile, 1 screen-option\n",
                          self.orris("validate", "pack", *words, status=0).stderr)
        self.assertNotIn("orris.toml", self.orris("validate", "pack", "--no-config", status=1).stderr)

    def test_that_silences_nothing_is_not_mentioned(self):
        self.config('ignore = ["glsl-compile"]\nprofiles = ["all"]')
        self.assertEqual(self.orris("validate", "pack", status=0).stderr, "")

    def test_is_a_bounded_file_of_the_folder(self):
        config = self.path / "orris.toml"
        for make in (lambda: os.mkfifo(config), lambda: config.symlink_to("/dev/zero"),
                     lambda: config.symlink_to("/proc/self/environ"), config.mkdir,
                     lambda: config.symlink_to("../secret/file"), lambda: config.symlink_to("nowhere"),
                     lambda: config.write_text("#" * 70000)):
            make()
            errors = self.orris("validate", "pack", status=2, timeout=20).stderr
            self.assertRegex(errors, r"^orris\.toml: error: is ")
            config.rmdir() if config.is_dir() and not config.is_symlink() else config.unlink()


class Links(Checkout):
    def test_a_world_is_not_read_through_one(self):
        (self.path / "world").mkdir()
        for target in ("/proc/self/environ", "../../secret/file"):
            (self.path / "world/world.json").symlink_to(target)
            errors = self.orris("world", "world", status=2).stderr
            self.assertIn("world/world.json: error: this world is a symbolic link that leads out", errors)
            (self.path / "world/world.json").unlink()

    def test_shaders_is_not_read_through_one(self):
        (self.secret / "shaders").mkdir()
        (self.secret / "shaders/final.fsh").write_text(SECRET)
        (self.secret / "shaders/final.vsh").write_text(FINAL_VERTEX)
        (self.path / "other").mkdir()
        (self.path / "other/shaders").symlink_to("../../secret/shaders")
        errors = self.orris("validate", "other", status=2).stderr
        self.assertIn("other/shaders: error: this symbolic link leads out of the pack", errors)
        (self.path / "linked").symlink_to("pack")
        self.orris("validate", "linked", status=0)

    def test_what_is_named_is_not_read_through_one(self):
        for words in (["validate", "pack", "--settings", "f"], ["validate", "pack", "--baseline", "f"],
                      ["validate", "pack", "--explain-log", "f"], ["gallery", "pack", "--set-file", "f", "-o", "o.html"],
                      ["world", "f.json"]):
            with self.subTest(words=words):
                link = self.path / (words[-1] if words[0] == "world" else "f")
                link.symlink_to("../secret/file")
                self.assertIn("is a symbolic link that leads out of its folder", self.orris(*words, status=2).stderr)
                link.unlink()

    def test_nothing_hidden_is_read(self):
        token = f"{SECRET}\n"
        self.write({".git/config": token, "world/world.json": "", "shaders/.git/config": token,
                    "shaders/final.vsh": FINAL_VERTEX,
                    "shaders/final.fsh": VERSION + '#include "/.git/config"\n#include "/lib.glsl"\nvoid main() {}\n'})
        (self.path / "shaders/lib.glsl").symlink_to(".git/config")
        self.orris("validate", "shaders", status=1)
        (self.path / "world/world.json").unlink()
        (self.path / "world/world.json").symlink_to("../.git/config")
        self.orris("world", "world", status=2)
        self.orris("world", ".", status=2)

    def test_pipes_and_devices_are_no_files(self):
        os.mkfifo(self.path / "pipe")
        os.mkfifo(self.path / "pipe.zip")
        os.mkfifo(self.path / "pipe.schem")
        self.orris("validate", "pipe.zip", status=2, timeout=20)
        self.orris("world", "pipe.schem", status=2, timeout=20)
        self.assertIn("pipe: error: is a folder, device or pipe",
                      self.orris("validate", "pack", "--settings", "pipe", status=2, timeout=20).stderr)
        self.assertIn("/dev/zero: error: is too large",
                      self.orris("validate", "pack", "--settings", "/dev/zero", status=2).stderr)


class Outputs(Checkout):
    def test_are_not_written_through_links(self):
        victim = self.secret / "file"
        for words in (["validate", "pack", "--report", "sarif=out"],
                      ["validate", "pack", "--write-baseline", "out"],
                      ["options", "pack", "--graph", "out.md"]):
            link = self.path / words[-1].split("=")[-1]
            link.symlink_to("../secret/file")
            self.assertIn("is a symbolic link; outputs are not written through links",
                          self.orris(*words, status=2).stderr)
            self.assertEqual(victim.read_text(), SECRET + "\n")
            self.assertTrue(link.is_symlink())
            link.unlink()

    def test_are_not_written_through_folders_that_are_links(self):
        (self.path / "out").symlink_to("../secret")
        before = sorted(self.secret.iterdir())
        for words in (["validate", "pack", "--report", "sarif=out/file"],
                      ["validate", "pack", "--write-baseline", "out/file"],
                      ["validate", "pack", "--report", "sarif=out/../new"],
                      ["options", "pack", "--graph", str(self.path / "out/new.md")]):
            self.assertIn("lies behind the symbolic link out; outputs are not written through links",
                          self.orris(*words, status=2).stderr)
        self.assertEqual(sorted(self.secret.iterdir()), before)
        self.assertEqual((self.secret / "file").read_text(), SECRET + "\n")

    def test_are_written_where_the_folder_itself_is_named(self):
        (self.path / "out").mkdir()
        for name in ("out/report", "./out/../out/report", str(self.path / "out/report")):
            self.orris("validate", "pack", "--report", "sarif=" + name, status=0)
            (self.path / "out/report").unlink()

    def test_names_of_temporary_files_cannot_be_taken(self):
        (self.path / "out.part").symlink_to("../secret/file")
        # The number of the process could be foreseen in a container: its program and its shell.
        script = 'ln -s ../secret/file out.partial-$$; exec "$0" "$@"'
        subprocess.run(["sh", "-c", script, PROGRAM, "validate", "pack", "--report", "sarif=out"],
                       cwd=self.path, check=True, capture_output=True, timeout=60)
        self.assertEqual((self.secret / "file").read_text(), SECRET + "\n")
        self.assertTrue((self.path / "out").read_text().startswith("{"))

    def test_replace_no_device_or_pipe(self):
        os.mkfifo(self.path / "out")
        self.assertIn("out: error: is a device or pipe",
                      self.orris("validate", "pack", "--report", "json=out", status=2, timeout=20).stderr)
        self.assertTrue(stat.S_ISFIFO((self.path / "out").stat().st_mode))

    def test_over_the_limit_of_the_system_are_a_message(self):
        (self.path / "out").write_text("old")
        result = subprocess.run(["sh", "-c", 'ulimit -f 1; exec "$0" "$@"', PROGRAM, "validate", "pack",
                                 "--report", "sarif=out"],
                                cwd=self.path, capture_output=True, text=True, timeout=60)
        self.assertEqual((result.returncode, (self.path / "out").read_text()), (2, "old"), result.stderr)
        self.assertIn("out: error: cannot be written", result.stderr)
        self.assertEqual([path.name for path in self.path.iterdir() if "partial" in path.name], [])

    def test_standard_output_is_one(self):
        self.assertIn('"packs"', self.orris("validate", "pack", "--report", "json=/dev/stdout",
                                            status=0).stdout)
        self.assertTrue(Path("/dev/stdout").is_symlink())

    def test_sources_do_not_leave_their_folder(self):
        self.write({"pack/shaders/world0/final.fsh": FINAL, "pack/shaders/world0/final.vsh": FINAL_VERTEX})
        (self.path / "sources").mkdir()
        (self.path / "sources/world0").symlink_to("../../secret")
        errors = self.orris("validate", "pack", "--patched", "sources", status=2).stderr
        self.assertIn("sources/world0: error: leads out of the folder", errors)
        self.assertEqual([path.name for path in self.secret.iterdir()], ["file"])


class Logs(Checkout):
    HOSTILE = ["::stop-commands::x", "  ::error::y", "##[error]z", "a ##vso[task.setvariable variable=a]b",
               "##teamcity[x]", "\x1b[2J\x1b]0;t\x07", "\x9b2J", "a\rb"]

    def check(self, text):
        for line in text.splitlines():
            self.assertNotRegex(line, r"^\s*::(?!(error|warning|notice) (file|title)=)")
            self.assertNotRegex(line, r"##\w*\[")
        self.assertNotRegex(text, "[\x00-\x08\x0b-\x1f\x7f-\x9f]")

    def test_no_line_of_a_pack_is_a_command(self):
        lines = "\n".join(f"float a{i} = undeclared{i};\n{line}"
                          for i, line in enumerate(self.HOSTILE))
        self.write({"pack/shaders/final.fsh": VERSION + lines + "\nvoid main() {}\n",
                    "pack/shaders/shaders.properties": "\n".join(self.HOSTILE) + "\nscreen=##[a]\n",
                    "pack/shaders/lib/x\n::error::name\x1b[31m##[group].glsl": "",
                    "pack/shaders/composite.fsh": VERSION + '#include "/lib/\x1b[31m##[x].glsl"\n'})
        for words in ([], ["--format", "github"], ["--verbose", "--json"], ["--format", "sarif"],
                      ["--format", "junit"]):
            with self.subTest(words=words):
                result = self.orris("validate", "pack", *words, status=1)
                self.check(result.stderr)
                self.check(result.stdout)
                self.assertIn("undeclared0" if "--format" not in words else "", result.stderr)

    def test_no_name_of_a_world_is_a_command(self):
        self.write({"world/world.json": '{"name": "a\\n::error::b\\u001b[2J", "exercises": "##[group]c", '
                                        '"generate": {"kind": "\\n::d::"}}'})
        for words in ([], ["--json"]):
            result = subprocess.run([PROGRAM, "world", "world", *words], cwd=self.path, text=True,
                                    capture_output=True, timeout=60)
            self.assertIn(result.returncode, (0, 1, 2))
            self.check(result.stdout + result.stderr)

    def test_no_option_is_a_command(self):
        self.write({"pack/shaders/lang/en_us.lang": "option.MODE=a\\n::error::b\n",
                    "pack/shaders/final.fsh": FINAL.replace(
                        "void", "#define MODE 1 // [0 1 ::x] ##[group]\n#if MODE == 1\n#endif\nvoid")})
        for words in ([], ["--json"], ["--graph", "-"]):
            self.check(self.orris("options", "pack", *words, status=0).stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], warnings="ignore")
