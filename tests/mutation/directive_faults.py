"""Faults in preprocessor lines, includes and the directives that Iris reads in GLSL files."""
import random
import re

from glsl_faults import edit
from pack_view import Fault

INCLUDE = re.compile(r"^\s*#\s*include\s+[\"<]?([^\"<>\s]+)")
# Kinds that change what hosts read in comments, which the driver does not get.
IN_COMMENTS = {"render-target-too-many", "render-target-range", "format-unknown",
               "constant-misspelt"}
# More would only repeat: each costs two runs more.
OPTIONS_TRIED = 3


def lines_in_use(view):
    for file, number in view.lines_in_use:
        yield file, view.sources[file], number


def matching(view, pattern):
    compiled = re.compile(pattern)
    for file, source, number in lines_in_use(view):
        match = compiled.search(source.lines[number - 1])
        if match:
            yield file, source, number, match


def include_path(view):
    for file, source, number, match in matching(view, INCLUDE):
        stem, dot, suffix = match.group(1).rpartition(".")
        if source.directive[number - 1] and stem:
            yield edit("include-path", file, source, number, *match.span(1),
                       stem + "x" + dot + suffix)


def include_removed(view):
    for file, source, number, _ in matching(view, INCLUDE):
        if source.directive[number - 1]:
            yield Fault("include-removed", file, number, "")


def conditionals(kind, index, text):
    """Replaces the first or last line of a conditional whose surroundings are in use."""
    def places(view):
        used = {}
        for file, _, number in lines_in_use(view):
            used.setdefault(file, set()).add(number)
        for file, source in view.sources.items():
            for group in source.groups:
                if group[0] in used.get(file, ()):
                    yield Fault(kind, file, group[index], text, ends=(group[-1 - index],))
    return kind, places


def endif_extra(view):
    for file, source, number in lines_in_use(view):
        if source.lines[number - 1].strip() == "" and 1 < number < len(source.lines) and (
                not source.directive[number - 2]):
            branch = source.branches[number]
            outer = () if branch == (1, len(source.lines)) else (branch[1] + 1,)
            yield Fault("endif-extra", file, number, "#endif", ends=outer)


def directive_misspelt(view):
    for file, source, number, match in matching(view, r"^\s*#\s*(ifdef|define|include|endif)\b"):
        if source.directive[number - 1]:
            ends = tuple(g[0] + g[-1] - number for g in source.groups if number in (g[0], g[-1]))
            yield edit("directive-misspelt", file, source, number, *match.span(1),
                       match.group(1)[:-2] + match.group(1)[-1] + match.group(1)[-2], ends=ends)


def macro_body(view):
    """A name that is not declared in a macro that is expanded."""
    for file, source in view.sources.items():
        for number in sorted(view.reach.lines[file]):
            if number > len(source.lines) or not source.directive[number - 1]:
                continue
            match = re.match(r"^\s*#\s*define\s+\w+\([^)]*\)\s+(\S.*\S)\s*$", source.code[number - 1])
            if match and not match.group(1).endswith("\\") and "{" not in match.group(1):
                yield edit("macro-body", file, source, number, match.start(1), match.start(1),
                           "notDeclaredq + ")


def option_branch(view):
    """A name that is not declared, in a branch that only another value of one option opens."""
    branches = []
    for file, source in view.sources.items():
        for group in source.groups:
            match = re.match(r"^\s*#\s*ifdef\s+(\w+)\s*$", source.code[group[0] - 1])
            option = view.options.get(match.group(1)) if match else None
            if option and option.get("default") == "false":
                branches.append((match.group(1), file, group))
    names = sorted({name for name, _, _ in branches})
    random.Random(view.name).shuffle(names)
    for name in sorted(names[:OPTIONS_TRIED]):
        setting = (f"{name}=true",)
        reach = view.reach_with(setting)
        for _, file, group in (branch for branch in branches if branch[0] == name):
            source = view.sources[file]
            for number in range(group[0] + 1, group[1]):
                new = number in reach.lines.get(file, ()) and number not in view.reach.lines[file]
                before = [source.code[i - 1].strip() for i in range(group[0] + 1, number)]
                before = [text for text in before if text]
                starts = not before or before[-1][-1] in ";{}"
                if new and starts and not source.directive[number - 1] and (
                        re.match(r"\s*(float|vec[234])\s+\w+\s*=|\s*\w+(\.\w+)?\s*[*+]?=[^=]",
                                 source.code[number - 1])):
                    line = source.lines[number - 1]
                    yield Fault("option-branch", file, number, "float missq = NOT_DEFINEDQ; " + line,
                                options=setting)
                    break


