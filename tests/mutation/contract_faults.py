"""Mistakes against what Iris reads: lines that it refuses, drops or takes for something else."""
import re

from directive_faults import INCLUDE, lines_in_use, matching
from glsl_faults import edit
from pack_view import Fault, blank_comments, read_lines

DIRECTIVE = re.compile(r"\s*#\s*(if|ifdef|ifndef|elif|else|endif|define|undef|error|include)\b")
MAIN = re.compile(r"^\s*void\s+main\s*\(\s*(?:void)?\s*\)\s*(\{?)\s*$")


def spare_lines(view, file):
    """Blank lines and comments of a properties or language file that stand under no condition."""
    path = view.path("/" + file)
    if not path.is_file():
        return
    depth, continued = 0, False
    for number, text in enumerate(read_lines(path), 1):
        text = text.rstrip("\r")
        word = DIRECTIVE.match(text)
        if word and not continued:
            depth += {"if": 1, "ifdef": 1, "ifndef": 1, "endif": -1}.get(word.group(1), 0)
        elif depth == 0 and not continued and (not text.strip() or text.lstrip().startswith("#")):
            yield number
        continued = text.endswith("\\") and not text.lstrip().startswith("#")


def property_line(kind, text, file="shaders.properties"):
    """A further line; `text` may be a function of the pack, None where it does not apply."""
    def places(view):
        line = text(view) if callable(text) else text
        for number in spare_lines(view, file) if line else ():
            yield Fault(kind, "/" + file, number, line)
    return kind, places


def global_lines(view, stage):
    """Blank lines outside of all functions and conditions, in files that one stage alone reads."""
    for file, source, number in lines_in_use(view):
        alone = view.reach.stages[file] == {stage} and source.branches[number] == (1, len(source.lines))
        if (alone and not source.lines[number - 1].strip() and source.depth[number - 1] == 0
                and 2 < number < len(source.lines) and source.code[number - 2].rstrip()[-1:] in ";}"
                and any(reached > number for reached in view.reach.lines[file])
                and blank_comments(source.lines[:number - 1] + ["code"])[-1] == "code"):
            yield file, source, number


def global_line(kind, text, stage=".fsh"):
    def places(view):
        for file, _, number in global_lines(view, stage):
            yield Fault(kind, file, number, text)
    return kind, places


def in_main(kind, text, when=lambda view, file: True):
    """A statement at the begin of a fragment stage's main()."""
    def places(view):
        for file, source in view.sources.items():
            if view.reach.stages[file] != {".fsh"} or not when(view, file):
                continue
            for number in sorted(view.reach.lines[file]):
                match = MAIN.match(source.code[number - 1]) if number < len(source.lines) else None
                if match:
                    at = number if match.group(1) else number + 1
                    if source.lines[at - 1].strip().endswith("{"):
                        yield Fault(kind, file, at, source.lines[at - 1].rstrip("\r") + " " + text)
    return kind, places


def below_400(view, file):
    """Do all programs of the pack have a #version in which int is no uint?"""
    text = "\n".join(line for source in view.sources.values() for line in source.lines)
    versions = [int(number) for number in re.findall(r"^\s*#\s*version\s+(\d+)", text, re.MULTILINE)]
    return bool(versions) and max(versions) < 400


def is_fullscreen(view, file):
    return all(re.search(r"(^|/)(composite|deferred|final)\d*$", program)
               for program in view.reach.programs[file])


def from_line(kind, pattern, replacement):
    """Replaces group 1 of lines in use, comments and all; `replacement` may refuse with None."""
    def places(view):
        for file, source, number, match in matching(view, pattern):
            text = replacement(view, match)
            if text is not None:
                yield edit(kind, file, source, number, *match.span(1), text)
    return kind, places


def sliders_of(view):
    """The line with all that continue it."""
    path = view.path("/shaders.properties")
    text = "\n".join(read_lines(path)) if path.is_file() else ""
    found = re.search(r"^\s*sliders\s*[=:](?:[^\n]*\\\r?\n)*[^\n]*", text, re.MULTILINE)
    return found.group(0) if found else ""


