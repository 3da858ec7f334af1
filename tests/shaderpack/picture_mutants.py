"""Mistakes put into exposure, waves, filter and the picture's format of the reference pack, and the tests that must find them.

For tests/stability/kill_list.py --table; rows as in tests/stability/mutants.py.
"""

PASS = "program/post/exposure.glsl"
EXPOSURE = "include/post/exposure.glsl"
WAVES = "include/water/waves.glsl"
FILTER = "program/gi/filter.glsl"
TRANSLUCENT = "program/gbuffers/translucent.glsl"

MUTANTS = [
    ("half floats however many frames are averaged", "PackPicture.is_in_floats*",
     [("include/math/half.glsl", "#if TEMPORAL_FRAMES > 128", "#if 0")]),
    ("a picture in half floats of means in floats", "PackPicture.is_in_floats*",
     [("include/buffers.glsl", "colortex0Format = RGBA32F", "colortex0Format = RGBA16F")]),
    ("the filter mixes what is no noise", "GiFilter.leaves*",
     [(FILTER, "weight *= exp(", "weight *= 1.0 + 0.0 * exp(")]),
    ("the filter mixes next to nothing", "GiFilter.takes*",
     [(FILTER, "const float noise_reach = 6.0;", "const float noise_reach = 0.1;")]),
    ("bright pixels get more of the filter than they give", "GiFilter.takes*",
     [(FILTER, "max(center.a, beside.a)", "center.a")]),
    ("the filter takes all noise for as large as before", "GiFilter.leaves*",
     [(FILTER, "noise * sqrt(squares) / sum.a", "noise")]),
    ("the filter mixes long means as short ones", "GiFilter.fades*", [(FILTER, "weight *= trust;", "")]),
    ("long means have the noise of short ones", "GiFilter.fades*",
     [(FILTER, "sqrt(trust * differences.x", "sqrt(differences.x")]),
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
