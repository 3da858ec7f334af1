"""The table of command lines: what is run on what, and what must come of it.

Every command of a case runs in a fresh folder that holds `files`. `errors` are patterns, one for
each line with "error: " on standard error, no more and no fewer; `creates` are the files that the
command must leave, no more and no fewer: a failing command leaves none.
"""
import io
import struct
import zipfile
import zlib
from dataclasses import dataclass, field


@dataclass
class Case:
    name: str
    commands: list
    status: int
    files: dict = field(default_factory=dict)
    errors: list = field(default_factory=list)
    stderr: list = field(default_factory=list)
    stdout: list = field(default_factory=list)
    creates: list = field(default_factory=list)
    environment: dict = field(default_factory=dict)

    @property
    def label(self):
        """render opens a GL context."""
        return "gl" if any(command.startswith("render") for command in self.commands) else "cpu"


VERSION = "#version 330 compatibility\n"
FINAL = VERSION + """in vec2 texcoord;
uniform sampler2D colortex0;
void main() { gl_FragColor = texture2D(colortex0, texcoord); }
"""
FINAL_VERTEX = VERSION + """out vec2 texcoord;
void main() { gl_Position = ftransform(); texcoord = gl_MultiTexCoord0.st; }
"""
PACK = {"pack/shaders/final.vsh": FINAL_VERTEX, "pack/shaders/final.fsh": FINAL}
WITH_MODE = FINAL.replace("void", "#define MODE 1 // [0 1 2] a tooltip\n"
                        "#if MODE == 2\n#endif\nvoid")
CORNELL = "{source}/worlds/cornell"
# Small and short: the cases are about messages, not about pictures.
FLOOD = (f"render {{source}}/shaderpack {CORNELL} -o out.png --size 16x9 --json "
         "--set GI_METHOD=FLOODFILL FLOODFILL_INTERVAL=1")
RENDER = f"render pack {CORNELL} -o out.png --size 32x32 --frames 1"
ON_PACK = ["validate pack", RENDER]


def pack(files):
    """A working pack with some files of `shaders` added or replaced."""
    return {**PACK, **{f"pack/shaders/{name}": text for name, text in files.items()}}


def zipped(files):
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in files.items():
            archive.writestr(zipfile.ZipInfo(name, (2000, 1, 1, 0, 0, 0)), text)
    return buffer.getvalue()


def png(width, height, color):
    """A PNG of one colour (red, green, blue), 8 bits a channel."""
    def chunk(kind, data):
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))
    rows = (b"\0" + bytes(color) * width) * height
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">2I5B", width, height, 8, 2, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


USAGE = [
    Case("no_command", [""], 2, errors=["orris: error: A subcommand is required"]),
    Case("unknown_command", ["paint pack"], 2,
         errors=["^orris: error: there is no command 'paint'$"], stderr=["hint: orris --help"]),
    Case("misspelt_command", ["rendr pack world"], 2,
         errors=["^orris: error: there is no command 'rendr'$"],
         stderr=[r"^  hint: did you mean render\?$"]),
    Case("unknown_flag", ["validate x --colour", "world x --size 1x1", "options x --frames 2",
                          "compare a b --sharp", f"{RENDER} --colour"],
         2, errors=[r"orris \w+: error: The following argument"]),
    Case("version", ["--version"], 0, stdout=[r"^orris \d+\.\d+\.\d+$"]),
    Case("help", ["--help", "validate --help", "render --help"], 0, stdout=["Usage: orris"]),
    Case("render_flag_without_its_value", [f"render pack {CORNELL} -o out.png --timings --json"], 2, PACK,
         ["--timings: expected a value before --json"]),
    Case("wrong_size", [f"render pack {CORNELL} -o out.png --size {size}"
                        for size in ("0x32", "32x0", "-1x5", "32", "axb", "20000x2", "16384x16384",
                                     "99999999999x1", "1x1x1")],
         2, PACK, [r"--size: expected WIDTHxHEIGHT, each 1 to 16384 and at most \d+ pixels"]),
    Case("set_without_value", [f"{RENDER} --set SHADOWS"], 2, PACK,
         ["--set: expected NAME=VALUE"]),
]

# Far outside of the array, where nothing of the process is mapped: the last and the first element are meant.
FAR_INDICES = """#version 430
layout(local_size_x = 64) in;
const ivec3 workGroups = ivec3(1, 1, 1);
layout(rgba16f) uniform image2D colorimg0;
shared uint s[64];
void main() {
  uint i = gl_LocalInvocationIndex;
  s[i] = 7u;
  barrier();
  s[i * 65536u + 1000000u] = 7u;
  barrier();
  float seen = float(s[int(i) - 100000]) / 14.0;
  imageStore(colorimg0, ivec2(i % 8u, i / 8u), vec4(seen, seen, seen, 1.0));
}
"""

TOO_MANY_GROUPS = """#version 430
layout(local_size_x = 8, local_size_y = 8) in;
const vec2 workGroupsRender = vec2(1000000.0, 1000000.0);
layout(rgba16f) uniform image2D colorimg0;
void main() { imageStore(colorimg0, ivec2(gl_GlobalInvocationID.xy), vec4(1.0)); }
"""

# Behind a name that no macro knows, so that only a driver is asked.
LACKED = VERSION + """#extension GL_NONE_such : enable
void main() { gl_FragData[0] = noSuch(); }
"""

