"""Shader texts that grow, nest or repeat without measure."""

from hostile_files import FRAGMENT, HEAD, MAIN, fragment, main_of, pack

N = 100_000


def nested(call: str, depth: int, inner: str) -> str:
    return call * depth + inner + ")" * depth


def doubling(levels: int, step: str, first: str) -> str:
    """#define A1 ... in terms of A0, and so on; `step` has {0} for the macro before."""
    lines = [f"#define A0 {first}"]
    lines += [f"#define A{i} " + step.format(f"A{i - 1}") for i in range(1, levels)]
    return "\n".join(lines) + "\n"


def includes_that_double(folder):
    files = {f"i{i}": f'#include "/i{i + 1}"\n' * 2 for i in range(40)}
    return pack(folder, {"composite.fsh": HEAD + '#include "/i0"\n' + MAIN, **files, "i40": "x\n"})


def deep_includes(folder):
    files = {f"i{i}": f'#include "/i{i + 1}"\n' for i in range(400)}
    return pack(folder, {"composite.fsh": HEAD + '#include "/i0"\n' + MAIN, **files, "i400": ""})


def circle(folder):
    return pack(folder, {"composite.fsh": HEAD + '#include "/a"\n' + MAIN, "a": '#include "/b"\n',
                         "b": '#include "/a"\n'})


def empty_includes(folder):
    return pack(folder, {"composite.fsh": HEAD + '#include "/e"\n' * 60_000 + MAIN, "e": ""})


def one_file_in_many(folder):
    programs = {f"composite{i}.fsh": HEAD + '#include "/big"\n' + MAIN for i in range(1, 100)}
    return pack(folder, {**programs, "big": "float f{0}() {{ return 1.0; }}\n".format(0) +
                         "".join(f"float f{i}() {{ return {i}.0; }}\n" for i in range(1, 300))})


def stray_bracket(folder):
    use = HEAD + "void main() { gl_FragColor = vec4(fog); }\n"
    return pack(folder, {"composite.fsh": use, "lib.glsl": "] fog;\nfloat] fog = 1.0;\n"})


STRINGS = "#define S(x) #x\n#define E(x) S(x)\n"
PASTE = "#define P(a, b) P2(a, b)\n#define P2(a, b) a ## b\n"
LIMIT, LARGE, STAGE = "macro-expansion-limit", "text-too-large", "source-too-large"

