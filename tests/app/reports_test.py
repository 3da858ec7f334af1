#!/usr/bin/env python3
"""reports_test.py PROGRAM SOURCE_DIR: validates a pack with planted problems and reads every report
format back, each with a reader or schema that is not ours.

The environment may name the official SARIF schema in SARIF_SCHEMA; without it the classes of
python3-sarif-python-om, which are generated from that schema, say what a member may be called.
"""
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
import zipfile
from pathlib import Path

import jsonschema

try:
    import sarif_om
except ImportError:
    sarif_om = None

PROGRAM, SOURCE = (str(Path(word).resolve()) for word in sys.argv[1:3])
VERSION = "#version 330 compatibility\n"
VERTEX = VERSION + "void main() { gl_Position = ftransform(); }\n"
FRAGMENT = VERSION + '#include "/lib/my file.glsl"\nvoid main() { gl_FragColor = vec4(f()); }\n'
LIBRARY = "float f() {\n  /* é */ return undeclared < 1.0 && \"a\";\n}\n"
PROPERTIES = """screen = UNKNOWN_A
# orris: ignore(screen-option) is made by a script
screen.X = UNKNOWN_B
# orris: ignore(screen-option)
screen.Y = <empty>
# orris: ignore(screen-optoin)
screen.Z = <empty>
alphaTest.gbuffers_water = WRONG 0.1
"""
PACK = {"shaders/final.vsh": VERTEX, "shaders/final.fsh": FRAGMENT,
        "shaders/world-1/composite.vsh": VERTEX, "shaders/world-1/composite.fsh": FRAGMENT.replace("f()", "2.0 * f()"),
        "shaders/world-1/final.fsh": VERSION + "void main() { gl_FragColor = vec4(1.0); }\n",
        "shaders/lib/my file.glsl": LIBRARY, "shaders/shaders.properties": PROPERTIES}
FORMATS = {"json": "r.json", "sarif": "r.sarif", "junit": "r.xml", "github": "r.txt",
           "text": "r.text"}


class Folder:
    """A pack in a folder of its own."""

    def __init__(self, files=None):
        self.temporary = tempfile.TemporaryDirectory()
        self.path = Path(self.temporary.name)
        for name, text in {**PACK, **(files or {})}.items():
            file = self.path / "pack" / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)

    def validate(self, *words, status=1, pack="pack"):
        result = subprocess.run([PROGRAM, "validate", pack, *words], cwd=self.path, text=True,
                                capture_output=True, timeout=100)
        assert result.returncode == status, (result.returncode, result.stdout, result.stderr)
        return result

    def report(self, format, *words, **more):
        self.validate("--report", f"{format}={FORMATS[format]}", *words, **more)
        text = (self.path / FORMATS[format]).read_text()
        return json.loads(text) if format in ("json", "sarif") else text


def problems_of(pack):
    return [(entry["file"], entry["line"], entry["id"]) for entry in pack["diagnostics"]
            if entry["severity"] != "note"]


class Json(unittest.TestCase):
    def test_follows_its_schema(self):
        schema = json.loads(Path(SOURCE, "docs/schema/validate.schema.json").read_text())
        jsonschema.Draft7Validator.check_schema(schema)
        folder = Folder()
        folder.validate("--write-baseline", "known")
        for words in ([], ["--verbose"], ["--profiles", "NONE"], ["--baseline", "known"]):
            status = 0 if "known" in words else 2 if "NONE" in words else 1
            jsonschema.validate(folder.report("json", *words, status=status), schema)

    def test_lists_problems_in_file_order(self):
        report = Folder().report("json")
        self.assertEqual(problems_of(report["packs"][0]), [
            ("/lib/my file.glsl", 2, "glsl-compile"),
            ("/shaders.properties", 1, "screen-option"),
            ("/shaders.properties", 6, "ignore-unknown"),
            ("/shaders.properties", 8, "alpha-test")])
        self.assertEqual([(entry["line"], entry["silencedBy"])
                          for entry in report["packs"][0]["silenced"]], [(3, "comment")])

    def test_names_every_program_of_a_problem(self):
        entries = Folder().report("json")["packs"][0]["diagnostics"]
        entry = next(entry for entry in entries if entry["id"] == "glsl-compile")
        self.assertEqual(entry["programs"], ["/final", "/world-1/composite"])
        self.assertEqual(entry["uri"], "pack/shaders/lib/my file.glsl")