PACKS = [
    Case("versions_that_never_were", ["validate pack --iris 1.11 --game 1.20.1",
                                      f"{RENDER} --iris 1.11 --game 1.20.1",
                                      "options pack --iris 1.11.2 --game 1.20.1"], 2, PACK,
         errors=[r"--iris: Iris 1\.11.* is for Minecraft 26\.1 to 26\.2, not 1\.20\.1"]),
    Case("unknown_version", ["validate pack --iris 3.0", "validate pack --iris 1.8..3.0"], 2, PACK,
         errors=[r"--iris: Iris 3\.0 is unknown; known are 1\.6 to "]),
    Case("version_range_turned_round", ["validate pack --iris 1.11..1.8"], 2, PACK,
         errors=[r"--iris: the range ends before it begins"]),
    Case("name_of_a_newer_iris", ["validate pack --iris 1.8 --game 1.21.5"], 0, pack({
        "composite.fsh": VERSION + "uniform int seaLevel;\n"
                                   "void main() { gl_FragData[0] = vec4(seaLevel); }\n"}),
         stderr=[r"^/composite\.fsh:2:13: warning: 'seaLevel' is there since Iris 1\.9\.5; with Iris "
                 r"1\.8\.12 and Minecraft 1\.21\.5 it stays 0 \[version-newer\]",
                 r"hint: guard it with #if IRIS_VERSION >= 10905"]),
    Case("oldest_version_that_a_pack_states", ["validate pack"], 1, pack({
        "shaders.properties": "orris.minimum.iris = 1.7\n",
        "composite.fsh": VERSION + "void main() {\n#if IRIS_VERSION >= 10800\n"
                                   "  gl_FragData[0] = vec4(1.0);\n#else\n"
                                   "  gl_FragData[0] = vec4(old);\n#endif\n}\n"}),
         [r"^/composite\.fsh:6:\d+: error: .*old"],
         [r"first met with Iris 1\.7 and Minecraft 1\.20\.1"]),
    Case("range_of_versions", ["validate pack --iris 1.7..1.11 --strict"], 0, pack({
        "shaders.properties": "orris.minimum.iris = 1.7\n",
        "composite.fsh": VERSION + "#if MAX_COLOR_BUFFERS >= 32\nuniform sampler2D colortex20;\n"
                                   "#endif\nvoid main() { gl_FragData[0] = vec4(1.0); }\n"}),
         stdout=[r"2/2 programs"]),
    Case("gl_error_leaves_no_picture", [f"render pack {CORNELL} -o out.png --size 8x8 --frames 1"],
         3, pack({"composite.csh": TOO_MANY_GROUPS}),
         [r"GL_INVALID_VALUE in glDispatchCompute.* \[gl-error\]"]),
    Case("shared_array_is_bounded", [f"render pack {CORNELL} -o out.png --size 8x8 --frames 1"], 0,
         pack({"composite.csh": FAR_INDICES}), creates=["out.png"]),
    Case("context_of_either_profile", [f"{RENDER} --context {profile}"
                                       for profile in ("core", "compatibility", "auto")], 0, PACK,
         creates=["out.png"]),
    Case("context_unknown", [f"{RENDER} --context es"], 2, PACK,
         ['--context: expected auto, compatibility or core, got "es"']),
    Case("driver_lacks_an_extension", [RENDER, f"{RENDER} --context core"], 1,
         pack({"composite.fsh": LACKED}),
         [r"a program is left out of the picture, which this driver cannot run: composite "
          r"\[program-left-out\]"], [r"hint: with --allow-missing"], creates=["out.png"]),
    Case("driver_may_lack_an_extension", [f"{RENDER} --allow-missing"], 0,
         pack({"composite.fsh": LACKED}), stderr=[r"warning: a program is left out of the picture"],
         creates=["out.png"]),
    Case("missing_include", ON_PACK, 1, pack({
        "final.fsh": VERSION + '#include "/lib/none.glsl"\nvoid main() { }\n'}),
        [r"^/final\.fsh:2:\d+: error: .*none\.glsl"]),
    Case("folder_of_packs", ["validate .", "options .",
                                    f"render . {CORNELL} -o out.png"], 2,
         {"a/shaders/final.fsh": FINAL, "b/deep/shaders/final.fsh": FINAL,
          "c.zip": zipped({"shaders/final.fsh": FINAL}), "d.zip": zipped({"pack.mcmeta": "{}"}),
          "world/none.txt": ""},
         [r"error: no shader pack itself, but it holds 3"],
         stderr=[r"hint: give one of \./a, \./b/deep, \./c\.zip; orris validate --recursive"]),
    Case("folder_around_a_pack", ["validate around", "options around"], 2,
         {"around/a/shaders/final.fsh": FINAL}, [r"no shader pack itself, but it holds one"],
         stderr=[r"hint: give around/a"]),
    Case("recursive", ["validate --recursive ."], 1,
         {"a/shaders/final.fsh": FINAL, "a/old/shaders/final.fsh": FINAL,
          "b/deep/shaders/final.fsh": "broken", "c.zip": zipped({"shaders/final.fsh": FINAL}),
          ".git/e/shaders/final.fsh": FINAL},
         [r"no active #version"],
         stdout=[r"(?s)/a: 1/1 programs.*/a/old: 1/1 .*/deep: 0/1 programs.*/c\.zip: 1/1 "]),
    Case("recursive_without_a_pack", ["validate --recursive empty"], 2, {"empty/a/b.txt": ""},
         [r"the folder has no folder named shaders"]),
    Case("include_cycle", ON_PACK, 1, pack({
        "final.fsh": VERSION + '#include "/lib/a.glsl"\nvoid main() { }\n',
        "lib/a.glsl": '#include "b.glsl"\n',
        "lib/b.glsl": '\n#include "/lib/a.glsl"\n'}),
        [r"^/lib/[ab]\.glsl:[12]:\d+: error: .*cycle"]),
    Case("include_escape", ON_PACK, 1, {**pack({
        "final.fsh": VERSION + '#include "../../secret.glsl"\nvoid main() { }\n'}),
        "secret.glsl": "float secret = 1.0;\n"},
        [r"^/final\.fsh:2:\d+: error: "]),
    Case("error_three_includes_deep", ON_PACK, 1, pack({
        "final.fsh": VERSION + '#include "/lib/one.glsl"\nvoid main() { gl_FragColor = one(); }\n',
        "lib/one.glsl": '#include "two.glsl"\nvec4 one() { return two(); }\n',
        "lib/two.glsl": '\n#include "/lib/three.glsl"\nvec4 two() { return three(); }\n',
        "lib/three.glsl": "vec4 three() {\n  return vec4(undeclared);\n}\n"}),
        [r"^/lib/three\.glsl:2:\d+: error: .*undeclared"],
        [r"included from /lib/two\.glsl:2", r"included from /lib/one\.glsl:1",
         r"included from /final\.fsh:2", r"return vec4\(undeclared\);", r"^ +\^"]),
    Case("too_many_render_targets", ON_PACK, 1, pack({
        "composite.fsh": VERSION + "/* RENDERTARGETS: 0,99 */\n"
                                   "void main() { gl_FragData[0] = vec4(1.0); }\n"}),
        [r"^/composite\.fsh:2:\d+: error: .*99"]),
    Case("unsupported_format", ["validate pack"], 0, pack({
        "composite.fsh": VERSION + "/*\nconst int colortex1Format = RGBA7;\n*/\n"
                                   "void main() { gl_FragData[0] = vec4(1.0); }\n"}),
        stderr=[r"/composite\.fsh:3:\d+: warning: .*RGBA7"]),
    Case("everything_broken_at_once", ["validate pack"], 1, pack({
        "composite.vsh": VERSION + '#include "/lib/none.glsl"\nvoid main() {}\n',
        "composite.fsh": VERSION + "/* RENDERTARGETS: 0,99 */\n#ifdef X\nvoid main() {\n",
        "composite1.fsh": VERSION + "void main() { gl_FragData[0] = vec4(" + "(" * 100000 + "1.0"
                                    + ")" * 100000 + "); }\n",
        "final.fsh": VERSION + "in vec2 uv;\nvoid main() { gl_FragData[0] = vec4(uv.xyq, 1.0); }\n",
        "shaders.properties": "screen = NOPE\nblend.composite = SRC_ALPA ONE ONE ONE\n",
        "block.properties": "block.1=stone\nblock.2=stone\n"}),
        [r"^/composite\.fsh:2:1: error: buffer 99 does not exist",
         r"^/composite\.vsh:2:1: error: no such file: /lib/none\.glsl",
         r"^/composite1\.fsh:2: error: .*memory exhausted",
         r"^/final\.fsh:3:\d+: error: 'xyq'",
         r"^/shaders\.properties:2:19: error: SRC_ALPA is no blend factor"],
        stderr=[r"(?s)/block\.properties:2:9: warning: .*/composite\.fsh:3:1: warning: .*"
                r"/final\.fsh:2:9: warning: .*/shaders\.properties:1:10: warning: "]),
    Case("error_of_one_profile", ["validate pack --profiles all"], 1, pack({
        "final.fsh": FINAL.replace("void", "#define MODE 1 // [0 1 2]\n#if MODE == 2\nbroken\n"
                                           "#endif\nvoid"),
        "shaders.properties": "profile.LOW = MODE=1\nprofile.HIGH = MODE=2\n"}),
        [r"^/final\.fsh:[67]"], [r"note: first met with profile HIGH"]),
    Case("unknown_option", [f"{command} --set NO_SUCH_OPTION=1"
                            for command in (RENDER, "validate pack", "options pack")],
         2, PACK, ["NO_SUCH_OPTION"]),
    Case("value_outside_its_list", [f"{RENDER} --set MODE=7", "validate pack --set MODE=7"], 2,
         pack({"final.fsh": WITH_MODE}), ["MODE.*7|7.*MODE"]),
    Case("unknown_profile", [f"{RENDER} --profile ULTRA", "validate pack --profile ULTRA"], 2, PACK,
         ["ULTRA"]),
    Case("no_such_pack", ["validate nothing", f"render nothing {CORNELL} -o out.png",
                          "options nothing"], 2, errors=["nothing"]),
    Case("truncated_zip", ["validate pack.zip", f"render pack.zip {CORNELL} -o out.png",
                           "options pack.zip"], 2,
         {"pack.zip": zipped(PACK)[:-40]}, [r"pack\.zip"]),
    Case("good_folder_and_zip", ["validate pack pack.zip"], 0,
         {**PACK, "pack.zip": zipped(PACK)},
         stdout=[r"^pack: 1/1 programs$", r"^pack\.zip: 1/1 programs$"]),
    Case("validate_json", ["validate pack --json", "validate pack --format json"], 0, PACK,
         stdout=[r'"programs": \[\n\s+"/final"\n']),
    Case("options_graph", ["options pack --graph g.json"], 0, PACK,
         creates=["g.json"]),
    Case("options_graph_dot", ["options pack --graph g.dot"], 0, PACK, creates=["g.dot"]),
    Case("options_graph_table", ["options pack --graph -"], 0, PACK,
         stdout=[r"^# pack, /$", r"^\| colortex0 \| RGBA   \| window "]),
    Case("options_graph_form", ["options pack --graph g.txt"], 2, PACK,
         errors=["g.txt: error: g.txt is no form of a graph"]),
    Case("options_graph_place", ["options pack --graph none/g.md"], 2, PACK, errors=["none/g.md"]),
    Case("options_graph_without_graphviz", ["options pack --graph g.svg"], 3, PACK,
         errors=["error: the program dot of Graphviz is not installed"],
         stderr=["install graphviz, or write .dot"], environment={"PATH": "/nowhere"}),
    Case("validate_judges_what_iris_sends", ["validate pack", "validate pack --target minimum",
                                             "validate pack --target nvidia"], 1,
         pack({"final.fsh": FINAL.replace("{ gl", "{ uint a = 1; gl")}),
         [r"^/final\.fsh:4:\d+: error: .*cannot convert"],
         stderr=[r"write 1u or uint\(x\)$", "NVIDIA's driver lets it pass"]),
    Case("validate_optifine_takes_what_its_context_takes", ["validate pack --target optifine"], 0,
         {path: text.replace(VERSION, "").replace("in vec2", "varying vec2")
                    .replace("out vec2", "varying vec2").replace("{ gl_F", "{ uint a = 1; gl_F")
          for path, text in PACK.items()}, stdout=["^pack: 1/1 programs$"]),
    Case("validate_reads_functions_that_nothing_calls", ["validate pack"], 1,
         pack({"final.fsh": FINAL + "void f() { int a = ; }\n"}),
         [r"^/final\.fsh:5:20: error: syntax error: expected an expression before ';'"],
         stderr=["nothing calls the function"]),
    Case("validate_warns_of_functions_that_would_not_compile", ["validate pack"], 0,
         pack({"final.fsh": FINAL + "float f() { return missing; }\n"}),
         stderr=[r"^/final\.fsh:5:20: warning: not called, so that Iris leaves the function out"]),
    Case("validate_usage", ["validate pack --format pdf", "validate pack --report sarif",
                            "validate pack --report pdf=x", "validate pack --ignore no-such-check",
                            "validate pack --severity glsl-compile=bad", "validate pack --stage a",
                            "validate pack --severity glsl-compile", "validate pack --config none"],
         2, PACK, ["orris validate: error: "]),
    Case("validate_names_the_nearest_check", ["validate pack --ignore glsl-complie"], 2, PACK,
         ["there is no check \"glsl-complie\"; did you mean glsl-compile\\?"]),
    Case("validate_report_files", ["validate pack -o a.json --format json --report junit=b.xml,sarif=c"],
         0, PACK, stdout=[r"^pack: 1/1 programs$"], creates=["a.json", "b.xml", "c"]),
    Case("validate_report_unwritable", ["validate pack -o none/a.json",
                                        "validate pack --write-baseline none/a"], 2, PACK,
         ["cannot be written"]),
    Case("validate_strict", ["validate pack --strict", "validate pack --strict --quiet"], 1,
         pack({"shaders.properties": "screen = NO_SUCH\n"}),
         stderr=[r"^/shaders.properties:1:10: warning: .* \[screen-option\]$"]),
    Case("validate_severity", ["validate pack --severity screen-option=error"], 1,
         pack({"shaders.properties": "screen = NO_SUCH\n"}), [r"\[screen-option\]$"]),
    Case("validate_ignore", ["validate pack --strict --ignore screen-option"], 0,
         pack({"shaders.properties": "screen = NO_SUCH\n"}), stdout=[r"^  1 ignored$"]),
    Case("validate_bad_baseline", ["validate pack --baseline shaders.txt"], 2,
         {**PACK, "shaders.txt": "hello\n"}, [r"^shaders\.txt:1: error: a baseline starts with"]),
    Case("explain_log_unreadable", ["validate pack --explain-log none",
                                    "validate pack --explain-log log --patched-shaders none"], 2,
         {**PACK, "log": ""}, ["none: error: cannot be read"]),
    Case("explain_log", ["validate pack --explain-log log"], 1,
         {**PACK, "log": "final.fsh: final.fsh: 0(9) : error C1503: undefined variable \"texcoord\"\n"},
         [r"^/final\.fsh:2:9: error: undefined variable \"texcoord\" \[log-message\]$"],
         stderr=["note: place is a guess: texcoord stands in 2 lines"]),
    Case("options_json", ["options pack --json"], 0, pack({"final.fsh": WITH_MODE}),
         stdout=[r'"name": "MODE"', r'"value": "1"', r'"line": 4', r'"final"']),
]

