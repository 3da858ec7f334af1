"""Faults in GLSL code. Each kind yields every place of a pack where it can be made."""
import re

from pack_view import Fault

TYPES = {"float", "int", "uint", "bool", "void", "vec2", "vec3", "vec4", "ivec2", "ivec3", "ivec4",
         "uvec2", "uvec3", "uvec4", "mat2", "mat3", "mat4", "sampler2D", "sampler3D"}
WORDS = TYPES | {"in", "out", "inout", "const", "return", "if", "else", "for", "while", "do", "true",
                 "false", "discard", "break", "continue", "struct", "uniform", "varying", "flat",
                 "highp", "mediump", "lowp", "layout", "attribute", "switch", "case", "default",
                 "precision", "defined", "invariant", "smooth", "centroid", "noperspective"}
BUILTINS = ("mix|clamp|dot|max|min|pow|smoothstep|step|length|normalize|sin|cos|exp|floor|fract|abs|"
            "sqrt|cross|reflect|mod|distance")
CONTRACT_TYPES = {"frameTimeCounter": "float", "cameraPosition": "vec3", "viewWidth": "float",
                  "viewHeight": "float", "near": "float", "far": "float", "sunPosition": "vec3",
                  "moonPosition": "vec3", "shadowLightPosition": "vec3", "upPosition": "vec3",
                  "worldTime": "int", "frameCounter": "int", "isEyeInWater": "int",
                  "gbufferModelView": "mat4", "gbufferModelViewInverse": "mat4",
                  "gbufferProjection": "mat4", "gbufferProjectionInverse": "mat4",
                  "shadowModelView": "mat4", "shadowProjection": "mat4", "rainStrength": "float",
                  "previousCameraPosition": "vec3", "eyeBrightnessSmooth": "ivec2",
                  "fogColor": "vec3", "skyColor": "vec3", "aspectRatio": "float"}
OTHER_TYPE = {"float": "vec2", "vec2": "vec3", "vec3": "vec4", "vec4": "vec3", "int": "float",
              "mat4": "mat3", "ivec2": "vec2", "mat3": "mat4", "uint": "float", "ivec3": "vec3"}
INTERFACE = re.compile(r"^\s*(?:(?:flat|smooth|noperspective|centroid)\s+)*(varying|in|out)\s+"
                       r"(?:(?:flat|smooth|highp|mediump|lowp)\s+)*(\w+)\s+(\w+)\s*;")


def code_lines(view):
    """File, source, number and code of each line that reaches a driver and is no directive."""
    for file, source in view.sources.items():
        for number in sorted(view.reach.lines[file]):
            if number <= len(source.lines) and not source.directive[number - 1]:
                code = source.code[number - 1]
                if code.strip():
                    yield file, source, number, code


def edit(kind, file, source, number, begin, end, text, **more):
    line = source.lines[number - 1]
    return Fault(kind, file, number, line[:begin] + text + line[end:], **more)


def from_pattern(kind, pattern, replacement):
    """The kind that replaces group 1 of each match; `replacement` may refuse with None."""
    compiled = re.compile(pattern)

    def places(view):
        for file, source, number, code in code_lines(view):
            for match in compiled.finditer(code):
                text = replacement(view, match, code)
                if text is not None:
                    yield edit(kind, file, source, number, *match.span(1), text)
    return kind, places


def closing(code, start):
    """Offset of the parenthesis that closes the one at `start`, -1 when it is on another line."""
    depth = 0
    for i in range(start, len(code)):
        depth += {"(": 1, ")": -1}.get(code[i], 0)
        if depth == 0:
            return i
    return -1


def semicolon(_, match, code):
    before = code[:match.start(1)].rstrip()
    return "" if before and before[-1] not in ";{}" else None


def used_word(view, match, code):
    word = match.group(1)
    is_name = word not in WORDS and not word.startswith("gl_") and not code.lstrip().startswith(
        "layout")
    return view.misspell(word) if is_name and len(word) > 1 else None


def misspelt(view, match, _):
    return view.misspell(match.group(1)) if match.group(1) not in WORDS else None


def braces(kind, brace):
    def places(view):
        for file, source, number, code in code_lines(view):
            for match in re.finditer(re.escape(brace), code):
                other = partner(source, number, match.start())
                yield edit(kind, file, source, number, match.start(), match.end(), "",
                           ends=(other,) if other else ())
    return kind, places


