"""Options, profiles, screens, properties, id maps and language files without measure."""

from hostile_files import FRAGMENT, HEAD, MAIN, fragment, pack, properties

N = 100_000
M = 19_000  # just within the lines that a properties file may have
LARGE = "text-too-large"
DEFINED = HEAD + "#define A 1 // [1 2 3]\n" + MAIN


def lines(pattern: str, count: int) -> str:
    return "".join(pattern.format(i, i + 1) + "\n" for i in range(count))


def with_file(name: str, text, **more):
    return lambda folder: pack(folder, {name: text, **more})


def defined(text: str):
    return lambda folder: pack(folder, {"shaders.properties": text, "composite.fsh": DEFINED})


def folders_many(folder):
    programs = {f"d{i}/composite.fsh": FRAGMENT for i in range(300)}
    return pack(folder, {**programs, "dimension.properties": lines("dimension.d{0}=a{0}", 300)})


def languages_many(folder):
    return pack(folder, {f"lang/l{i}_aa.lang": lines("option.A{0}=b", 10_000) for i in range(40)})


TREE = "".join(f"profile.P{i}=profile.P{i + 1} profile.P{i + 1}\n" for i in range(80)) + "profile.P80=A=2\n"

BOMBS = {
    "profiles-double": lambda: (defined(TREE), None),
    "profiles-double-unknown": lambda: (defined(TREE.replace("P80=A=2", "P80=NONE")), None),
    "profiles-chain": lambda: (defined(lines("profile.P{0}=profile.P{1}", M)), "property-limit"),
    "profiles-chain-10-5": lambda: (defined(lines("profile.P{0}=profile.P{1}", N)), LARGE),
    "profiles-circle": lambda: (defined(lines("profile.P{0}=profile.P{1}", 50) + "profile.P50=profile.P0\n"),
                                "profile-recursion"),
    "profile-of-all": lambda: (defined("profile.ALL=" + " ".join(f"profile.P{i}" for i in range(M)) + "\n" +
                               lines("profile.P{0}=A=2", M)), None),
    "profile-line-145-kb": lambda: (defined("profile.P=" + "NONE=1 " * 20_000 + "\n"), "profile-option"),
    "profile-line-again": lambda: (defined("profile.P=" + "A=9 " * N + "\n"), "profile-value"),
    "profiles-many-programs": lambda: (defined(lines("profile.P{0}=!program.none{0}", M)), "profile-program"),
    "screen-line-380-kb": lambda: (properties("screen=" + "NONE " * 76_000 + "\n"), "screen-option"),
    "screens-chain": lambda: (properties(lines("screen.S{0}=[S{1}]", M)), "property-limit"),
    "screens-chain-10-5": lambda: (properties(lines("screen.S{0}=[S{1}]", N)), LARGE),
    "screen-columns": lambda: (properties(lines("screen.S{0}.columns=x", M)), "property-value"),
    "sliders-many": lambda: (properties("sliders=" + " ".join(f"S{i}" for i in range(N)) + "\n"), None),
    "uniforms-chain": lambda: (properties(lines("variable.float.u{0}=u{1}", M)), "property-limit"),
    "uniforms-chain-back": lambda: (properties("".join(f"uniform.float.u{i + 1}=u{i}\n" for i in range(M)) +
                                       "uniform.float.u0=1\n"), None),
    "uniforms-chain-10-5": lambda: (properties(lines("uniform.float.u{0}=u{1}", N)), LARGE),
    "uniforms-circle": lambda: (properties(lines("uniform.float.u{0}=u{1}", 900) + "uniform.float.u900=u0\n"),
                                None),
    "uniform-parentheses": lambda: (properties("uniform.float.u=" + "(" * N + "1" + ")" * N + "\n"),
                            "uniform-dropped"),
    "uniform-terms": lambda: (properties("uniform.float.u=1" + "+1" * N + "\n"), "uniform-dropped"),
    "uniform-calls": lambda: (properties("uniform.float.u=" + "abs(" * N + "1" + ")" * N + "\n"),
                      "uniform-dropped"),
    "program-condition": lambda: (properties("program.composite.enabled=" + "!" * N + "A\n"), None),
    "program-conditions": lambda: (properties("program.composite.enabled=" + "A && " * N + "A\n"), None),
    "keys-10-6": lambda: (properties(lines("k{0}=1", 1_000_000)), LARGE),
    "keys-unknown": lambda: (properties(lines("blnd.composite{0}=1", M)), "property-unknown"),
    "keys-twice": lambda: (properties(lines("clouds=w{0}", M)), "property-value"),
    "key-long": lambda: (properties("a" * 2_000_000 + "=1\n"), None),
    "value-long": lambda: (properties("clouds=" + "a" * 2_000_000 + "\n"), "property-value"),
    "value-continued": lambda: (properties("screen=" + "a \\\n" * M + "\n"), "screen-option"),
    "value-escapes": lambda: (properties("clouds=" + "\\u0041" * 500_000 + "\n"), "property-value"),
    "blends-wrong": lambda: (properties(lines("blend.composite{0}=bad", M)), None),
    "flips-wrong": lambda: (properties(lines("flip.composite{0}.colortex0=bad", M)), None),
    "scales-huge": lambda: (properties("scale.composite=1e30\n"), None),
    "sizes-huge": lambda: (properties(lines("size.buffer.colortex{0}=99999999 99999999", 16)), None),
    "textures-missing": lambda: (properties(lines("texture.composite.t{0}=none{0}.png", M)), None),
    "textures-raw": lambda: (properties(lines("customTexture.t{0}=composite.fsh TEXTURE_3D RGBA32F 2048 2048 2048 "
                                      "RGBA FLOAT", 40)), "texture-short"),
    "images-huge": lambda: (properties("iris.features.required=CUSTOM_IMAGES\n" + lines(
        "image.i{0}=s{0} rgba rgba32f float false false 16384 16384 16384", 16)), None),
    "buffers-huge": lambda: (properties("iris.features.required=SSBO\n" + lines(
        "bufferObject.{0}=1073741824", 9)), None),
    "buffers-beyond": lambda: (properties("iris.features.required=SSBO\n" + lines(
        "bufferObject.{0}=99999999999999999999", 9)), None),
    "features-many": lambda: (properties("iris.features.required=" + "NOPE " * N + "\n"), None),
    "defines-in-properties": lambda: (properties("#define A0 x\n" + "".join(
        f"#define A{i} A{i - 1} A{i - 1}\n" for i in range(1, 60)) + "clouds=A59\n"),
                              "macro-expansion-limit"),
    "ifs-in-properties": lambda: (properties("#if 1\n" * M), None),
    "properties-utf16": lambda: (lambda folder: pack(folder, {"shaders.properties": "clouds=off\n".encode("utf-16")}),
                         "text-utf16"),
    "auto-many": lambda: (properties(lines("auto.A{0}.1=pixels", M)), None),
    "warnings-many": lambda: (properties(lines("warn.w{0}=bufferObject.0 0 > 1 text", M)), None),
    "dimensions-10-5": lambda: (with_file("dimension.properties", lines("dimension.d{0}=a{0}", N)), LARGE),
    "dimensions-many": lambda: (with_file("dimension.properties", lines("dimension.d{0}=a{0}", M)),
                        "dimension-folder"),
    "dimensions-of-one": lambda: (with_file("dimension.properties", "dimension.world0=" + "a " * N + "\n"), None),
    "dimension-folders": lambda: (folders_many, None),
    "blocks-10-6": lambda: (with_file("block.properties", lines("block.{0}=a{0}", 1_000_000)), LARGE),
    "blocks-many": lambda: (with_file("block.properties", lines("block.{0}=a{0} b{0} c{0}", M)), None),
    "block-named-often": lambda: (with_file("block.properties", lines("block.{0}=stone", M)), "id-twice"),
    "block-states": lambda: (with_file("block.properties", "".join(
        f"block.{i}=" + " ".join(f"stone:a{i}={j}" for j in range(100)) + "\n" for i in range(1000))), None),
    "block-values": lambda: (with_file("block.properties", "block.1=stone:a=" + "b," * N + "\n"), None),
    "block-parts": lambda: (with_file("block.properties", "block.1=stone" + ":a" * N + "\n"), "id-state"),
    "block-words": lambda: (with_file("block.properties", "block.1=" + "%a " * N + "\n"), None),
    "block-ids-wrong": lambda: (with_file("block.properties", lines("block.x{0}=a", M)), "id-number"),
    "block-lines-stray": lambda: (with_file("block.properties", "block.1=a\n" + lines("stray{0}", M)),
                          "id-stray-line"),
    "layers-wrong": lambda: (with_file("block.properties", lines("layer.x{0}=a", M)), "id-layer"),
    "items-many": lambda: (with_file("item.properties", lines("item.{0}=a{0}", M)), None),
    "items-again": lambda: (with_file("item.properties", "item.1=" + "a " * N + "\n"), None),
    "language-10-6": lambda: (with_file("lang/en_us.lang", lines("option.A{0}=b", 1_000_000)), LARGE),
    "language-many": lambda: (with_file("lang/en_us.lang", lines("option.A{0}=b", M)), None),
    "language-twice": lambda: (with_file("lang/en_us.lang", lines("option.A=b{0}", M)), "language-twice"),
    "languages-40": lambda: (languages_many, None),
    "options-10-4": lambda: (fragment(lines("#define OPTION{0} 1 // [1 2 3]", 10_000) + MAIN), None),
    "options-booleans": lambda: (fragment(lines("#define FLAG{0}\n#ifdef FLAG{0}\n#endif", 10_000) + MAIN), None),
    "option-values": lambda: (fragment("#define A 1 // [" + " ".join(map(str, range(N))) + "]\n" + MAIN), None),
    "option-same-value": lambda: (fragment("#define A 1 // [" + "1 " * N + "]\n" + MAIN), None),
    "options-ambiguous": lambda: (fragment(lines("#define A {0} // [1 2 3]", M) + MAIN), None),
}

# Those that take seconds to write or to read.
HEAVY = {"keys-10-6", "blocks-10-6", "language-10-6", "languages-40"}