def value_twice(view, match):
    """A slider gets past it, a button does not."""
    sliders = sliders_of(view)
    name = re.search(r"define\s+(\w+)", match.string).group(1)
    values = match.group(1)
    return None if re.search(rf"\b{name}\b", sliders) else f"{values} {values.split()[0]}"


def feedback(view):
    """A gbuffers program that fetches from a buffer that it draws to."""
    for file, source in view.sources.items():
        listed = re.findall(r"/\*\s*(?:RENDERTARGETS\s*:\s*(\d+)|DRAWBUFFERS\s*:\s*(\d))", "\n".join(source.lines))
        gbuffers = all(re.search(r"(^|/)gbuffers_\w+$", p) for p in view.reach.programs[file])
        if view.reach.stages[file] != {".fsh"} or not gbuffers or not listed:
            continue
        buffer = "colortex" + (listed[0][0] or listed[0][1])
        for number in sorted(view.reach.lines[file]):
            match = MAIN.match(source.code[number - 1]) if number < len(source.lines) else None
            if match and match.group(1) and buffer not in "\n".join(source.code):
                yield Fault("target-feedback", file, number, f"uniform sampler2D {buffer}; "
                            f"void main() {{ vec4 fedq = texelFetch({buffer}, ivec2(3), 0);")


def program_renamed(view):
    """composite3.fsh called compsite3.fsh; the vertex stage stays."""
    for file in view.sources:
        stem, dot, ending = file.rpartition(".")
        folder, slash, name = stem.rpartition("/")
        if ending == "fsh" and re.match(r"composite\d*$|gbuffers_\w+$|deferred\d*$", name):
            new = folder + slash + view.misspell(re.match(r"[a-z]+", name).group(0)) + name[len(re.match(
                r"[a-z]+", name).group(0)):] + dot + ending
            yield Fault("program-renamed", file, 1, view.sources[file].lines[0], moved=new)


def byte_order_mark(view):
    for file, source in view.sources.items():
        yield Fault("byte-order-mark", file, 1, "\xef\xbb\xbf" + source.lines[0])


def continuation_lost(view):
    """A line of a list that goes on in the next one without its backslash."""
    lines = read_lines(view.path("/shaders.properties")) if view.path("/shaders.properties").is_file() else []
    for number, (text, following) in enumerate(zip(lines, lines[1:]), 1):
        if text.rstrip().endswith("\\") and not text.lstrip().startswith("#") and "=" not in following:
            yield Fault("continuation-lost", "/shaders.properties", number, text.rstrip()[:-1], ends=(number + 1,))


def include_again(view):
    """A file that includes itself."""
    for file, source, number, _ in matching(view, INCLUDE.pattern):
        if source.directive[number - 1]:
            yield Fault("include-cycle", file, number, f'#include "{file}"')


def blocks_misspelt(view):
    """leafs for leaves, as a plural of English has it."""
    for number, text in view.properties("block.properties"):
        for found in re.finditer(r"(?<![\w:])(?:minecraft:)?(?:oak|birch|spruce|jungle)_(leaves)(?![\w:])", text):
            yield Fault("block-plural", "/block.properties", number,
                        text[:found.start(1)] + "leafs" + text[found.end(1):])


