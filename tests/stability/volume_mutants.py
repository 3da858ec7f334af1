"""Mistakes put into the pack's side of shadow volumes, and the tests that must find them.

For kill_list.py --table; rows as in mutants.py. Those of the host are in volume_host_mutants.py.
"""

SUN = "include/sun/sun_visibility.glsl"
LAMPS = "include/lights/lamp_volumes.glsl"
PROGRAM = "program/shadow/shadowvolume.glsl"
PROPERTIES = "shaders.properties"

MUTANTS = [
    ("D1 z-fail listing equal to z-pass", "ShadowVolumeCounts.only*",
     [(PROPERTIES, "shadowvolume.method = zfail", "shadowvolume.method = zpass")]),
    ("D1 automatic choice never taken", "ShadowVolumeCounts.only*:ShadowVolumeCounts.a_path*",
     [(PROPERTIES, "shadowvolume.method = auto", "shadowvolume.method = zpass")]),
    ("D1 shadow and light exchanged",
     "ShadowVolumeCounts.crossings*:ShadowVolumeCounts.volumes_of*:ShadowVolumeCounts.only*:ShadowVolumeCounts.z*",
     [(SUN, "== 0u", "!= 0u")]),
    ("D1 one volume is not enough", "ShadowVolumeCounts.volumes_of*",
     [(SUN, ".r == 0u", ".r <= 1u")]),
    ("D2 vertices at infinity made finite", "ShadowVolumeCounts.volumes_of*",
     [(PROGRAM, "gl_ModelViewProjectionMatrix * gl_Vertex", "gl_ModelViewProjectionMatrix * vec4(gl_Vertex.xyz, 1.0)")]),
    ("lamps: the bit of another lamp", "LampVolumes.darken*",
     [(LAMPS, "(lamps_hidden >> i & 1u) != 0u && max", "(lamps_hidden >> (1 - i) & 1u) != 0u && max")]),
    ("lamps: a volume hides every lamp", "LampVolumes.darken*",
     [(LAMPS, " && max(off.x, max(off.y, off.z)) < 0.25", "")]),
    ("lamps: no range", "LampVolumes.are_those*",
     [(PROPERTIES, "shadowvolume.lights = LIGHT_VOLUMES LIGHT_RANGE", "shadowvolume.lights = LIGHT_VOLUMES 0.5")]),
]