# One program, and one that only the file lib/all.glsl breaks.
MAIN = "void main() { gl_FragColor = vec4(shade() * EXPOSURE); }\n"
SHADE = "float shade() {\n  return 1.0;\n}\n"


def two_programs(library, more=""):
    """Both include the library; /composite1.fsh has a mistake of its own where `more` says so."""
    include = VERSION + '#include "/lib/all.glsl"\n'
    return pack({"composite.fsh": include + MAIN, "deferred.fsh": include + MAIN,
                 "composite1.fsh": VERSION + f"void main() {{ {more}gl_FragColor = vec4(1.0); }}\n",
                 "lib/all.glsl": library})


MORE = "float a = lost; "
OWN = r"^/composite1\.fsh:2:\d+: error: 'lost' : undeclared identifier \[glsl-compile\]$"
FOLLOW = [r"^  note: \d+ findings? follows? from this one \(--verbose lists them\)$"]
ONCE = [
    Case("lost_endif", ["validate pack"], 1,
         two_programs("#define EXPOSURE 1.0\n#ifdef FAST\nfloat fast() {\n  return 2.0;\n}\n\n" + SHADE, MORE),
         [r"^/lib/all\.glsl:5:\d+: error: expected #endif after this line: nothing closes the #ifdef in "
          r"line 2 \[conditional-unbalanced\]$", OWN],
         stderr=[r"\A/lib/all\.glsl:5:", r"^  note: /lib/all\.glsl:2:1: the #ifdef without #endif$", *FOLLOW]),
    Case("outputs_without_their_list", ["validate pack"], 1,
         pack({"gbuffers_terrain.fsh": VERSION + "/* RENDERTARGETS: 0,x */\nvoid main() { gl_FragData[0] = vec4(1.0); "
               "gl_FragData[1] = vec4(1.0); gl_FragData[2] = vec4(1.0); }\n"}),
         [r"is no buffer index; Iris refuses the whole pack \[render-target-syntax\]$"], stderr=FOLLOW,
         stdout=["^  1 error$"]),
    Case("a_version_lost_in_a_shared_file", ["validate pack"], 1,
         pack({**{f"{name}.{stage}": '#include "/version.glsl"\n' + text.partition("\n")[2]
                  for name in ("composite", "final") for stage, text in (("vsh", FINAL_VERTEX), ("fsh", FINAL))},
               "version.glsl": "// #version 330\n"}),
         [r"^/composite\.[vf]sh:1: error: no active #version"],
         stderr=["note: 3 findings follow", r"note: /version\.glsl:1:1: the first file that all of these programs include"],
         stdout=["^pack: 0/2 programs$"]),
    Case("a_version_that_glsl_does_not_have", ["validate pack", "validate pack --target optifine"], 1,
         pack({"final.fsh": "#version 4096\nvoid main() { gl_FragData[0] = vec4(missing); }\n"}),
         [r"^/final\.fsh:1:1: error: GLSL has no version 4096; Iris refuses the whole pack \[version-malformed\]$"], stderr=[r"hint: write '#version 330 compatibility'"],
         stdout=["^pack: 0/1 programs$", "^  1 error$"]),
    Case("a_second_version", ["validate pack"], 1,
         pack({"final.fsh": VERSION + VERSION + "void main() { gl_FragData[0] = vec4(1.0); }\n"}),
         [r"^/final\.fsh:2:1: error: a second active #version; exactly one is allowed; Iris refuses the whole pack \[version-repeated\]$"],
         stdout=["^pack: 0/1 programs$", "^  1 error$"]),
    Case("a_second_version_rendered", [RENDER], 1,
         pack({"final.fsh": VERSION + VERSION + "void main() { gl_FragData[0] = vec4(1.0); }\n"}),
         [r"^/final\.fsh:2:1: error: a second active #version; .*; Iris refuses the whole pack \[version-repeated\]$"]),
    Case("an_extension_without_its_end", ["validate pack"], 1,
         pack({"final.fsh": VERSION + "#extension GL_ARB_gpu_shader5 enable\nvoid main() { gl_FragData[0] = vec4(1.0); }\n"}),
         [r"^/final\.fsh:2:1: error: expected '#extension NAME : enable', .*; Iris refuses the whole pack \[directive-malformed\]$"],
         stdout=["^pack: 0/1 programs$", "^  1 error$"]),
    Case("an_extension_without_a_behaviour", ["validate pack"], 1,
         pack({"final.fsh": VERSION + "#extension GL_ARB_gpu_shader5\nvoid main() { gl_FragData[0] = vec4(1.0); }\n"}),
         [r"^/final\.fsh:2:1: error: expected '#extension NAME : enable', .*; Iris refuses the program \[directive-malformed\]$"],
         stdout=["^pack: 0/1 programs$", "^  1 error$"]),
    Case("a_call_of_a_macro_without_its_end", ["validate pack"], 1,
         two_programs("#define EXPOSURE 1.0\n#define half_of(x) ((x) * 0.5)\nfloat dim(float a) {\n  return half_of((a + 1.0);\n}\n"
                      + SHADE, MORE),
         [r"^/lib/all\.glsl:4:\d+: error: .* \[macro-unterminated\]$", OWN],
         stderr=[r"\A/lib/all\.glsl:4:", *FOLLOW]),
    Case("a_misspelt_define", ["validate pack"], 1,
         two_programs("#defien EXPOSURE 1.0\n" + SHADE, MORE),
         [r"^/lib/all\.glsl:1:1: error: unknown preprocessor directive '#defien' \[directive-unknown\]$", OWN],
         stderr=[r"\A/lib/all\.glsl:1:1: ", *FOLLOW, "hint: did you mean #define\\?"]),
    Case("a_misspelt_ifdef", ["validate pack"], 1,
         two_programs("#ifndef LIB\n#define LIB\n#define EXPOSURE 1.0\n#ifdfe FAST\nfloat fast() {\n  return 2.0;\n}\n"
                      "#endif\n\n" + SHADE + "#endif\n", MORE),
         [OWN], stderr=[r"^/lib/all\.glsl:4:1: warning: unknown preprocessor directive '#ifdfe'",
                        *FOLLOW, "hint: did you mean #ifdef\\?"]),
    Case("endif_too_many", ["validate pack"], 1,
         two_programs("#ifndef LIB\n#define LIB\n#define EXPOSURE 1.0\n\n#ifdef FAST\nfloat fast() {\n#endif\n"
                      "  return 2.0;\n}\n#endif\n\n" + SHADE + "#endif\n", MORE),
         [r"^/lib/all\.glsl:(7|10):1: error: #endif without #if \[conditional-unbalanced\]$", OWN],
         stderr=[r"\A/lib/all\.glsl:(7|10):1: ", *FOLLOW]),
    Case("comment_for_the_line", ["validate pack"], 1,
         two_programs("#define EXPOSURE 1.0 /* [0.5 1.0]\n#define OTHER 1\n" + SHADE
                      + "/* RENDERTARGETS: 0 */\nfloat more;\n", MORE),
         [r"^/lib/all\.glsl:1:22: error: this comment swallows code: .* in line 6 \[comment-nested\]$", OWN],
         stderr=[r"\A/lib/all\.glsl:1:22", *FOLLOW, "hint: write // for a comment of one line"]),
    Case("comment_without_an_end_in_its_file", ["validate pack"], 1,
         two_programs("#define EXPOSURE 1.0 /* [0.5 1.0]\n" + SHADE, MORE),
         [r"^/lib/all\.glsl:1:22: error: (this comment swallows code: it has no \"\*/\" in this file "
          r"\[comment-nested\]|block comment is not closed.*)$", OWN],
         stderr=[r"\A/lib/all\.glsl:1:22", *FOLLOW]),
    Case("a_varying_that_a_shared_stage_lacks", ["validate pack"], 1,
         {**two_programs(""), **pack({
             **{f"{name}.vsh": VERSION + "out vec3 tint;\nvoid main() { tint = vec3(1.0); gl_Position = ftransform(); }\n"
                for name in ("composite", "deferred")},
             **{f"{name}.fsh": VERSION + '#include "/lib/all.glsl"\n' for name in ("composite", "deferred")},
             "lib/all.glsl": "void main() { gl_FragColor = vec4(tint, 1.0); }\n"})},
         [r"^/lib/all\.glsl:1:35: error: 'tint' : undeclared identifier \[glsl-compile\]$"]),
    Case("what_a_missing_file_would_declare", ["validate pack"], 1,
         {**two_programs("#define EXPOSURE 1.0 // [0.5 1.0]\n" + SHADE),
          "pack/shaders/composite.fsh": VERSION + '#include "/lib/al.glsl"\n' + MAIN,
          "pack/shaders/deferred.fsh": VERSION + '#include "/lib/al.glsl"\n' + MAIN,
          "pack/shaders/shaders.properties": "screen=EXPOSURE\n"},
         [rf"^/{name}\.fsh:2:1: error: no such file: /lib/al\.glsl \[include-missing\]$"
          for name in ("composite", "deferred")],
         stderr=FOLLOW, stdout=["^  2 errors$"]),
    Case("a_path_out_of_the_pack_whose_file_is_known_is_read", ["validate pack"], 1,
         pack({"final.fsh": FINAL.replace("\n", '\n#include "/../shaders/lib/settings.glsl"\n', 1),
               "lib/settings.glsl": "#define MODE 1 // [0 1 2]\n#if MODE == 2\n#endif\n",
               "shaders.properties": "screen=MODE\nsliders=MODE\n", "lang/en_us.lang": "option.MODE=m\n"}),
         [r"^/final\.fsh:2:\d+: error: \"/\.\./shaders/lib/settings\.glsl\" leads out of the shaders folder"],
         stderr=["hint: write \"/lib/settings\\.glsl\""], stdout=["^  1 error$"]),
    Case("one_advice_for_several_lines_is_given_once", ["validate pack"], 1,
         pack({"final.vsh": "#version 330 compatibility\nout vec2 a, b;\n"
                            "void main() { a = b = vec2(0.0); gl_Position = ftransform(); }\n",
               "final.fsh": "#version 420\nvarying vec2 a;\nvarying vec2 b;\nlayout(location = 0) out vec4 color;\n"
                            "void main() { color = vec4(a, b); }\n"}),
         [r"^/final\.fsh:2:\d+: error: 'varying' : no longer supported"],
         stderr=FOLLOW, stdout=["^  1 error$"]),
    Case("options_of_a_file_that_is_not_read", ["validate pack"], 1,
         pack({"final.fsh": FINAL.replace("\n", '\n#include "/lib/main.glsl" all\n', 1),
               "lib/main.glsl": "#define STEPS 1 // [1 2]\nfloat f() { return float(STEPS); }\n"
                                "const float sunPathRotation = -40.0; // [-40.0 0.0]\n",
               "shaders.properties": "screen=STEPS sunPathRotation GONE_LONG_AGO\n",
               "lang/en_us.lang": "option.STEPS=m\n"}),
         [r"^/final\.fsh:2:\d+: error: expected one path in quotes"],
         stderr=[r"no option GONE_LONG_AGO \[screen-option\]", *FOLLOW],
         stdout=["^  1 error, 1 warning$"]),
    Case("a_comment_behind_an_include_hides_no_other_mistake", ["validate pack"], 1,
         pack({"final.fsh": FINAL.replace("\n", '\n#include "/lib/main.glsl" // all\n', 1),
               "lib/main.glsl": "float f() { return undeclaredName; }\nfloat g = f();\n"}),
         [r"^/final\.fsh:2:\d+: error: expected one path in quotes",
          r"^/lib/main\.glsl:1:\d+: error: 'undeclaredName' : undeclared"]),
    Case("a_texture_beside_the_folder_that_is_given", ["validate pack/shaders"], 0,
         {**pack({"shaders.properties": "customTexture.noise=../assets/a.png\n"}), "pack/assets/a.png": "a"},
         stderr=[r"no such file: /\.\./assets/a\.png \[texture-missing\]", "when the folder around it is given"]),
    Case("what_a_misspelt_screen_takes_along", ["validate pack"], 0,
         pack({"final.fsh": WITH_MODE,
               "shaders.properties": "screen=[LIGHTS] [LIGHT]\nsceren.LIGHTS=MODE\nscreen.LIGHT=MODE\n",
               "lang/en_us.lang": "option.MODE=m\nscreen.LIGHTS=l\nscreen.LIGHT=l\n"}),
         stderr=[r"^/shaders\.properties:2:1: warning: unknown key sceren\.LIGHTS", *FOLLOW],
         stdout=["^  1 warning$"]),
    Case("what_another_repair_ends_is_no_consequence", ["validate pack"], 1,
         pack({"final.fsh": WITH_MODE.replace("void main() {", "void main() { {"),
               "shaders.properties": "screen=[LIGHTS]\nsceren.LIGHTS=MODE\n",
               "lang/en_us.lang": "option.MODE=m\nscreen.LIGHTS=l\n"}),
         [r"^/final\.fsh:\d+:\d+: error: expected '}' .* \[brace-unbalanced\]$"],
         stderr=[r"^/shaders\.properties:2:1: warning: unknown key sceren\.LIGHTS"],
         stdout=["^  1 error, 1 warning$"]),
    Case("what_a_dropped_uniform_takes_along", ["validate pack"], 0,
         pack({"shaders.properties": "variable.float.a=clmap(1.0)\nvariable.float.b=a\nuniform.float.c=b\n"}),
         stderr=[r"^/shaders\.properties:1:\d+: warning: custom uniform a is dropped",
                 "note: 2 findings follow"], stdout=["^  1 warning$"]),
    Case("what_does_not_compile_with_a_uniform_of_another_type", ["validate pack"], 1,
         pack({"final.fsh": FINAL.replace("in vec2 texcoord;", "in vec2 texcoord; uniform vec2 cameraPosition; float a;")
               .replace("void main() {", "void main() { vec3 p = cameraPosition;\n")}),
         [r"^/final\.fsh:2:\d+: error: 'cameraPosition' is declared as vec2, the host gives vec3 \[uniform-type\]"],
         stderr=FOLLOW),
    Case("a_varying_misspelt_where_it_is_read", ["validate pack"], 1,
         pack({"final.fsh": FINAL.replace("in vec2 texcoord;", "in vec2 texcorod;")
               .replace("texcoord)", "texcoord + texcoord)")}),
         [r"^/final\.fsh:2:9: error: nothing uses 'texcorod', and 'texcoord' is used "]),
    Case("a_block_that_the_stage_before_lacks", ["validate pack"], 1,
         pack({"final.fsh": VERSION + "in Lost { vec2 a; } lost;\nvoid main() { gl_FragColor = lost.a.xyxy; }\n"}),
         [r"^/final\.fsh:2:4: error: 'Lost' is read here, and the vertex stage does not declare it \[varying-missing\]$"],
         stdout=[r"^pack: 0/1 programs$", "failed: /final"]),
    Case("comment_never_closed", ["validate pack"], 1,
         two_programs("#define EXPOSURE 1.0\n/* what it does\n" + SHADE, MORE),
         [r"^/lib/all\.glsl:2:1: error: block comment is not closed: .* \[comment-unclosed\]$", OWN],
         stderr=[r"\A/lib/all\.glsl:2:1", *FOLLOW]),
    Case("a_comment_in_a_comment_that_harms_nobody", ["validate pack"], 0,
         two_programs("#define EXPOSURE 1.0\n/*\nfloat old() { return 1.0; /* why */\n" + SHADE), stdout=[r"^pack: 4/4 programs$"]),
    Case("lost_brace", ["validate pack"], 1,
         two_programs("#define EXPOSURE 1.0\nfloat other() {\n  return 2.0;\n\n" + SHADE, MORE),
         [r"^/lib/all\.glsl:[34]:\d+: error: expected '}' after ';': .* \[brace-unbalanced\]$", OWN]),
    Case("brace_too_many", ["validate pack"], 1,
         two_programs("#define EXPOSURE 1.0\nfloat other() {\n  return 2.0;\n}\n}\n\n" + SHADE, MORE),
         [r"^/lib/all\.glsl:[45]:1: error: '}' without '{': nothing opens what it would close \[brace-unbalanced\]$", OWN],
         stderr=[r"\A/lib/all\.glsl:"]),
    Case("what_follows_is_listed_in_json", ["validate pack --json"], 1,
         two_programs("#define EXPOSURE 1.0\n/* what it does\n" + SHADE),
         [r"\[comment-unclosed\]$"],
         stdout=[r'"follows": \[\n\s+\{']),
    Case("what_follows_is_printed_when_verbose", ["validate pack --verbose"], 1,
         two_programs("#define EXPOSURE 1.0\n/* what it does\n" + SHADE),
         [r"\[comment-unclosed\]$", "error: .*Missing entry point"]),
    Case("a_silenced_cause_hides_nothing", ["validate pack --ignore comment-unclosed"], 1,
         two_programs("#define EXPOSURE 1.0\n/* what it does\n" + SHADE), ["Missing entry point"]),
    Case("colour_is_forced", ["validate pack"], 1, two_programs("#define EXPOSURE 1.0\n"),
         stderr=["^\x1b\\[1m/deferred\\.fsh:3:35: \x1b\\[0m\x1b\\[1;31merror: "],
         environment={"CLICOLOR_FORCE": "1"}),
    Case("no_colour_wins", ["validate pack"], 1, two_programs("#define EXPOSURE 1.0\n"),
         [r"^/deferred\.fsh:3:35: error: "], environment={"CLICOLOR_FORCE": "1", "NO_COLOR": "1"}),
    Case("render_says_it_as_validate_does", ON_PACK, 1,
         pack({"final.fsh": VERSION + "void main() {\n  float a = 1.0\n  gl_FragColor = vec4(a);\n}\n"}),
         [r"^/final\.fsh:3:16: error: syntax error: expected ';' after '1\.0' \[glsl-compile\]$"]),
    Case("unknown_dimension", [f"{RENDER} --dimension foo", "validate pack --dimension foo"], 2, PACK,
         ["error: --dimension: there is no dimension foo"]),
    Case("misspelt_dimension", ["validate pack --dimension minecraft:the_neter"], 2, PACK,
         ["error: --dimension"], stderr=[r"did you mean the_nether\?"]),
    Case("a_shipped_world_by_name", ["render pack cornell -o out.png --size 16x16 --frames 1"], 0, PACK,
         stdout=[r"^wrote out\.png \(16x16, 1 frame, [\d.]+ s, "], creates=["out.png"]),
    Case("misspelt_shipped_world", ["render pack cornel -o out.png"], 2, PACK,
         ["^cornel: error: no such file or folder, nor a world"], stderr=[r"did you mean cornell\?"]),
    Case("options_filter", ["options pack mode"], 0, pack({"final.fsh": WITH_MODE}),
         stdout=[r"^MODE = 1  \[0 1 2\]$", r"^  defined  /final\.fsh:4$", r"^  reaches  final$",
                 r"^  live     no: #if asks for it in final$"]),
    Case("options_filter_without_a_match", ["options pack none such"], 0, pack({"final.fsh": WITH_MODE}),
         stdout=["^no option has none and such$"]),
    Case("options_tree", ["options pack"], 0,
         pack({"final.fsh": WITH_MODE, "shaders.properties": "screen=[LIGHT]\nscreen.LIGHT=MODE\n"}),
         stdout=[r"^main screen\n  \[LIGHT\]\n    MODE = 1  \[0 1 2\]$"]),
]