class Sarif(unittest.TestCase):
    def test_follows_the_official_schema(self):
        path = os.environ.get("SARIF_SCHEMA", "")
        if not Path(path).is_file():
            self.skipTest("SARIF_SCHEMA names no file: sarif-schema-2.1.0.json of OASIS")
        schema = json.loads(Path(path).read_text())
        for words in ([], ["--verbose"], ["--ignore", "alpha-test"]):
            jsonschema.validate(Folder().report("sarif", *words), schema)

    def test_uses_members_that_the_format_knows(self):
        if sarif_om is None:
            self.skipTest("python3-sarif-python-om is not installed")
        self.assertEqual(unknown_members(Folder().report("sarif", "--verbose"), "SarifLog"), [])

    def test_places_are_relative_and_in_characters(self):
        results = Folder().report("sarif")["runs"][0]["results"]
        place = results[0]["locations"][0]["physicalLocation"]
        self.assertEqual(place["artifactLocation"],
                         {"uri": "pack/shaders/lib/my%20file.glsl", "uriBaseId": "SRCROOT"})
        self.assertEqual(place["region"]["startLine"], 2)
        line = LIBRARY.splitlines()[1]
        self.assertEqual(place["region"]["startColumn"], line.index("undeclared") + 1)
        self.assertEqual(place["region"]["snippet"]["text"], line)
        related = results[0]["relatedLocations"]
        self.assertEqual([(entry["physicalLocation"]["artifactLocation"]["uri"],
                           entry["physicalLocation"]["region"]["startLine"]) for entry in related],
                         [("pack/shaders/final.fsh", 2)])

    def test_every_result_points_at_its_rule(self):
        run = Folder().report("sarif", "--verbose")["runs"][0]
        rules = run["tool"]["driver"]["rules"]
        for result in run["results"]:
            self.assertEqual(rules[result["ruleIndex"]]["id"], result["ruleId"])
            self.assertTrue(result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"])
        home = run["tool"]["driver"].get("informationUri")
        for rule in rules:
            page = f"docs/checks.md#{rule['id']}"
            self.assertTrue(rule["help"]["text"].endswith(page))
            self.assertEqual(rule.get("helpUri"), home and f"{home}/blob/main/{page}")

    def test_keeps_what_is_silenced_as_suppressions(self):
        folder = Folder()
        kinds = lambda *words, **more: sorted(
            (result["ruleId"], entry["kind"])
            for result in folder.report("sarif", *words, **more)["runs"][0]["results"]
            for entry in result["suppressions"])
        commented = ("screen-option", "inSource")
        self.assertEqual(kinds(), [commented])
        self.assertEqual(kinds("--ignore", "alpha-test"), [("alpha-test", "external"), commented])
        folder.validate("--write-baseline", "known")
        self.assertEqual(len(kinds("--baseline", "known", status=0)), 5)

    def test_fingerprints_stay_when_lines_move(self):
        prints = lambda files: sorted(
            result["partialFingerprints"]["orris/v1"]
            for result in Folder(files).report("sarif")["runs"][0]["results"])
        moved = {"shaders/lib/my file.glsl": "\n\n" + LIBRARY,
                 "shaders/shaders.properties": "\n" + PROPERTIES}
        changed = {"shaders/lib/my file.glsl": LIBRARY.replace("1.0", "2.0")}
        self.assertEqual(prints({}), prints(moved))
        self.assertNotEqual(prints({}), prints(changed))
        self.assertEqual(len(set(prints({}))), 5)

    def test_source_root_replaces_where_the_pack_is(self):
        folder = Folder()
        with zipfile.ZipFile(folder.path / "pack.zip", "w") as archive:
            for name, text in PACK.items():
                archive.writestr("MyPack/" + name, text)
        for words, root in (([], "shaders"), (["--source-root", "src/shaders"], "src/shaders")):
            run = folder.report("sarif", *words, pack="pack.zip")["runs"][0]
            self.assertEqual({result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"]
                              for result in run["results"]},
                             {f"{root}/lib/my%20file.glsl", f"{root}/shaders.properties"})


    def test_absolute_paths_are_relative_where_they_can_be(self):
        folder, other = Folder(), Folder()
        artifacts = lambda pack: {
            json.dumps(result["locations"][0]["physicalLocation"]["artifactLocation"])
            for result in folder.report("sarif", pack=str(pack))["runs"][0]["results"]}
        self.assertIn('{"uri": "pack/shaders/shaders.properties", "uriBaseId": "SRCROOT"}',
                      artifacts(folder.path.resolve() / "pack"))
        self.assertIn(json.dumps({"uri": f"file://{other.path}/pack/shaders/shaders.properties"}),
                      artifacts(other.path / "pack"))


# Which class each member of the format holds; all others hold plain values.
SARIF_CLASSES = {"runs": "Run", "tool": "Tool", "driver": "ToolComponent",
                 "rules": "ReportingDescriptor", "results": "Result", "message": "Message",
                 "locations": "Location", "relatedLocations": "Location",
                 "physicalLocation": "PhysicalLocation", "region": "Region",
                 "artifactLocation": "ArtifactLocation", "suppressions": "Suppression",
                 "shortDescription": "MultiformatMessageString", "help": "MultiformatMessageString",
                 "snippet": "ArtifactContent", "description": "Message",
                 "defaultConfiguration": "ReportingConfiguration"}
SARIF_MAPS = {"originalUriBaseIds": "ArtifactLocation"}


def unknown_members(value, name):
    """Members that the class does not have, and required ones that are missing."""
    fields = {field.metadata["schema_property_name"]: field
              for field in getattr(sarif_om, name).__attrs_attrs__}
    problems = [f"{name}.{member} is unknown" for member in value if member not in fields]
    required = [member for member, field in fields.items()
                if field.default is not None and repr(field.default) == "NOTHING"]
    problems += [f"{name}.{member} is missing" for member in required if member not in value]
    for member, inner in value.items():
        if member in SARIF_CLASSES:
            for entry in inner if isinstance(inner, list) else [inner]:
                problems += unknown_members(entry, SARIF_CLASSES[member])
        elif member in SARIF_MAPS:
            for entry in inner.values():
                problems += unknown_members(entry, SARIF_MAPS[member])
    return problems


class Junit(unittest.TestCase):
    def test_has_a_suite_for_each_folder_and_a_case_for_each_program(self):
        root = ElementTree.fromstring(Folder().report("junit"))
        self.assertEqual(root.tag, "testsuites")
        self.assertEqual({suite.get("name"): [case.get("name") for case in suite]
                          for suite in root},
                         {"pack": ["pack"], "pack /": ["/final"],
                          "pack /world-1": ["/world-1/composite", "/world-1/final"]})

    def test_failures_hold_the_messages(self):
        root = ElementTree.fromstring(Folder().report("junit"))
        failures = {case.get("name"): [(failure.get("type"), failure.text) for failure in case
                                       if failure.tag == "failure"] for case in root.iter("testcase")}
        self.assertEqual(failures["/world-1/final"], [])
        self.assertEqual(failures["pack"], [])
        self.assertEqual(failures["/final"], failures["/world-1/composite"])
        self.assertIn(LIBRARY.splitlines()[1], failures["/final"][0][1])
        remarks = root.find(".//testcase[@name='pack']/system-out").text
        self.assertIn("UNKNOWN_A", remarks)
        self.assertNotIn("UNKNOWN_B", remarks)

    def test_counts_agree_with_the_cases(self):
        for words in ([], ["--strict"]):
            root = ElementTree.fromstring(Folder().report("junit", *words))
            for suite in [root, *root]:
                cases = list(suite.iter("testcase"))
                failed = [case for case in cases if case.find("failure") is not None]
                self.assertEqual((int(suite.get("tests")), int(suite.get("failures"))),
                                 (len(cases), len(failed)))

    def test_survives_what_xml_cannot_say(self):
        bad = {"shaders/shaders.properties": "screen = A\x01\x1b[31m<&>\"'\u00e9\ufffe]]>\n"}
        ElementTree.fromstring(Folder(bad).report("junit"))


class Github(unittest.TestCase):
    def test_annotates_the_line(self):
        lines = Folder().report("github").splitlines()
        self.assertEqual([line.split(" ")[0] for line in lines],
                         ["::error", "::warning", "::warning", "::warning"])
        self.assertRegex(lines[0], r"^::error file=pack/shaders/lib/my file\.glsl,line=2,col=19,"
                                   r"title=glsl-compile::.*undeclared.*%0Aincluded from /final")
        self.assertNotIn("UNKNOWN_B", "".join(lines))

    def test_escapes_what_ends_a_property(self):
        files = {"shaders/a,b%c/x.glsl": LIBRARY,
                 "shaders/final.fsh": FRAGMENT.replace("my file", "../a,b%c/x")}
        self.assertIn("file=pack/shaders/a%2Cb%25c/x.glsl,line=2", Folder(files).report("github"))


class Text(unittest.TestCase):
    def test_shows_the_id_and_the_counts(self):
        result = Folder().validate()
        self.assertRegex(result.stderr, r"(?m)^/shaders\.properties:8:1: warning: .* \[alpha-test\]$")
        self.assertIn("\n  1 error, 3 warnings, 1 ignored\n", result.stdout)

    def test_cuts_long_lines_around_the_caret(self):
        long = "screen = " + "<empty> " * 400 + "NOT_THERE " + "<empty> " * 400
        lines = Folder({"shaders/shaders.properties": long}).validate().stderr.splitlines()
        at = next(i for i, line in enumerate(lines) if "screen-option" in line)
        self.assertIn(f":1:{long.index('NOT_THERE') + 1}: ", lines[at])
        self.assertLess(len(lines[at + 1]), 180)
        self.assertTrue(lines[at + 1][lines[at + 2].index("^"):].startswith("NOT_THERE"))


    def test_cuts_long_lines_at_their_end(self):
        long = "screen = " + "<empty> " * 400 + "NOT_THERE"
        lines = Folder({"shaders/shaders.properties": long}).validate().stderr.splitlines()
        at = next(i for i, line in enumerate(lines) if "screen-option" in line)
        self.assertTrue(lines[at + 1].endswith(" NOT_THERE"))


class KnownProblems(unittest.TestCase):
    def test_are_not_reported_again_wherever_they_move(self):
        folder = Folder()
        folder.validate("--write-baseline", "known")
        first = (folder.path / "known").read_text()
        moved = Folder({"shaders/lib/my file.glsl": "// new line\n" + LIBRARY})
        (moved.path / "known").write_text(first)
        result = moved.validate("--baseline", "known", status=0)
        self.assertEqual(result.stderr, "")
        self.assertIn("known: 4 known problems, 0 gone\n", result.stdout)

    def test_new_ones_are_reported_and_gone_ones_counted(self):
        folder = Folder()
        folder.validate("--write-baseline", "known")
        known = (folder.path / "known").read_text()
        other = Folder({"shaders/shaders.properties": PROPERTIES.replace("WRONG", "WORSE")})
        (other.path / "known").write_text(known)
        result = other.validate("--baseline", "known", "--strict")
        self.assertEqual(len(re.findall(r": (?:error|warning): ", result.stderr)), 1)
        self.assertIn("WORSE", result.stderr)
        self.assertIn("known: 3 known problems, 1 gone\n", result.stdout)

    def test_file_is_the_same_each_time(self):
        texts = []
        for _ in range(2):
            folder = Folder()
            folder.validate("--write-baseline", "known", "--jobs", "3")
            texts.append((folder.path / "known").read_text())
        self.assertEqual(*texts)


class Settings(unittest.TestCase):
    def test_come_from_the_folder_s_own_file(self):
        folder = Folder()
        (folder.path / "orris.toml").write_text(
            '[validate]\nignore = ["alpha-test", "ignore-unknown"]\n'
            'severity = ["glsl-compile=warning"]\n')
        self.assertIn("  2 warnings, 3 ignored\n", folder.validate(status=0).stdout)
        self.assertNotIn("error", folder.validate("--strict").stderr)

    def test_of_a_named_file_may_name_files(self):
        folder = Folder()
        (folder.path / "orris.toml").write_text(
            '[validate]\nreport = ["github=a.txt", "junit=b.xml"]\n')
        folder.validate("--config", "orris.toml")
        self.assertTrue((folder.path / "a.txt").exists() and (folder.path / "b.xml").exists())

    def test_that_do_not_exist_are_refused(self):
        folder = Folder()
        for line in ("strct = true", 'ignore = ["no-such-check"]', 'severity = ["alpha-test=bad"]',
                     'report = ["pdf=x"]', 'format = "pdf"'):
            (folder.path / "orris.toml").write_text(f"[validate]\n{line}\n")
            self.assertIn("orris validate: error: ",
                          folder.validate("--config", "orris.toml", status=2).stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], warnings="ignore")
