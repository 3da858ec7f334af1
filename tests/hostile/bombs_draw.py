"""Programs that a compiler accepts and that kill or stall the GL driver, when it compiles or when it draws."""

from hostile_files import HEAD, VERTEX, pack

GROUPS = "const ivec3 workGroups = ivec3({0});\n"
COMPUTE = "#version 430 compatibility\nlayout(local_size_x = {0}) in;\n"
IMAGE = "layout(rgba8) uniform image2D colorimg0;\n"
STORE = "imageStore(colorimg0, ivec2(gl_GlobalInvocationID.xy & 7u), vec4(x));\n"
UNIFORM = "uniform int frameCounter;\nuniform float frameTimeCounter;\n"


def drawn(body, declarations="", vertex=VERTEX, head=HEAD):
    """A pack whose composite has this body; it reads `x`, which no compiler knows."""
    text = head + UNIFORM + declarations + "void main() {\nfloat x = frameTimeCounter;\n" + body + \
        "\ngl_FragColor = vec4(x);\n}\n"
    return lambda folder: pack(folder, {"composite.fsh": text, "composite.vsh": vertex})


def computed(body, groups="1, 1, 1", local=1, declarations="", **more):
    text = (COMPUTE.format(local) + GROUPS.format(groups) + UNIFORM + IMAGE + declarations +
            "void main() {\nfloat x = frameTimeCounter;\n" + body + "\n" + STORE + "}\n")
    return lambda folder: pack(folder, {"composite.csh": text, **more})


def array_of(size, kind="float"):
    return drawn(f"{kind} a[{size}];\na[frameCounter] = {kind}(x);\nx = float(a[frameCounter + 1]);")


def constants(count):
    values = ", ".join(f"{i}.5" for i in range(count))
    return drawn("x += A[frameCounter];", f"const float A[{count}] = float[{count}]({values});\n")


def varyings(count):
    names = "".join(f"out float v{i};\n" for i in range(count))
    sets = "".join(f"v{i} = gl_Vertex.x;\n" for i in range(count))
    vertex = HEAD + names + "void main() {\ngl_Position = ftransform();\n" + sets + "}\n"
    total = "x += " + "; x += ".join(f"v{i}" for i in range(count)) + ";"
    return drawn(total, names.replace("out ", "in "), vertex)


def varying_array(size):
    vertex = HEAD + f"out float v[{size}];\nvoid main() {{ gl_Position = ftransform(); v[0] = 1.0; }}\n"
    return drawn("x = v[frameCounter];", f"in float v[{size}];\n", vertex)


def indirect(folder):
    write = (COMPUTE.format(1) + GROUPS.format("1, 1, 1") + "layout(std430, binding = 0) buffer B { uint n[]; };\n"
             "void main() { n[0] = 65535u; n[1] = 65535u; n[2] = 1u; }\n")
    read = COMPUTE.format(64) + IMAGE + "void main() {\nfloat x = 1.0;\n" + STORE + "}\n"
    return pack(folder, {"prepare.csh": write, "composite.csh": read, "shaders.properties":
                         "iris.features.required=SSBO\nbufferObject.0=64\nindirect.composite=0 0\n"})


def inlined(levels):
    return drawn(f"x = f{levels}(x);", "float f0(float x) { return sin(x); }\n" + "".join(
        f"float f{i}(float x) {{ return f{i - 1}(x) + f{i - 1}(x + 1.0); }}\n" for i in range(1, levels + 1)))


def switch(cases):
    return drawn("switch (int(x * 100.0)) {\n" + "".join(
        f"case {i}: x += sin(x * {i}.5); break;\n" for i in range(cases)) + "}")


LOOP = "for (int {0} = 0; {0} < 2000000000; ++{0}) "
NESTED = "".join(LOOP.format(name) for name in "abcdef") + "x = sin(x + float(a + f));"

# (generator, whether it has to be refused): all end within the limits of the command.
BOMBS = {
    "dispatch-65535-2": lambda: (computed("", "65535, 65535, 1", 64), "frame-timeout"),
    "dispatch-2-31": lambda: (computed("", "2147483647, 1, 1"), None),
    # llvmpipe multiplies in 32 bits and ends soon.
    "dispatch-65535-3": lambda: (computed("", "65535, 65535, 65535", 1024), "directive-value"),
    "dispatch-indirect": lambda: (indirect, None),
    "loop-endless": lambda: (drawn("for (;;) x = sin(x);"), None),
    "loops-nested": lambda: (drawn(NESTED), None),
    "loops-nested-compute": lambda: (computed(NESTED, "64, 64, 1", 64), None),
    "local-array-2-31": lambda: (array_of(2147483647), "stage-too-large"),
    "local-array-10-6": lambda: (array_of(1_000_000), "stage-too-large"),
    "local-array-of-vectors": lambda: (array_of(100_000, "vec4"), "stage-too-large"),
    "uniform-array-10-8": lambda: (drawn("x = u[frameCounter];", "uniform float u[100000000];\n"),
                                   "stage-too-large"),
    "const-array-10-4": lambda: (constants(10_000), None),
    "varying-array-10-5": lambda: (varying_array(100_000), "stage-too-large"),
    "varyings-5000": lambda: (varyings(5000), None),
    "terms-20-000": lambda: (drawn("x = x" + ("\n" + " + x" * 20) * 1000 + ";"), None),
    "statements-20-000": lambda: (drawn("".join(f"x = sin(x + {i}.0);\n" for i in range(20_000))), None),
    "shared-beyond": lambda: (computed("s[gl_LocalInvocationIndex + 1000000u * uint(frameCounter + 9)] = 1u;\n"
                                       "barrier(); x = float(s[gl_LocalInvocationIndex]);", local=64,
                                       declarations="shared uint s[64];\n"), None),
    "shared-memory-huge": lambda: (computed("s[gl_LocalInvocationIndex] = 1u; x = float(s[frameCounter]);",
                                            declarations="shared uint s[100000000];\n"), None),
    "inlined-functions": lambda: (inlined(19), "stage-too-large"),
    # Within the limits of core/limits.h.
    "array-at-limit": lambda: (array_of(8192, "vec4"), None),
    "switch-at-limit": lambda: (switch(1000), None),
    "inlined-at-limit": lambda: (inlined(14), None),
}

HEAVY = {"array-at-limit", "switch-at-limit", "inlined-at-limit", "dispatch-65535-3", "loops-nested", "loops-nested-compute", "const-array-10-4",
         "statements-20-000"}