# Two options, either of which breaks a program alone; DEEP makes the compiler overflow its stack.
MATRIX_PACK = pack({
    "composite.fsh": VERSION + """//#define LOST
void main() {
#ifdef LOST
lost();
#endif
gl_FragColor = vec4(1.0);
}
""",
    "deferred.fsh": VERSION + "//#define DEEP\nvoid main() {\nfloat x = gl_FragCoord.x;\n"
                    "#ifdef DEEP\nx = x" + ("\n" + "+x" * 10) * 15000 + ";\n#endif\n"
                    "gl_FragColor = vec4(x);\n}\n"})
LOST = r"^/composite\.fsh:5:1: error: 'lost' : no matching overloaded function found \[glsl-compile\]$"
DEEP = r"^/deferred\.fsh: error: the compiler died while checking deferred: .* \[compiler-crash\]$"
MATRIX = [
    Case("matrix_none", ["validate pack", "validate pack --matrix none"], 0, MATRIX_PACK,
         stdout=[r"^pack: 3/3 programs$"]),
    Case("matrix_goes_on_when_the_compiler_dies",
         ["validate pack --matrix each", "validate pack --matrix each --budget 2m"], 1, MATRIX_PACK,
         [LOST, DEEP],
         stderr=["note: fails if and only if LOST=true; via /composite ", "note: fails if DEEP=true"],
         stdout=["^  matrix each: 2 configurations, 2 program variants, 1 distinct programs compiled, "]),
    Case("matrix_options", ["validate pack --matrix each --options LOST",
                            "validate pack --matrix pairwise --options LOST"], 1, MATRIX_PACK, [LOST],
         stdout=[r"^  matrix \w+: 1 configurations, "]),
    Case("matrix_unknown_option", ["validate pack --matrix each --options LOTS"], 2, MATRIX_PACK,
         ["--options: the pack has no option LOTS"], stderr=["did you mean LOST"]),
    Case("matrix_shard", ["validate pack --matrix each --shard 1/2 --options LOST"], 1, MATRIX_PACK,
         [LOST], stdout=["^  matrix each, shard 1/2: 1 configurations, "]),
    Case("matrix_shard_of_the_environment", ["validate pack --matrix each --options LOST"], 0,
         MATRIX_PACK, stdout=["^  matrix each, shard 2/2: 0 configurations, "],
         environment={"CI_NODE_INDEX": "2", "CI_NODE_TOTAL": "2"}),
    Case("matrix_usage", ["validate pack --matrix all", "validate pack --matrix each --shard 0/2",
                          "validate pack --matrix each --shard 3/2",
                          "validate pack --matrix each --shard two",
                          "validate pack --matrix each --budget 0s",
                          "validate pack --matrix each --budget -1s",
                          "validate pack --matrix each --budget soon",
                          "validate pack --matrix each --budget 5h"], 2, PACK,
         ["orris validate: error: --(matrix|shard|budget): "]),
]