KINDS = dict([
    # What the author's version does not have, and what Iris does not translate.
    in_main("version-uint", "uint versionq = 1;", below_400),
    in_main("version-fma", "float versionq = fma(1.0, 2.0, 3.0);", below_400),
    in_main("built-in-fullscreen", "vec4 builtq = gl_ModelViewMatrixInverse[0];", is_fullscreen),
    in_main("reserved-name", "float iris_q = 0.0;"),
    in_main("unknown-function-call", "vec3 callq = noSuchFunctionq(1.0) * vec3(1.0);"),
    global_line("unused-syntax", "void unusedq() { int a = ; }"),
    global_line("unused-name", "float unusedq() { return notDeclaredq; }"),
    global_line("clear-colour-words", "const vec4 colortex5ClearColor = vec4(0.0);"),
    global_line("dryness", "const float drynessHalflife = 100.0;"),
    global_line("directive-range", "const int shadowMapResolution = -1;"),
    global_line("version-again", "#version 330 compatibility"),
    global_line("error-directive", "#error not made for this"),
    global_line("extension-misspelt", "#extension GL_ARB_shader_texture_lod enable"),
    from_line("render-target-blank", r"/\*\s*RENDERTARGETS\s*:\s*\d+(,)\d", lambda *_: ", "),
    from_line("render-target-letter", r"/\*\s*(?:DRAWBUFFERS|RENDERTARGETS)\s*:\s*(\d)", lambda *_: "x"),
    from_line("condition-empty", r"^\s*#\s*if(\s+\w.*)$", lambda *_: ""),
    from_line("condition-operand", r"^\s*#\s*(?:el)?if\s+\w+\s*==\s*(\w+)\s*$", lambda *_: ""),
    from_line("condition-decimal", r"^\s*#\s*(?:el)?if\s+[A-Z]\w+\s*[=<>]=?\s*(\d)\s*$", lambda *_: "0.5"),
    from_line("option-commas", r"^\s*#\s*define\s+\w+\s+\S+\s*//\s*\[(\d\S* [^\],]+)\]",
              lambda _, match: match.group(1).replace(" ", ", ")),
    from_line("option-value-twice", r"^\s*#\s*define\s+\w+\s+\S+\s*//\s*\[(\d\S* [^\],]+)\]", value_twice),
    from_line("include-words", r"^\s*#\s*include\s+\"[^\"]+\"()\s*$", lambda *_: " // the sky"),
    ("target-feedback", feedback),
    ("program-renamed", program_renamed),
    ("byte-order-mark", byte_order_mark),
    ("include-cycle", include_again),
    # Lines of properties files.
    ("continuation-lost", continuation_lost),
    property_line("blend-blanks", "blend.gbuffers_water=SRC_ALPHA  ONE_MINUS_SRC_ALPHA ONE ZERO"),
    property_line("blend-buffer", "blend.gbuffers_water.colortexq=off"),
    property_line("flip-buffer", "flip.composite.colortexq=true"),
    property_line("size-buffer", "size.buffer.colortex5=1.0 x"),
    property_line("image-words", "image.imageq=samplerq RGBA"),
    property_line("alpha-case", "alphaTest.gbuffers_water=greater 0.1"),
    property_line("uniform-int", "uniform.int.wholeq=frameTimeCounter * 1.5"),
    property_line("expression-end", "uniform.float.expressionq=max(1.0, 2.0"),
    property_line("feature-spelling", "iris.features.required=TESSELATION_SHADERS"),
    property_line("buffer-object-range", "bufferObject.99=16"),
    property_line("profile-circle", "profile.CIRCLEQ=profile.CIRCLEQ"),
    property_line("setting-word", "clouds=sometimes"),
    property_line("screen-columns", lambda view: next(
        (f"{match.group(1)[:-1]}.columns=2" for _, text in view.properties("shaders.properties")
         for match in [re.match(r"\s*(screen\.(?!columns)\w{4,})\s*=", text)] if match), None)),
    property_line("language-stale", "option.GONE_LONG_AGOQ=Gone", "lang/en_us.lang"),
    property_line("language-stale-capital", "option.GONE_LONG_AGOQ=Gone", "lang/en_US.lang"),
    # Id maps.
    property_line("id-number", "block.stone=stone", "block.properties"),
    property_line("id-property", "block.9999=minecraft:oak_stairs:hafl=top", "block.properties"),
    property_line("id-state", "block.9999=minecraft:oak_stairs:half", "block.properties"),
    ("block-plural", blocks_misspelt),
])
