"""Mistakes put into the pack's side of shadow volumes, and the tests that must find them.

For kill_list.py --table; rows as in mutants.py. Those of the host are in volume_host_mutants.py.
"""

SUN = "include/sun/sun_visibility.glsl"
LAMPS = "include/lights/lamp_volumes.glsl"
PROGRAM = "program/shadow/shadowvolume.glsl"
PROPERTIES = "shaders.properties"

MUTANTS = [
    ("D1 z-fail listing equal to z-pass", "D1.only*",
     [(PROPERTIES, "shadowvolume.method = zfail", "shadowvolume.method = zpass")]),
    ("D1 automatic choice never taken", "D1.only*:D2.a_path*",
     [(PROPERTIES, "shadowvolume.method = auto", "shadowvolume.method = zpass")]),
    ("D1 shadow and light exchanged", "D1.*",
     [(SUN, "== 0u", "!= 0u")]),
    ("D1 one volume is not enough", "D1.volumes*",
     [(SUN, ".r == 0u", ".r <= 1u")]),
    ("D2 vertices at infinity made finite", "D1.volumes*",
     [(PROGRAM, "gl_ModelViewProjectionMatrix * gl_Vertex", "gl_ModelViewProjectionMatrix * vec4(gl_Vertex.xyz, 1.0)")]),
    ("lamps: the bit of another lamp", "LampVolumes.darken*",
     [(LAMPS, "(lamps_hidden >> i & 1u) != 0u && max", "(lamps_hidden >> (1 - i) & 1u) != 0u && max")]),
    ("lamps: a volume hides every lamp", "LampVolumes.darken*",
     [(LAMPS, " && max(off.x, max(off.y, off.z)) < 0.25", "")]),
    ("lamps: no range", "LampVolumes.are_those*",
     [(PROPERTIES, "shadowvolume.lights = LIGHT_VOLUMES LIGHT_RANGE", "shadowvolume.lights = LIGHT_VOLUMES 0.5")]),
]
