"""Faults in shaders.properties, the id maps, dimension.properties and the language files."""
import re

from pack_view import Fault, read_lines

SHADERS = "shaders.properties"


def edit(kind, file, number, text, span, new, **more):
    return Fault(kind, "/" + file, number, text[:span[0]] + new + text[span[1]:], **more)


def values(view, key, file=SHADERS):
    """Number, text and match (key, value) of each line whose key fits."""
    compiled = re.compile(rf"^\s*({key})\s*[=:]\s*(.*?)\s*$")
    for number, text in view.properties(file):
        match = compiled.match(text)
        if match and match.group(2):
            yield number, text, match


def from_value(kind, key, pattern, replacement):
    """The kind that replaces group 1 of each match of `pattern` in the value of the keys."""
    compiled = re.compile(pattern)

    def places(view):
        for number, text, match in values(view, key):
            for found in compiled.finditer(text, match.start(2), match.end(2)):
                new = replacement(view, found)
                if new is not None:
                    yield edit(kind, SHADERS, number, text, found.span(1), new)
    return kind, places


def from_key(kind, pattern, replacement):
    """The kind that replaces group 1 of the key."""
    compiled = re.compile(rf"^\s*{pattern}")

    def places(view):
        for number, text in view.properties(SHADERS):
            match = compiled.match(text)
            if match:
                yield edit(kind, SHADERS, number, text, match.span(1), replacement(view, match))
    return kind, places


def misspelt(view, match):
    return view.misspell(match.group(1))


def misspelt_option(view, match):
    return view.misspell(match.group(1)) if match.group(1) in view.options else None


def other_path(_, match):
    return match.group(1).replace(".", "x.", 1)


def beyond_list(view, match):
    option = view.options.get(match.group(0).split("=")[0].split(":")[0], {})
    return "zz9" if option.get("values") else None


def block_rows(view):
    """Number, text, id and names of each line of block.properties."""
    for number, text, match in values(view, r"block\.\d+", "block.properties"):
        yield number, text, match, match.group(2).split()


def block_id_twice(view):
    rows = list(block_rows(view))
    for (first, _, _, _), (_, _, match, _), (number, text, _, _) in zip(rows, rows, rows[1:]):
        yield edit("block-id-twice", "block.properties", number, text,
                   re.match(r"\s*(block\.\d+)", text).span(1), match.group(1), ends=(first,))


def block_listed_twice(view):
    rows = list(block_rows(view))
    for (first, _, _, names), (number, text, match, _) in zip(rows, rows[1:]):
        plain = [name for name in names if re.fullmatch(r"[a-z_]+", name)]
        if plain:
            yield edit("block-listed-twice", "block.properties", number, text,
                       (match.end(2), match.end(2)), " " + plain[0], ends=(first,))


def block_name(view):
    blocks = re.compile(r"(?<![\w:])(?:minecraft:)?(\w+_(?:leaves|planks|stairs|log|slab|ore))(?![\w:])")
    for number, text, match, _ in block_rows(view):
        for found in blocks.finditer(text, *match.span(2)):
            if text.count(found.group(1)) == 1:
                yield edit("block-name", "block.properties", number, text, found.span(1),
                           view.misspell(found.group(1)))


def dimension_folder(view):
    for number, text, match in values(view, r"dimension\.[\w-]+", "dimension.properties"):
        begin, end = match.span(1)
        yield edit("dimension-folder", "dimension.properties", number, text,
                   (begin + len("dimension."), end), "wrold9")


def names_nothing(view, fault):
    """Why the line led nowhere before it was changed, or ""."""
    if fault.kind != "dimension-folder":
        return ""
    folder = re.match(r"\s*dimension\.([\w-]+)", read_lines(view.path(fault.file))[fault.line - 1])
    exists = view.path("/" + folder.group(1)).is_dir()
    return "" if exists else "the pack has no such folder without the fault either"


def shown(view, match):
    """A text of a value that the option does not have is shown to nobody."""
    rest = re.match(r"\.(\S+?)\s*=", match.string[match.end(1):])
    values = view.options[match.group(1)].get("values") or []
    return "value." not in match.group(0) or (rest and rest.group(1) in values)


def language(kind, pattern):
    compiled = re.compile(pattern)

    def places(view):
        for file in view.files:
            if not re.fullmatch(r"/lang/en_us\.lang", file, re.IGNORECASE):
                continue
            for number, text in enumerate(read_lines(view.path(file)), 1):
                match = compiled.match(text)
                if match and match.group(1) in view.options and shown(view, match):
                    yield edit(kind, file[1:], number, text, match.span(1),
                               view.misspell(match.group(1)))
    return kind, places


KINDS = dict([
    from_value("texture-path", r"texture\.[\w.-]+|customTexture\.\w+",
               r"(?<![\w:/-])/?((?:[\w-]+/)*[\w-]+\.(?:png|dat|raw|bin))", other_path),
    from_value("profile-option", r"profile\.\w+", r"(?<![\w.])(\w{3,})(?![\w.])", misspelt_option),
    from_value("profile-value", r"profile\.\w+", r"(?<!\S)\w+[=:]([\w.-]+)", beyond_list),
    from_value("screen-option", r"screen(?:\.\w+)?", r"(?<!\S)(\w{3,})(?!\S)", misspelt_option),
    from_value("screen-link", r"screen(?:\.\w+)?", r"\[(\w{3,})\]", misspelt),
    from_value("slider-option", r"sliders", r"(?<!\S)(\w{3,})(?!\S)", misspelt_option),
    from_key("property-key", r"(sliders|screen|blend|alphaTest|profile|flip|program|size|texture|"
             r"uniform|variable|clouds|sun|moon|oldHandLight|oldLighting|shadow\w+|separateAo|"
             r"underwaterOverlay|vignette|dynamicHandLight|beacon\.beam\.depth|iris\.features\.\w+|"
             r"customTexture|image|bufferObject|scale|rain\.depth|frustum\.culling)\b", misspelt),
    from_key("property-program", r"(?:blend|alphaTest|flip|scale|program)\.(?:world-?\d/)?"
             r"([a-z]+_?[a-z]+)\w*", misspelt),
    from_value("blend-factor", r"blend\.[\w.]+", r"(?<!\S)([A-Z]+_\w+)", misspelt),
    from_value("alpha-function", r"alphaTest\.[\w.]+", r"(?<!\S)([A-Z]{4,})", misspelt),
    from_value("uniform-function", r"(?:uniform|variable)\.\w+\.\w+",
               r"(?<![\w.])([a-z]\w{2,})\(", misspelt),
    from_value("uniform-variable", r"(?:uniform|variable)\.\w+\.\w+",
               r"(?<![\w.])([a-z]\w{3,})\b(?![(\w])", misspelt),
    from_value("uniform-syntax", r"(?:uniform|variable)\.\w+\.\w+", r"(\))", lambda *_: ""),
    from_value("program-condition", r"program\.[\w/.-]+", r"\b([A-Z]\w{2,})\b", misspelt_option),
    from_value("buffer-size", r"size\.buffer\.\w+", r"(?<!\S)([\d.]+)$", lambda *_: "half"),
    ("block-name", block_name),
    ("block-id-twice", block_id_twice),
    ("block-listed-twice", block_listed_twice),
    ("dimension-folder", dimension_folder),
    language("language-option", r"^\s*option\.(\w+)\s*="),
    language("language-comment", r"^\s*option\.(\w+)\.comment\s*="),
    language("language-value", r"^\s*value\.(\w+)\."),
])