def render_targets(view):
    pattern = r"/\*\s*(DRAWBUFFERS|RENDERTARGETS)\s*:\s*([\d, ]*\d)\s*\*/"
    for file, source, number, match in matching(view, pattern):
        text = "\n".join(source.lines)
        alone = len(re.findall(r"(?:DRAWBUFFERS|RENDERTARGETS)\s*:", text)) == 1
        if not alone or view.reach.stages[file] != {".fsh"}:
            continue
        digits = match.group(1) == "DRAWBUFFERS"
        listed = set(match.group(2).replace(" ", "") if digits else
                     re.findall(r"\d+", match.group(2)))
        spare = next((str(i) for i in range(7, 0, -1) if str(i) not in listed), None)
        if spare is None:
            continue
        yield edit("render-target-too-many", file, source, number, match.end(2), match.end(2),
                   spare if digits else "," + spare)


def render_target_range(view):
    for file, source, number, match in matching(view, r"/\*\s*RENDERTARGETS\s*:\s*(\d+)"):
        if view.reach.stages[file] == {".fsh"}:
            yield edit("render-target-range", file, source, number, *match.span(1), "47")


def format_unknown(view):
    pattern = r"^\s*const\s+int\s+(?:colortex\d+|shadowcolor\d|g\w+)Format\s*=\s*(\w+)\s*;"
    for file, source, number, match in matching(view, pattern):
        yield edit("format-unknown", file, source, number, *match.span(1), match.group(1) + "Q")


def constant_misspelt(view):
    pattern = (r"^\s*const\s+\w+\s+(shadowMapResolution|shadowDistance|sunPathRotation|ambientOcclusionLevel"
               r"|shadowDistanceRenderMul|colortex\d+Clear|colortex\d+Format|noiseTextureResolution"
               r"|eyeBrightnessHalflife|wetnessHalflife|shadowHardwareFiltering\d?)\s*=")
    for file, source, number, match in matching(view, pattern):
        yield edit("constant-misspelt", file, source, number, *match.span(1),
                   view.misspell(match.group(1)))


def version_removed(view):
    for file, source, number, _ in matching(view, r"^\s*#\s*version\b"):
        if source.directive[number - 1]:
            yield Fault("version-removed", file, number, "")


def comment_for_line(view):
    """/* for // behind an option."""
    for file, source, number, match in matching(view, r"^\s*#\s*define\s+\w+\s+[\w.-]+\s*(//)\s*\["):
        yield edit("comment-for-line", file, source, number, *match.span(1), "/*")


def comment_end_removed(view):
    """The last line of a comment of several lines without its */, when another comment comes."""
    for file, source in view.sources.items():
        begin = None
        for number, text in enumerate(source.lines, 1):
            if begin is None and re.match(r"\s*/\*(?!.*\*/)", text):
                begin = number
            elif begin and "*/" in text:
                code = [i for i in view.reach.lines[file] if i > number]
                if code and text.strip().endswith("*/"):
                    at = text.index("*/")
                    yield edit("comment-end-removed", file, source, number, at, at + 2, "",
                               ends=(begin,))
                begin = None


def condition_name(view):
    """An option misspelt in an #if, #elif or #ifdef."""
    for file, source, number, match in matching(view, r"^\s*#\s*(?:el)?if(?:def)?\s+(?:defined\W+)?(\w{5,})"):
        if match.group(1) in view.options:
            yield edit("condition-name", file, source, number, *match.span(1),
                       view.misspell(match.group(1)))


KINDS = dict([
    ("include-path", include_path),
    ("include-removed", include_removed),
    conditionals("if-removed", 0, ""),
    conditionals("endif-removed", -1, ""),
    ("endif-extra", endif_extra),
    ("directive-misspelt", directive_misspelt),
    ("comment-for-line", comment_for_line),
    ("comment-end-removed", comment_end_removed),
    ("condition-name", condition_name),
    ("macro-body", macro_body),
    ("option-branch", option_branch),
    ("render-target-too-many", render_targets),
    ("render-target-range", render_target_range),
    ("format-unknown", format_unknown),
    ("constant-misspelt", constant_misspelt),
    ("version-removed", version_removed),
])