def partner(source, number, column):
    """Line of the brace that belongs to the one at a place, None when there is none."""
    step = 1 if source.code[number - 1][column] == "{" else -1
    depth, row = 0, number - 1
    while 0 <= row < len(source.code):
        code = source.code[row] if not source.directive[row] else ""
        if row == number - 1:
            code = code[column:] if step == 1 else code[:column + 1]
        for char in code if step == 1 else reversed(code):
            depth += {"{": step, "}": -step}.get(char, 0)
            if depth == 0 and char in "{}":
                return row + 1
        row += step
    return None


def argument_count(view):
    own = set()
    for source in view.sources.values():
        for code in source.code:
            own.update(re.findall(r"^\s*(?:\w+\s+)?\w+\s+(\w+)\s*\(.*\)\s*{?\s*$", code))
    own -= WORDS
    call = re.compile(rf"(?<![\w.])(?:{BUILTINS}|{'|'.join(sorted(own)) or 'main'})\s*(\()")
    for file, source, number, code in code_lines(view):
        for match in call.finditer(code):
            end = closing(code, match.start(1))
            inside = code[match.end(1):end] if end > 0 else ""
            is_call = source.depth[number - 1] > 0 and not re.search(
                rf"\b({'|'.join(TYPES)})\s+$", code[:match.start()])
            if inside.strip() and is_call:
                yield edit("argument-count", file, source, number, end, end, ", 0.0, 0.0")


def vector_to_scalar(view):
    declaration = re.compile(r"^\s*(?:const\s+)?float\s+\w+\s*=\s*([^;,]+|[^;]*\)[^;,]*);")
    for file, source, number, code in code_lines(view):
        match = declaration.match(code)
        if match and match.group(1).count("(") == match.group(1).count(")"):
            yield edit("vector-to-scalar", file, source, number, *match.span(1),
                       f"vec3({match.group(1).strip()})")


def swizzle_range(view):
    for file, source in view.sources.items():
        text = "\n".join(source.code)
        others = set(re.findall(r"\b(?:vec[34]|float|mat\d|ivec\d|uvec\d)\s+(\w+)", text))
        names = set(re.findall(r"\bvec2\s+(\w+)\s*[;=,)]", text)) - others - WORDS
        if not names:
            continue
        use = re.compile(rf"(?<![\w.])(?:{'|'.join(sorted(names))})\.([xy])\b(?!\s*[\w.(])")
        for number in sorted(view.reach.lines[file]):
            if number > len(source.code) or source.directive[number - 1]:
                continue
            for match in use.finditer(source.code[number - 1]):
                yield edit("swizzle-range", file, source, number, *match.span(1), "z")


def redeclared(view):
    for file, source, number, code in code_lines(view):
        match = re.match(r"^\s*((?:float|vec[234]|int)\s+\w+\s*=[^;{}]*;)\s*$", code)
        if match and source.depth[number - 1] > 0:
            yield edit("redeclared", file, source, number, match.end(1), match.end(1),
                       " " + match.group(1))


def uniform_name(view):
    for file, source, number, code in code_lines(view):
        match = re.match(r"^\s*uniform\s+(?:(?:highp|mediump|lowp)\s+)?\w+\s+(\w+)\s*;", code)
        if match:
            yield edit("uniform-name", file, source, number, *match.span(1),
                       view.misspell(match.group(1)))


def uniform_type(view):
    for file, source, number, code in code_lines(view):
        match = re.match(r"^\s*uniform\s+(\w+)\s+(\w+)\s*;", code)
        if not match:
            continue
        kind, name = match.groups()
        if CONTRACT_TYPES.get(name) == kind:
            yield edit("uniform-type", file, source, number, *match.span(1), OTHER_TYPE[kind])
        elif kind == "sampler2D" and re.fullmatch(r"(colortex|depthtex)\d+", name):
            yield edit("uniform-type", file, source, number, *match.span(1), "samplerCube")


