"""Mistakes put into exposure and waves of the reference pack, and the tests that must find them.

For tests/stability/kill_list.py --table; rows as in tests/stability/mutants.py.
"""

PASS = "program/post/exposure.glsl"
EXPOSURE = "include/post/exposure.glsl"
WAVES = "include/water/waves.glsl"
TRANSLUCENT = "program/gbuffers/translucent.glsl"

MUTANTS = [
    ("exposure adapts from nothing", "AutoExposure.first*", [(PASS, "before > 0.0 ?", "before >= 0.0 ?")]),
    ("exposure never adapts", "AutoExposure.follows*", [(PASS, "exp(-frameTime / adaptation_time)", "1.0")]),
    ("exposure adapts by frames", "AutoExposure.follows*", [(PASS, "-frameTime / adaptation_time", "-0.02 / adaptation_time")]),
    ("exposure forgets", "AutoExposure.follows*", [("include/buffers.glsl", "colortex9Clear = false", "colortex9Clear = true")]),
    ("exposure the wrong way round", "AutoExposure.first*",
     [(EXPOSURE, "log2(usual_luminance) - mean_log", "mean_log - log2(usual_luminance)")]),
    ("exposure is not used", "AutoExposure.exposes*",
     [("program/post/final.glsl", "color *= texelFetch(colortex9, ivec2(0), 0).r;", "")]),
    ("exposure is made where nothing reads it", "AutoExposure.costs*",
     [("shaders.properties", "program.composite.enabled = false", "")]),
    ("views of shadows are exposed", "AutoExposure.costs*", [("include/derived/features.glsl", "#if !defined SHADOW_VIEW", "#if 1"),
                                                            ("shaders.properties", "defined SHADOW_VIEW ||", "")]),
    ("waves stand still", "WaterWaves.move*", [(WAVES, "turns / wave_clock * frameTimeCounter", "turns / wave_clock")]),
    ("waves without the option", "WaterWaves.move*",
     [("include/derived/features.glsl", "#define HAS_WATER_WAVES 0\n#endif\n#else\n#define HAS_WATER_WAVES 0",
       "#define HAS_WATER_WAVES 0\n#endif\n#else\n#define HAS_WATER_WAVES 1")]),
    ("waves seen however far", "WaterWaves.far*", [(WAVES, "exp(-0.25 * dot(k, k) * pixel * pixel)", "1.0")]),
]