# Made when they are run: (generator, id of a message that must be there or None).
BOMBS = {
    "stringify-nested": lambda: (fragment(STRINGS + nested("E(", 28, '"\\"') + "\n"), LIMIT),
    "stringify-repeated": lambda: (fragment("#define S(x) #x\n#define R(x)" + " x" * 2000 + "\nR(S(" +
                                    "a" * 60_000 + "))\n" + MAIN), LIMIT),
    "paste-doubling": lambda: (fragment(PASTE + doubling(40, "P({0}, {0})", "xxxxxxxx") + "A39\n"), LIMIT),
    "paste-chain": lambda: (fragment("#define C(x) x" + " ## x" * 20_000 + "\nC(abcdefgh)\n"), LIMIT),
    "laughs": lambda: (fragment(doubling(60, "{0} {0}", "x") + "A59\n"), LIMIT),
    "laughs-in-arguments": lambda: (fragment("#define D(x) x x\n" + nested("D(", 50, "x") + "\n"), LIMIT),
    "laughs-in-if": lambda: (fragment(doubling(60, "{0} + {0}", "1") + "#if A59\n#endif\n" + MAIN), LIMIT),
    "arguments-nested": lambda: (fragment("#define I(x) x\n" + nested("I(", 5000, "x") + "\n"), LIMIT),
    "arguments-many": lambda: (fragment("#define F(x) x\nF(" + "a," * N + "a)\n" + MAIN), "macro-arguments"),
    "parameters-many": lambda: (fragment("#define F(" + ",".join(f"p{i}" for i in range(N // 4)) +
                                 ") p0\n" + MAIN), None),
    "macro-chain": lambda: (fragment(doubling(20_000, "{0}", "x") + "A19999\n"), LIMIT),
    "macro-unterminated": lambda: (fragment("#define F(x) x\nF(" + "a " * N + "\n"), "macro-unterminated"),
    "macros-many": lambda: (fragment("".join(f"#define M{i} {i}\n" for i in range(50_000)) + MAIN), None),
    "macro-on-every-line": lambda: (fragment("#define W(x) " + "x " * 40 + "\n" + "W(a)\n" * 20_000), LIMIT),
    "tokens-on-a-line": lambda: (fragment("a " * 2_000_000), STAGE),
    "tokens-60-mb": lambda: (fragment("a " * 30_000_000), LARGE),
    "tokens-without-blanks": lambda: (fragment(";" * 4_000_000), STAGE),
    "continued-lines": lambda: (fragment("\\\n" * 99_000 + MAIN), None),
    "continued-lines-60-mb": lambda: (fragment("\\\n" * 30_000_000), LARGE),
    "comment-open": lambda: (fragment("/*" + "a" * 4_000_000), "comment-unclosed"),
    "comment-open-50-mb": lambda: (fragment("/*" + "a" * 50_000_000), LARGE),
    "comments-many": lambda: (fragment("/* a\n */ b /*\n*/ \\\n" * 20_000), None),
    "blank-lines": lambda: (fragment("\n" * 2_000_000), LARGE),
    "carriage-returns": lambda: (fragment("\r" * 2_000_000), LARGE),
    "includes-double": lambda: (includes_that_double, STAGE),
    "includes-deep": lambda: (deep_includes, "include-too-deep"),
    "includes-circle": lambda: (circle, "include-cycle"),
    "includes-empty": lambda: (empty_includes, STAGE),
    "includes-missing": lambda: (fragment("".join(f'#include "/none{i}"\n' for i in range(20_000))),
                         "include-missing"),
    "include-of-a-long-path": lambda: (fragment('#include "/' + "a/" * 50_000 + '"\n'), "include-missing"),
    "one-file-in-many-programs": lambda: (one_file_in_many, None),
    "if-nested": lambda: (fragment("#if 1\n" * 50_000 + MAIN), "conditional-unbalanced"),
    "endif-stray": lambda: (fragment("#endif\n" * 50_000 + MAIN), "conditional-unbalanced"),
    "elif-many": lambda: (fragment("#if 0\n" + "#elif 0\n" * 50_000 + "#endif\n" + MAIN), None),
    "if-parentheses": lambda: (fragment("#if " + "(" * N + "1" + ")" * N + "\n#endif\n" + MAIN),
                       "condition-malformed"),
    "if-operators": lambda: (fragment("#if 1" + " + 1" * N + "\n#endif\n" + MAIN), None),
    "if-ternaries": lambda: (fragment("#if " + "1 ? " * N + "1" + " : 0" * N + "\n#endif\n" + MAIN),
                     "condition-malformed"),
    "if-not": lambda: (fragment("#if " + "!" * N + "1\n#endif\n" + MAIN), "condition-malformed"),
    "directives-unknown": lambda: (fragment("#frob\n" * 50_000 + MAIN), "directive-unknown"),
    "errors-many": lambda: (fragment("#error no\n" * 50_000 + MAIN), "directive-error"),
    "error-long": lambda: (fragment("#error " + "a" * 2_000_000 + "\n" + MAIN), "directive-error"),
    "versions-many": lambda: (fragment("#version 330\n" * 50_000 + MAIN), "version-repeated"),
    "extensions-many": lambda: (fragment("#extension GL_A : enable\n" * 20_000 + MAIN), None),
    "extensions-malformed": lambda: (fragment("#extension\n" * 50_000 + MAIN), "directive-malformed"),
    "trailing-text": lambda: (fragment("#ifdef A b\n#endif c\n" * 25_000 + MAIN), "directive-trailing-text"),
    "identifier-long": lambda: (main_of("float " + "a" * 2_000_000 + ";"), None),
    "number-long": lambda: (main_of("float a = 1" + "0" * 1_000_000 + ".0;"), None),
    "strings-many": lambda: (main_of('"a";\n' * 5_000), "glsl-compile"),
    "names-unknown": lambda: (main_of("".join(f"u{i} = v{i};\n" for i in range(5_000))), "glsl-compile"),
    "bracket-stray": lambda: (stray_bracket, "glsl-compile"),
    "braces-open": lambda: (fragment("{" * N), None),
    "braces-closed": lambda: (fragment(MAIN + "}" * N), None),
    "parentheses-open": lambda: (main_of("float a = " + "(" * N), None),
    "utf16": lambda: (lambda folder: pack(folder, {"composite.fsh": FRAGMENT.encode("utf-16")}), "text-utf16"),
    "utf16-bare": lambda: (lambda folder: pack(folder, {"composite.fsh": FRAGMENT.encode("utf-16-be")}),
                   "text-utf16"),
    "zeros": lambda: (lambda folder: pack(folder, {"composite.fsh": b"\0" * 3_000_000}), "version-missing"),
    "ones": lambda: (lambda folder: pack(folder, {"composite.fsh": b"\xff" * 3_000_000}), None),
    "controls": lambda: (fragment("".join(chr(1 + i % 31) for i in range(50_000))), None),
    "drawbuffers-many": lambda: (fragment("/* DRAWBUFFERS:01 */\n" * 20_000 + MAIN), None),
    "rendertargets-long": lambda: (fragment("/* RENDERTARGETS: " + "1," * N + " */\n" + MAIN), None),
    "constants-many": lambda: (fragment("".join(f"const float c{i} = {i}.0;\n" for i in range(5_000)) + MAIN),
                       None),
    "formats-many": lambda: (fragment("/*\n" + "const int colortex0Format = RGBA99;\n" * 20_000 + "*/\n" + MAIN),
                     None),
    "uniforms-many": lambda: (fragment("".join(f"uniform float u{i};\n" for i in range(4_000)) + MAIN), None),
    "varyings-many": lambda: (fragment("".join(f"in vec4 v{i};\n" for i in range(4_000)) + MAIN), None),
    "functions-many": lambda: (fragment("".join(f"float f{i}() {{ return {i}.0; }}\n" for i in range(5_000)) +
                                MAIN), None),
    "statements-many": lambda: (main_of("gl_FragColor += vec4(0.1);\n" * 20_000), None),
    "terms-many": lambda: (main_of("float a = 1.0" + " + 1.0" * 20_000 + "; gl_FragColor = vec4(a);"), None),
    "terms-10-5": lambda: (main_of("float a = 1.0" + " + 1.0" * N + "; gl_FragColor = vec4(a);"), None),
    "cases-many": lambda: (main_of("switch (int(gl_FragCoord.x)) {\n" + "".join(
        f"case {i}: gl_FragColor = vec4({i}.0); break;\n" for i in range(5_000)) + "}"), "stage-too-large"),
    "else-if-chain": lambda: (main_of("".join(
        f"if (gl_FragCoord.x < {i}.0) gl_FragColor = vec4({i}.0); else\n" for i in range(2_000)) + ";"),
                      None),
    "blocks-nested": lambda: (main_of("{" * 3_000 + "}" * 3_000), None),
    "structs-nested": lambda: (fragment("struct S0 { float a; };\n" + "".join(
        f"struct S{i} {{ S{i - 1} a, b; }};\n" for i in range(1, 30)) + "uniform S29 s;\n" + MAIN), None),
    "array-constant": lambda: (fragment("const float a[10000] = float[](" + "1.0," * 9_999 + "1.0);\n" + MAIN),
                       None),
    "array-2-31": lambda: (fragment("uniform float a[2147483647];\n"
                            "void main() { gl_FragColor = vec4(a[3]); }\n"), None),
}

# Those that take seconds to write or to read.
HEAVY = {"tokens-60-mb", "continued-lines-60-mb", "comment-open-50-mb"}