def varyings(view):
    """Declarations of varyings that both stages use, in files of one stage."""
    for file, source, number, code in code_lines(view):
        match = INTERFACE.match(code)
        stages = view.reach.stages[file]
        if not match or source.depth[number - 1] or stages not in ({".vsh"}, {".fsh"}):
            continue
        word, is_vertex = match.group(1), stages == {".vsh"}
        if word == ("in" if is_vertex else "out"):
            continue
        # What one stage only declares may have any name.
        name = re.compile(rf"\b{match.group(3)}\b")
        texts = [view.reach.texts.get(program + stage, "") for program in view.reach.programs[file]
                 for stage in (".vsh", ".fsh")]
        if all(len(name.findall(text)) > 1 for text in texts):
            yield file, source, number, match


def varying_name(view):
    for file, source, number, match in varyings(view):
        yield edit("varying-name", file, source, number, *match.span(3),
                   view.misspell(match.group(3)))


def varying_renamed(view):
    for file, source, number, match in varyings(view):
        word, new = match.group(3), view.misspell(match.group(3))
        changed = [(i, re.sub(rf"\b{word}\b", new, line)) for i, line in enumerate(source.lines, 1)]
        also = tuple((i, line) for i, line in changed if i != number and line != source.lines[i - 1])
        yield Fault("varying-renamed", file, number, changed[number - 1][1], also)


def varying_type(view):
    for file, source, number, match in varyings(view):
        other = OTHER_TYPE.get(match.group(2))
        if other:
            yield edit("varying-type", file, source, number, *match.span(2), other)


def attribute_name(view):
    for file, source, number, code in code_lines(view):
        match = re.match(r"^\s*(?:attribute|in)\s+\w+\s+(\w+)\s*;", code)
        if match and view.reach.stages[file] == {".vsh"} and not source.depth[number - 1]:
            yield edit("attribute-name", file, source, number, *match.span(1),
                       view.misspell(match.group(1)))


def brace_extra(view):
    """One more } behind the end of a block, on a blank line or behind the last of the file."""
    for file, source in view.sources.items():
        used = view.reach.lines[file]
        for number in range(2, len(source.lines) + 1):
            before = source.code[number - 2].strip()
            if not source.lines[number - 1].strip() and before == "}" and number - 1 in used:
                yield Fault("brace-extra", file, number, "}", ends=(number - 1,))


def varying_removed(view):
    """Any line that names it is the place of a declaration that is gone."""
    for file, source, number, match in varyings(view):
        name = re.compile(rf"\b{match.group(3)}\b")
        uses = tuple((other, line) for other, more in view.sources.items()
                     if view.reach.programs[other] & view.reach.programs[file]
                     for line, code in enumerate(more.code, 1) if name.search(code))
        yield edit("varying-removed", file, source, number, 0, len(source.lines[number - 1]), "", ends=uses)


KINDS = dict([
    from_pattern("semicolon", r"(;)", semicolon),
    braces("closing-brace", "}"),
    braces("opening-brace", "{"),
    ("brace-extra", brace_extra),
    from_pattern("closing-parenthesis", r"(\))", lambda *_: ""),
    from_pattern("opening-parenthesis", r"\w(\()", lambda *_: ""),
    from_pattern("operator", r"[\w)] ([*/+]) [\w(]", lambda *_: " "),
    from_pattern("stray-character", r"= ?()\w", lambda *_: "$"),
    from_pattern("misspelt-name", r"(?<=[=(,+\-*/<>?:] )([A-Za-z_]\w*)\b(?!\s*[(\w])", used_word),
    from_pattern("misspelt-function", r"(?<=[=(,+\-*/<>?:] )([A-Za-z_]\w*)(?=\()", misspelt),
    from_pattern("misspelt-type", r"^\s+(float|vec[234]|mat[34]|int)\s+\w+\s*[=;]",
                 lambda view, match, _: view.misspell(match.group(1))),
    from_pattern("swizzle", r"[\w)]\.([xyz]{2,3}|[rgb]{2,3})\b(?!\()",
                 lambda _, match, __: match.group(1)[:-1] + ("q" if "x" in match.group(1) else "y")),
    ("swizzle-range", swizzle_range),
    ("argument-count", argument_count),
    ("vector-to-scalar", vector_to_scalar),
    ("redeclared", redeclared),
    ("uniform-name", uniform_name),
    ("uniform-type", uniform_type),
    ("varying-name", varying_name),
    ("varying-renamed", varying_renamed),
    ("varying-removed", varying_removed),
    ("varying-type", varying_type),
    ("attribute-name", attribute_name),
])