def region(chunks):
    """A region file; each chunk (x, z) is its tags, compressed with zlib, or bytes put there as they are."""
    table, body = bytearray(8192), b""
    for (x, z), tags in chunks.items():
        packed = zlib.compress(tags) if tags.startswith(b"\n") else tags
        chunk = struct.pack(">IB", len(packed) + 1, 2) + packed
        chunk = chunk.ljust(-(-len(chunk) // 4096) * 4096, b"\0")
        struct.pack_into(">I", table, 4 * (32 * z + x), (2 + len(body) // 4096) << 8 | len(chunk) // 4096)
        body += chunk
    return bytes(table) + body


def chunk_of(block):
    """A chunk of the format of 1.18 whose lowest sixteen layers are one block."""
    def tag(kind, name, payload):
        return bytes([kind]) + struct.pack(">H", len(name)) + name + payload

    def text(name, value):
        return tag(8, name, struct.pack(">H", len(value)) + value)

    palette = tag(9, b"palette", b"\x0a" + struct.pack(">i", 1) + text(b"Name", block) + b"\0")
    section = tag(1, b"Y", b"\0") + tag(10, b"block_states", palette + b"\0") + b"\0"
    sections = tag(9, b"sections", b"\x0a" + struct.pack(">i", 1) + section)
    return tag(10, b"", text(b"Status", b"minecraft:full") + sections + b"\0")


RESOURCES = {
    "world/world.json": """{ "size": [3, 1, 1], "blocks": [{ "block": "stone", "at": [0, 0, 0] },
        { "block": "bricks", "at": [2, 0, 0] }], "cameras": [{ "name": "a", "position": [1, 3, 3] }] }""",
    "rp/assets/minecraft/blockstates/stone.json": '{"variants": {"": {"model": "block/stone"}}}',
    "rp/assets/minecraft/models/block/stone.json": """{"textures": {"all": "block/stone"}, "elements": [
        {"from": [0, 0, 0], "to": [16, 16, 16], "faces": {"up": {"texture": "#all", "cullface": "up"}}}]}""",
}
SAVE = {"home/region/r.0.0.mca": region({(0, 0): chunk_of(b"minecraft:stone"),
                                         (1, 0): chunk_of(b"minecraft:dirt"), (2, 0): b"damaged"})}

WORLDS = [
    Case("save_facts", ["world home --at 8,8 --radius 0", "world home/region --at 8,8 --radius 0",
                        "world home/region/r.0.0.mca --at 8,8 --radius 0"], 0, SAVE,
         stdout=[r"size +16 x 16 x 16 blocks from \(0, 0, 0\)", r"blocks +4096 of 1 block states",
                 r"camera +surface: 8\.50,17\.62,8\.50"]),
    Case("save_chunks_left_out", ["world home --at 20,8 --radius 1"], 0, SAVE,
         stderr=[r"warning: 7 of 9 chunks are left out: 6 that the save does not hold, 1 that cannot be read",
                 r"chunk \(2, 0\): its compressed data is damaged"]),
    Case("save_without_chunks_there", ["world home --at 9000,8", "render pack home --at 9000,8 -o out.png"], 2,
         {**PACK, **SAVE}, [r"home/region: error: no finished chunk lies within 8 chunks of block"]),
    Case("save_without_dimension", ["world home --dimension the_end"], 2, {**SAVE, "home/level.dat": b"damaged"},
         [r"home: error: this save has no region files \(r\.X\.Z\.mca\) of minecraft:the_end"]),
    Case("save_rendered", ["render pack home --at 8,8 --radius 1 -o out.png --size 32x32 --frames 1"], 0,
         {**PACK, **SAVE}, creates=["out.png"]),
    Case("part_of_no_save", [f"world {CORNELL} --radius 2"], 2, {}, [r"this world is drawn whole"]),
    Case("bad_part", ["world home --at 8", "world home --at 8,x", "world home --radius 33",
                      "world home --at 40000000,0"], 2, SAVE, [r"--(at|radius): "]),
    Case("no_such_world", ["world nothing", "render pack nothing -o out.png"], 2, PACK,
         ["nothing"]),
    Case("truncated_schematic", ["world house.schem", "render pack house.schem -o out.png"], 2,
         {**PACK, "house.schem": b"\x1f\x8b\x08\x00\x00\x00\x00\x00\x00\x03\xe3\x60"},
         [r"house\.schem"]),
    Case("bad_palette_key", ["world world", "render pack world -o out.png"], 2,
         {**PACK, "world/world.json": '{\n  "size": [2, 2, 2],\n  "palette": { "ab": "stone" },\n'
                                      '  "cameras": [{ "name": "a", "position": [0, 0, 0] }]\n}\n'},
         [r'^world/world\.json:3:\d+: error: .*"?ab']),
    Case("unknown_block", ["world world"], 0,
         {"world/world.json": '{ "size": [2, 2, 2], "blocks": [{ "block": "nonsense", "at": [0, 0, 0] }],'
                              ' "cameras": [{ "name": "a", "position": [0, 0, 0] }] }'},
         stderr=["warning: .*minecraft:nonsense"], stdout=["unknown +1"]),
    Case("bad_export_paths", [f"world {CORNELL} --export out.stl", f"world {CORNELL} --export out"], 2, {},
         [r"^out(\.stl)?: error: no format of export has this ending"], stderr=["hint: use .glb"]),
    Case("export_into_no_folder", [f"world {CORNELL} --export nowhere/out.glb"], 2, {}, ["nowhere/out.glb"]),
    Case("export_with_bad_option", [f"world {CORNELL} --export out.glb --set SUN=1"], 2, {}, ["SUN"]),
    Case("time_without_export", [f"world {CORNELL} --time 6000"], 2, {}, [r"--time requires --export"]),
    Case("export_of_cornell", [f"world {CORNELL} --export out.glb", f"world {CORNELL} --export out.glb --json"], 0,
         creates=["out.glb"]),
    Case("world_resources", ["world world --resources rp"], 0,
         RESOURCES, stdout=["resources +models for 1 block states, 0 textures",
                            "own look +1 blocks without a model: minecraft:bricks"]),
    Case("no_resource_pack", ["world world --resources nowhere", "render pack world -o out.png --resources pack"], 2,
         {**PACK, **RESOURCES}, [r"no such folder or file|has no folder named assets"]),
    Case("resource_mistake_has_a_place", ["world world --resources rp"], 0,
         {**RESOURCES, "rp/assets/minecraft/models/block/stone.json": '{\n "elements": [{"from": [0, 0]}]\n}'},
         stderr=[r'rp/assets/minecraft/models/block/stone.json:2:24: warning: "from" is a list of 2: expected three numbers']),
    Case("world_random_room", ["world random:17"], 0, {}, stdout=["^random:17$", "camera +room: "]),
    Case("world_random_room_without_a_seed", ["world random:x"], 2, {},
         ["expected a whole number from 0 to 4294967295 after random:"]),
    Case("world_entities_and_texts", ["world world"], 0,
         {"world/world.json": '{ "size": [4, 4, 4], "cameras": [{ "name": "a", "position": [3, 3, 3] }],'
                              ' "entities": [{ "kind": "cow", "position": [1, 1, 1] }, { "kind": "arrow", "position": [1, 2, 1] }],'
                              ' "texts": [{ "text": "A", "at": [1, 1, 1], "position": [1, 1, 1] }] }'},
         stdout=["entities +2", "texts +1"]),
    Case("world_facts", [f"world {CORNELL}"], 0,
         stdout=["size", "lights +[1-9]", "unknown +0", "camera "]),
]

COMPOSITE = VERSION + """#define TONE 1 // [1 2 3]
void main() { gl_FragData[0] = vec4(TONE * 0.25); }
"""
LITTLE_WORLD = """{ "size": [4, 4, 4], "blocks": [{ "block": "stone", "at": [1, 1, 1] }],
  "cameras": [{ "name": "a", "position": [3, 3, 3] }],
  "events": [{ "frame": 1, "option": { "name": "TONE", "value": "3" } }] }"""
COUNTER = """iris.features.required = CUSTOM_IMAGES COMPUTE_SHADERS
image.count = none RED_INTEGER R32UI UNSIGNED_INT false false 2 1
image.large = none RED_INTEGER R32UI UNSIGNED_INT false false 65 1
"""
COUNTING = """#version 430 compatibility
layout(local_size_x = 1) in;
const ivec3 workGroups = ivec3(1, 1, 1);
layout(r32ui) uniform uimage2D count;
void main() { imageAtomicAdd(count, ivec2(1, 0), 1u); }
"""
SMALL = "-o out.png --size 16x16"
# Twice as bright every ten frames, from nearly black.
BRIGHTER = VERSION + """uniform int frameCounter;
void main() { gl_FragColor = vec4(exp2(float(frameCounter) / 10.0 - 8.0)); }
"""
LATE_EVENT = """{"size": [4, 4, 4], "cameras": [{"name": "c", "position": [2, 3, 8], "target": [2, 1, 0]}],
"events": [{"frame": 40, "camera": "c"}]}"""
# One red texel.
TGA = struct.pack("<3B5x4H2B3B", 0, 0, 2, 0, 0, 1, 1, 24, 0, 0, 0, 255)
OUTPUTS = [
    Case("a_picture_is_drawn_until_it_settles", [f"render pack {CORNELL} {SMALL}", f"render pack {CORNELL} {SMALL} --frames auto"],
         0, PACK, stdout=[r"^wrote out.png \(16x16, 32 frames until it settled, "], creates=["out.png"]),
    Case("a_picture_that_does_not_settle_ends", [f"render pack {CORNELL} {SMALL} --frames auto:70"], 0, pack({"final.fsh": BRIGHTER}),
         stdout=[r"^wrote out.png \(16x16, 70 frames, not settled, "], creates=["out.png"]),
    Case("a_picture_settles_when_white", [f"render pack {CORNELL} {SMALL} --json"], 0, pack({"final.fsh": BRIGHTER}),
         stdout=[r'"frames": 256,', r'"settled": true'], creates=["out.png"]),
    Case("frames_are_counted_from_the_last_event", [f"render pack world {SMALL}"], 0, {**PACK, "world/world.json": LATE_EVENT},
         stdout=["72 frames until it settled"], creates=["out.png"]),
    Case("as_many_frames_as_asked_for", [f"render pack {CORNELL} {SMALL} --frames 3"], 0, PACK,
         stdout=[r"^wrote out.png \(16x16, 3 frames, \d"], creates=["out.png"]),
    Case("frames_are_a_number_or_auto", [f"render pack {CORNELL} {SMALL} --frames {count}"
                                         for count in ("0", "-1", "many", "auto:", "auto:0", "auto5", "3.5", "1000001")],
         2, PACK, ["--frames: expected 1 to 1000000, auto, or auto:N for at most N: "]),
    Case("a_texture_that_is_no_png_is_read_inside_the_sandbox", [f"render pack {CORNELL} {SMALL} --frames 1 --probe 3,3"], 0,
         pack({"red.tga": TGA, "shaders.properties": "texture.composite.colortex5 = red.tga\n",
               "final.fsh": VERSION + "uniform sampler2D colortex5;\nvoid main() { gl_FragColor = texture(colortex5, vec2(0.5)); }\n"}),
         stdout=[r"screen.* 1 0 0"], creates=["out.png"]),
    Case("render_writes_what_is_asked",
         [f"render pack {CORNELL} {SMALL} --frames 2 --dump colortex0=a.exr depthtex0=b.png "
          "--timings t.csv --patched final"], 0, PACK,
         creates=["out.png", "a.exr", "b.png", "t.csv", "final/final.vsh", "final/final.fsh"]),
    Case("validate_writes_sources_and_where_they_are_from", ["validate pack --patched final"], 0,
         PACK, creates=["final/final.vsh", "final/final.vsh.map", "final/final.fsh",
                        "final/final.fsh.map"]),
    Case("target_decides_the_macros",
         ["validate pack --target apple", "validate pack --target nvidia"], 1,
         pack({"composite.fsh": VERSION + """#if defined MC_OS_MAC && MC_GLSL_VERSION == 410
#error seen
#endif
#ifdef MC_GL_VENDOR_NVIDIA
#error seen
#endif
void main() { gl_FragColor = vec4(1.0); }
"""}), ["#error seen"]),
    Case("optifine_has_no_macro_of_iris", ["validate pack --target optifine"], 1,
         pack({"composite.fsh": VERSION + """#if !defined IS_IRIS && !defined IRIS_VERSION \\
    && !defined IRIS_FEATURE_CUSTOM_IMAGES
#error seen
#endif
void main() { gl_FragColor = vec4(1.0); }
""", "shaders.properties": """iris.features.optional = CUSTOM_IMAGES
#ifdef IRIS_FEATURE_CUSTOM_IMAGES
program.composite.enabled = false
#endif
"""}), ["#error seen"]),
    Case("unknown_target", ["validate pack --target amiga"], 2, PACK, ["--target: amiga not in"]),
    Case("render_flags_before_the_pack", [f"render {SMALL} --frames 1 --set TONE=2 pack {CORNELL}"],
         0, pack({"composite.fsh": COMPOSITE}), creates=["out.png"]),
    Case("unknown_buffer", [f"render pack {CORNELL} {SMALL} --frames 1 --dump colortex31=a.exr"], 2,
         PACK, ["--dump colortex31"]),
    Case("unknown_camera", [f"render pack {CORNELL} {SMALL} --camera none",
                            f"render pack {CORNELL} {SMALL} --camera 1,2,3"], 2, PACK,
         ["--camera: "], ["hint: use one of front"]),
    Case("unwritable_output", [f"render pack {CORNELL} -o {path} --frames 1"
                               for path in ("none/out.png", "pack", "out.gif", "out")],
         2, PACK, ["^(none/out.png|pack|out.gif|out): error: "]),
    Case("unwritable_dump", [f"render pack {CORNELL} {SMALL} --dump colortex0=none/a.exr"], 2, PACK,
         ["none/a.exr"]),
    Case("event_rebuilds_what_its_option_reaches",
         [f"render pack world {SMALL} --frames 3 --json"], 0,
         {**pack({"composite.fsh": COMPOSITE}), "world/world.json": LITTLE_WORLD},
         stdout=[r'"cause": ".*TONE=3"', r'"frame": 1,',
                 r'"programsBuilt": \[\n\s+"composite"\n\s+\],\n\s+"programsReused": [1-9]'],
         creates=["out.png"]),
    Case("json_tells_what_the_pack_counts", [f"render pack world {SMALL} --frames 3 --json"], 0,
         {**pack({"composite.fsh": COMPOSITE, "shaders.properties": COUNTER,
                    "begin.csh": COUNTING}),
          "world/world.json": LITTLE_WORLD},
         stdout=[r'"counters": \{\n\s+"count": \[\n\s+0,\n\s+2\n\s+\]\n\s+\}'], creates=["out.png"]),
    Case("what_a_user_should_know_of_a_count_is_a_warning", [f"render pack world {SMALL} --frames 3"], 0,
         {**pack({"composite.fsh": COMPOSITE,
                  "shaders.properties": COUNTER + "warn.count.1 = too many\nwarn.count.0 = never\n",
                  "begin.csh": COUNTING}),
          "world/world.json": LITTLE_WORLD},
         stderr=["^/shaders.properties:4:1: warning: 2 too many"], creates=["out.png"]),
    Case("warning_of_what_is_no_counter", ["validate pack"], 0,
         {**pack({"composite.fsh": COMPOSITE,
                  "shaders.properties": COUNTER + "warn.large.1 = a\nwarn.count.2 = b\nwarn.count = c\n",
                  "begin.csh": COUNTING})},
         stderr=["warn.large.1: no such counter", "counters are count", "warn.count.2: no such texel",
                 "count has 2, from 0", "warn.count: no such texel"]),
    Case("bricks_of_the_floodfill_at_work_are_counted", [f"{FLOOD} --frames 3"], 0, {},
         stdout=[r'"flood_state": \[\n\s+[1-9]\d?,\n\s+512\n'], creates=["out.png"]),
    Case("at_rest_the_floodfill_does_nothing", [f"{FLOOD} --frames 120"], 0, {},
         stdout=[r'"flood_state": \[\n\s+0,\n\s+512\n'], creates=["out.png"]),
    *[Case(f"auto_shadows_{world}_{size}",
           [f"render {{source}}/shaderpack {{source}}/worlds/{world} -o out.png --size {size} --frames 1 --json "
            "--set GI_METHOD=NONE SHADOW_METHOD=AUTO LIGHT_METHOD=AUTO"], 0, {}, creates=["out.png"],
           stdout=[rf'"option": "SHADOW_METHOD",\n\s+"value": "{shadows}"', rf'"option": "LIGHT_METHOD",\n\s+"value": "{lamps}"'])
      for world, size, shadows, lamps in (("cornell", "32x18", "NONE", "DEFERRED"),
                                          ("pillars", "160x90", "VOLUME_AUTO", "NONE"),
                                          ("hills", "160x90", "VOLUME_AUTO", "NONE"),
                                          ("hills", "640x360", "MAP_PCF", "NONE"))],
    *[Case(f"auto_rays_to_lamps_{world}",
           [f"render {{source}}/shaderpack {{source}}/worlds/{world} -o out.png --size 32x18 --frames 1 --json"], 0, {},
           creates=["out.png"], stdout=[rf'"option": "GI_LAMPS",\n\s+"value": "{lamps}"'])
      for world, lamps in (("cornell", "SAMPLED"), ("h4_house", "HIT"))],
    *[Case(f"auto_light_of_translucent_blocks_{world}",
           [f"render {{source}}/shaderpack {{source}}/worlds/{world} -o out.png --size 32x18 --frames 1 --json"], 0, {},
           creates=["out.png"], stdout=[rf'"option": "GI_TRANSLUCENT",\n\s+"value": "{light}"'])
      for world, light in (("bay", "CACHED"), ("street", "RAYS"))],
    Case("settings_file_then_set", ["options pack --settings mine.txt --set TONE=2"], 0,
         {**pack({"composite.fsh": COMPOSITE}), "mine.txt": "TONE=3\n"}, stdout=["^TONE = 2"]),
    Case("settings_file", ["options pack --settings mine.txt"], 0,
         {**pack({"composite.fsh": COMPOSITE}), "mine.txt": "TONE=3\n"}, stdout=["^TONE = 3"]),
    Case("settings_file_missing", ["options pack --settings none.txt",
                                   "render pack world -o out.png --settings none.txt"], 2,
         {**PACK, "world/world.json": LITTLE_WORLD}, ["none.txt"]),
]

MASKS = {"lit.png": png(16, 16, (255, 255, 255)), "dark.png": png(16, 16, (0, 0, 0)),
         "grey.png": png(16, 16, (64, 64, 64)), "small.png": png(8, 8, (0, 0, 0))}
PICTURES = {"grey.png": png(20, 16, (100, 100, 100)), "same.png": png(20, 16, (100, 100, 100)),
            "red.png": png(20, 16, (151, 100, 100)), "small.png": png(8, 8, (100, 100, 100)),
            "text.png": "no picture\n"}
COMPARISONS = [
    Case("compare_masks", ["compare --mask lit.png lit.png --max-interior 0 --max-edge 0"], 0, MASKS,
         stdout=["^pixels +256$", "^edge +0$", "^interior +0$"]),
    Case("compare_masks_inside", ["compare --mask lit.png dark.png --max-interior 0 --diff d.png"], 1,
         MASKS, ["interior is 1, --max-interior allows 0"], stdout=["^interior +256$"],
         creates=["d.png"]),
    Case("compare_masks_on_edges", ["compare --mask lit.png grey.png --max-edge 0.5"], 1, MASKS,
         ["edge is 1, --max-edge allows 0.5"], stdout=["^edge +256$", "^interior +0$"]),
    Case("compare_masks_of_two_sizes", ["compare --mask lit.png small.png"], 1, MASKS, ["differ in size"]),
    Case("compare_equal", ["compare grey.png same.png --max-rmse 0 --min-ssim 1"], 0, PICTURES,
         stdout=["^rmse +0$", "^maxAbsolute +0$", "^fractionAbove +0$", "^ssim +1$"]),
    Case("compare_difference_picture", ["compare red.png grey.png --diff diff.png"], 0, PICTURES,
         stdout=[r"^maxAbsolute +0\.2$", "^fractionAbove +1$"], creates=["diff.png"]),
    Case("compare_limits", ["compare red.png grey.png --max-abs 0.1 --max-fraction 0.5 --json"], 1,
         PICTURES, [r"maxAbsolute is 0\.2, --max-abs allows 0\.1",
                    r"fractionAbove is 1, --max-fraction allows 0\.5"],
         stdout=['"id": "limit-exceeded"', '"rmse": 0.11']),
    Case("compare_sizes_differ", ["compare small.png grey.png --diff diff.png"], 1, PICTURES,
         ["8.*8.*20.*16|20.*16.*8.*8"]),
    Case("compare_unreadable", ["compare text.png grey.png", "compare grey.png text.png"], 2,
         PICTURES, [r"text\.png"]),
    Case("compare_missing", ["compare none.png grey.png"], 2, PICTURES, [r"none\.png"]),
    Case("compare_unwritable", ["compare red.png grey.png --diff none/diff.png",
                                "compare red.png grey.png --diff grey.png/diff.png"], 2, PICTURES,
         [r"diff\.png"]),
]

MODES = pack({"final.fsh": WITH_MODE,
              "shaders.properties": "profile.LOW = MODE=1\nprofile.HIGH = MODE=2\n"})
MEASURE = "--size 16x9 --warm-up 1 --frames 2 --rounds 2 --visit 1"
CHART = f"chart pack {CORNELL} -o out {MEASURE} --reference MODE=2 --reference-frames 2"
TUNE = CHART.replace("chart", "tune")
# A mistake is reported before anything is drawn or made.
CHARTS = [
    Case("chart_unknown_axis", [f"{CHART} --axis MODES", f"{CHART} --axis MODE --axis MODES=1"], 2,
         MODES, ['"MODES" is no option of the pack, nor profile or size'],
         ["did you mean MODE"]),
    Case("chart_unknown_value", [f"{CHART} --axis profile=HIHG"], 2, MODES,
         ['profile cannot be "HIHG"'], ["did you mean HIGH"]),
    Case("chart_value_outside_its_list", [f"{CHART} --axis MODE=1,7"], 2, MODES,
         ['MODE cannot be "7"'], ["its values are 0, 1, 2"]),
    Case("chart_wrong_size", [f"{CHART} --axis size=16x9,big"], 2, MODES,
         ['size cannot be "big"'], ["write it as 320x180"]),
    Case("chart_size_without_values", [f"{CHART} --axis size"], 2, MODES,
         ["the axis size has no values"]),
    Case("chart_profile_of_none", [f"{CHART} --axis profile"], 2, pack({"final.fsh": WITH_MODE}),
         ["the axis profile has no values"]),
    Case("chart_axis_twice", [f"{CHART} --axis MODE=1 --axis MODE=2"], 2, MODES,
         ["the axis MODE is given twice"]),
    Case("chart_no_reference", [f"chart pack {CORNELL} -o out --axis MODE"], 2, MODES,
         ["no --reference to measure errors against"], ["a picture of orris trace"]),
    Case("chart_reference_unreadable", [f"chart pack {CORNELL} -o out --reference none.exr"], 2,
         MODES, [r"none\.exr"]),
    Case("chart_reference_of_another_size",
         [f"chart pack {CORNELL} -o out --size 16x9 --reference reference.png"], 2,
         {**MODES, "reference.png": png(8, 8, (1, 2, 3))}, ["no --reference is 16x9 pixels large"],
         ["orris trace WORLD -o reference.exr --size 16x9"]),
    Case("chart_reference_unknown", [f"chart pack {CORNELL} -o out --reference MODEL=1"], 2, MODES,
         ['"MODEL" is no option'], ["did you mean MODE"]),
    Case("chart_wrong_mark", [f"{CHART} --axis MODE --mark MODE=1:fast",
                              f"{CHART} --axis MODE --mark MODE=1:-1"], 2, MODES,
         ["no cost ratio after the colon"]),
    Case("chart_unknown_baseline", [f"{CHART} --axis MODE=1,2 --baseline MODE=0"], 2, MODES,
         ["--baseline MODE=0: none of the settings is that"]),
    Case("chart_wrong_flags", [f"{CHART} {flags}" for flags in (
        "--metric beauty", "--frames 1", "--rounds 0", "--budget soon", "--clock sun", "--shard 3/2")], 2, MODES,
        ["orris chart: error: "]),
    Case("chart_scenes_malformed", [f"chart pack --scenes {scenes} -o out {MEASURE}" for scenes in (
        "random:x:2", "random:1:0", "random:1:2:3", "random:1:10001", "@front")], 2, MODES,
        ["--scenes: expected WORLD, WORLD@CAMERA or random:SEED:N"]),
    Case("chart_world_or_scenes", [f"chart pack -o out {MEASURE}",
                                   f"chart pack {CORNELL} --scenes random:1:2 -o out {MEASURE}"], 2, MODES,
         ["expected either WORLD or --scenes"]),
    Case("chart_unwritable", [CHART.replace("-o out", "-o pack/shaders/final.fsh")], 2, MODES,
         ["the folder cannot be made"]),
    Case("chart_unknown_camera", [f"{CHART} --axis MODE --cameras front,bakc"], 2, MODES,
         ['--cameras: "bakc" is no camera of this world']),
    Case("chart_reference_of_which_camera",
         [f"chart pack {CORNELL} -o out --size 8x8 --cameras front,red --reference reference.png"], 2,
         {**MODES, "reference.png": png(8, 8, (1, 2, 3))}, ["which of the cameras is this of"],
         ["CAMERA=FILE for each"]),
    Case("chart_reference_of_one_camera_only",
         [f"chart pack {CORNELL} -o out --size 8x8 --cameras front,red --reference red=reference.png"],
         2, {**MODES, "reference.png": png(8, 8, (1, 2, 3))},
         ["no --reference is 8x8 pixels large, from camera front"]),
    Case("tune_wants_one_goal", [f"{TUNE} {flags}" for flags in (
        "", "--error 0.1 --ms 3", "--error 0", "--ms soon", "--error 0.1 --shard 1/2")], 2, MODES,
        ["orris tune: error: "]),
    Case("tune_unknown_axis", [f"{TUNE} --error 0.1 --axis MODES"], 2, MODES,
         ['"MODES" is no option of the pack, nor profile or size'], ["did you mean MODE"]),
    Case("tune_without_profiles", [f"{TUNE} --error 0.1"], 2, pack({"final.fsh": WITH_MODE}),
         ["the axis profile has no values"], ["name other axes"]),
    Case("tune_unwritable", [TUNE.replace("-o out", "-o none/out") + " --ms 1"], 2, MODES,
         ["cannot be written"]),
    Case("chart_unknown_pack", [CHART.replace("chart pack", "chart none")], 2, MODES, ["none"]),
]

GALLERY = "gallery pack -o out.html --size 16x9 --frames 1"
GALLERIES = [
    Case("gallery_wrong_flags", [f"{GALLERY} {flags}" for flags in (
        "--fail-above 0.1", "--against pack --fail-above 3", "--shard 3/2", "--budget soon", "--size 0x9")], 2, MODES,
        ["orris gallery: error: "]),
    Case("gallery_unknown_pack", [GALLERY.replace("pack", "none")], 2, MODES, ["none"]),
    Case("gallery_unknown_revision", [f"{GALLERY} --against none"], 2, MODES, ["none"]),
    Case("gallery_unknown_profile", [f"{GALLERY} --profiles LOW,HIHG --set-file set.json"], 2,
         {**MODES, "set.json": '{"scenes": [{"world": "cornell"}]}'},
         [r"^error: --profiles: the pack has no profile HIHG \[profile-unknown\]$"], ["did you mean HIGH"]),
    Case("gallery_unreadable_set", [f"{GALLERY} --set-file none.json"], 2, MODES, [r"none\.json"]),
    Case("gallery_unwritable", [GALLERY.replace("out.html", "none/out.html"),
                                GALLERY.replace("out.html", "pack/shaders/final.fsh")], 2, MODES,
         [r"cannot be (written|made)"]),
]

TRACE = f"trace {CORNELL} -o out.exr --size 16x9 --samples 2"
TRACES = [
    Case("trace_shadow_mask", [f"trace {CORNELL} -o mask.png --size 16x9 --shadow-mask",
                               f"trace {CORNELL} -o mask.png --size 16x9 --shadow-mask --lamp 8,8,8"], 0,
         stdout=["^[0-9]+ of 144 pixels lit$"], creates=["mask.png"]),
    Case("trace_lamp_without_a_place",
         [f"trace {CORNELL} -o mask.png --size 16x9 --shadow-mask --lamp 8,8"], 2, {}, ["is no place"]),
    Case("trace_picture", [TRACE, f"{TRACE} --seconds 60 --noise 0.001 --jobs 3 --resume"], 0,
         stdout=[r"^2 samples a pixel, noise [0-9.]+ % rms of the mean$"],
         creates=["out.exr", "out.exr.trace"]),
    Case("trace_json", [f"{TRACE} --json --bounces 0", f"{TRACE} --json --shard 2/3"], 0,
         stdout=['"relative": ', '"stoppedBy": "samples"', '"lampFaces": 32'],
         creates=["out.exr", "out.exr.trace"]),
    Case("trace_noise_ends", [f"trace {CORNELL} -o out.exr --size 16x9 --noise 0.9 --json",
                              f"trace {CORNELL} -o out.exr --size 8x8 --noise 0.9 --json"], 0,
         stdout=['"stoppedBy": "noise"'], creates=["out.exr", "out.exr.trace"]),
    Case("trace_wrong_limits", [f"{TRACE} {flags}" for flags in (
        "--samples 1", "--samples x", "--bounces -1", "--jobs 0",
        "--shard 3/2", "--shard 0/2", "--shard 2", "--merge a.trace --resume",
        "--merge a.trace --shard 1/2", "--size 0x4", "--frames 2")], 2,
         errors=["orris trace: error: "]),
    Case("trace_limits_that_are_not_positive", [f"{TRACE} {flag} {value}" for flag in ("--seconds", "--noise")
                                                for value in ("0", "-1", "x", "1x", "inf", "nan")], 2,
         errors=[r"^orris trace: error: --(seconds|noise): expected a number above 0: (0|-1|x|1x|inf|nan)$"]),
    Case("trace_wants_exr", [TRACE.replace("out.exr", "out.png")], 2,
         errors=[r"^out\.png: error: only \.exr holds linear light and both halves \["]),
    Case("trace_unwritable", [TRACE.replace("out.exr", "none/out.exr")], 2,
         errors=[r"none/out\.exr: error: cannot be written"]),
    Case("trace_unknown_names", [f"{TRACE} --camera nowhere", f"{TRACE} --set GI_METHODS=NONE",
                                 f"{TRACE} --profile BEST"], 2,
         errors=["nowhere|GI_METHODS|BEST"]),
    Case("trace_no_checkpoint", [f"{TRACE} --merge a.trace", f"{TRACE} --merge a.trace a.trace"], 2,
         errors=[r"^a\.trace: error: cannot be read as a checkpoint of trace \["]),
    Case("trace_foreign_checkpoint", [f"{TRACE} --resume"], 2,
         {"out.exr.trace": "no film " * 100},
         [r"^out\.exr\.trace: error: is not a checkpoint of trace \["]),
]

CASES = USAGE + PACKS + ONCE + MATRIX + WORLDS + OUTPUTS + COMPARISONS + CHARTS + GALLERIES + TRACES
