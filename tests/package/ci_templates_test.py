#!/usr/bin/env python3
"""ci_templates_test.py SOURCE_DIR PROGRAM: the templates for CI services are well-formed, their shell
steps parse, and every flag of orris in them exists. Exit status 77: a tool is missing."""
import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

try:
    import yaml
except ImportError:
    print("skipped: python3-yaml is not installed")
    sys.exit(77)

SOURCE, PROGRAM = Path(sys.argv[1]), sys.argv[2]
GITHUB, GITLAB = SOURCE / "docs/ci/github", SOURCE / "docs/ci/gitlab"


def load(path):
    # "on" of a workflow is a boolean in YAML 1.1, which GitHub does not follow.
    return yaml.load(path.read_text(), Loader=yaml.BaseLoader)


def steps_of(action):
    return action["runs"]["steps"]


class Action(unittest.TestCase):
    action = load(GITHUB / "action.yml")

    def test_is_composite_and_complete(self):
        self.assertEqual(self.action["runs"]["using"], "composite")
        self.assertTrue(self.action["name"] and self.action["description"])
        for step in steps_of(self.action):
            self.assertEqual(step["shell"], "bash")
        for name, declared in self.action["inputs"].items():
            self.assertIn("description", declared, name)
            self.assertTrue("default" in declared or declared.get("required") == "true", name)

    def test_uses_the_inputs_it_declares(self):
        text = (GITHUB / "action.yml").read_text()
        self.assertEqual(set(re.findall(r"inputs\.(\w+)", text)), set(self.action["inputs"]))

    def test_takes_inputs_from_the_environment_only(self):
        for step in steps_of(self.action):
            self.assertNotIn("${{", step["run"], "an input inside a script can inject commands")

    def test_scripts_parse(self):
        if not shutil.which("bash"):
            self.skipTest("bash is not installed")
        for step in steps_of(self.action):
            subprocess.run(["bash", "-n"], input=step["run"], text=True, check=True)


class Workflow(unittest.TestCase):
    workflow = load(GITHUB / "workflow.yml")

    def test_gives_the_action_only_what_it_takes(self):
        self.assertIn("pull_request", self.workflow["on"])
        steps = self.workflow["jobs"]["validate"]["steps"]
        used = next(step for step in steps if "docs/ci/github@" in step.get("uses", ""))
        self.assertLessEqual(set(used["with"]), set(Action.action["inputs"]))

    def test_uploads_what_the_action_writes(self):
        steps = self.workflow["jobs"]["validate"]["steps"]
        upload = next(step for step in steps if "upload-sarif" in step.get("uses", ""))
        self.assertEqual(upload["with"]["sarif_file"], Action.action["inputs"]["sarif"]["default"])
        self.assertEqual(upload["if"], "always()")
        self.assertEqual(self.workflow["permissions"]["security-events"], "write")


class GalleryWorkflow(unittest.TestCase):
    workflow = load(GITHUB / "gallery.yml")

    def test_draws_base_and_head_within_a_time_and_keeps_the_page(self):
        self.assertEqual(self.workflow["on"], "pull_request")
        self.assertEqual(self.workflow["permissions"], {"contents": "read"})
        job = self.workflow["jobs"]["gallery"]
        self.assertGreater(int(job["timeout-minutes"]), 0)
        run = next(step["run"] for step in job["steps"] if step.get("name") == "Draw")
        pack, base, page = re.search(r"orris gallery (\S+) --against (\S+) -o (\S+) --budget \d+m", run).groups()
        checkouts = [step["with"] for step in job["steps"] if "checkout" in step.get("uses", "")]
        self.assertEqual([checkout["path"] for checkout in checkouts], [pack, base])
        self.assertIn("base.sha", checkouts[1]["ref"])
        upload = next(step for step in job["steps"] if "upload-artifact" in step.get("uses", ""))
        self.assertEqual((upload["with"]["path"], upload["if"]), (page, "always()"))

    def test_scripts_parse_and_take_nothing_from_the_pull_request(self):
        for step in self.workflow["jobs"]["gallery"]["steps"]:
            self.assertNotIn("${{", step.get("run", ""), "an input inside a script can inject commands")
            if "run" in step and shutil.which("bash"):
                subprocess.run(["bash", "-n"], input=step["run"], text=True, check=True)


class Gitlab(unittest.TestCase):
    template = load(GITLAB / "orris.gitlab-ci.yml")

    def test_runs_in_parallel_and_keeps_the_report(self):
        job = self.template["orris-validate"]
        self.assertGreater(int(job["parallel"]), 1)
        report = job["artifacts"]["reports"]["junit"]
        self.assertEqual(job["artifacts"]["when"], "always")
        self.assertIn(f"junit={report}", " ".join(job["script"]))

    def test_sets_the_variables_it_uses(self):
        used = set(re.findall(r"\$\{?(ORRIS_\w+)", (GITLAB / "orris.gitlab-ci.yml").read_text()))
        self.assertEqual(used, set(self.template["variables"]))


class PreCommit(unittest.TestCase):
    def test_hook_runs_orris_once_for_all_files(self):
        (hook,) = load(SOURCE / ".pre-commit-hooks.yaml")
        self.assertEqual((hook["id"], hook["language"], hook["pass_filenames"]),
                         ("orris-validate", "system", "false"))
        self.assertRegex("shaders/lib/a.glsl", hook["files"])
        self.assertRegex("pack/shaders/final.fsh", hook["files"])
        self.assertNotRegex("README.md", hook["files"])


class Placeholder(unittest.TestCase):
    """No address of Orris is known here: a template says OWNER, and beside it that the reader must replace it."""

    def test_is_explained_where_it_stands(self):
        files = [GITHUB / "action.yml", GITHUB / "workflow.yml", GITHUB / "gallery.yml", GITLAB / "orris.gitlab-ci.yml",
                 SOURCE / "docs/ci.md",
                 SOURCE / ".pre-commit-hooks.yaml", SOURCE / "CMakeLists.txt"]
        for path in files:
            lines = path.read_text().splitlines()
            self.assertNotIn("ORG/", path.read_text(), path.name)
            for number, line in enumerate(lines):
                if "OWNER/" in line:
                    near = " ".join(lines[max(number - 2, 0):number + 2]).lower()
                    self.assertRegex(near, r"replace|publishes|as owner/orris", f"{path.name}:{number + 1}")

    def test_gitlab_refuses_it(self):
        template = load(GITLAB / "orris.gitlab-ci.yml")
        for package, status in [(template["variables"]["ORRIS_HOMEPAGE"] + "/a.deb", 2), ("https://e.org/a.deb", 0)]:
            check = template["orris-validate"]["before_script"][0]
            done = subprocess.run(["sh", "-c", check], env={"ORRIS_PACKAGE": package}, capture_output=True)
            self.assertEqual(done.returncode, status, package)


class Flags(unittest.TestCase):
    def check(self, command, files):
        known = subprocess.run([PROGRAM, command, "--help"], capture_output=True, text=True,
                               check=True).stdout
        others = {"--no-install-recommends"}
        for path in files:
            for flag in set(re.findall(r"--[a-z][a-z-]+", path.read_text())) - others:
                self.assertIn(flag, known, path.name)

    def test_of_validate_exist(self):
        self.check("validate", [GITHUB / "action.yml", GITHUB / "workflow.yml", GITLAB / "orris.gitlab-ci.yml",
                                SOURCE / ".pre-commit-hooks.yaml"])

    def test_of_gallery_exist(self):
        self.check("gallery", [GITHUB / "gallery.yml"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
