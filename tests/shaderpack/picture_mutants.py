"""Mistakes put into exposure, waves, filter and the picture's format of the reference pack, and the tests that must find them.

For tests/stability/kill_list.py --table; rows as in tests/stability/mutants.py.
"""

PASS = "program/post/exposure.glsl"
EXPOSURE = "include/post/exposure.glsl"
WAVES = "include/water/waves.glsl"
FILTER = "program/gi/filter.glsl"
NOISE = "include/gi/noise.glsl"
TRANSLUCENT = "program/gbuffers/translucent.glsl"
SKY = "program/gbuffers/sky.glsl"

MUTANTS = [
    ("half floats however many frames are averaged", "PackPicture.is_in_floats*",
     [("include/math/half.glsl", "#if HAS_LONG_MEANS", "#if 0")]),
    ("a picture in floats where nothing is averaged", "PackPicture.is_in_floats*",
     [("include/derived/features.glsl", "#define HAS_LONG_MEANS HAS_GI", "#define HAS_LONG_MEANS 1")]),
    ("sun, moon and stars without direct light", "PackPicture.without*", [(SKY, "#if DIRECT_LIGHT == NONE", "#if 0")]),
    ("stars without direct light", "PackPicture.without*",
     [(SKY, "#if DIRECT_LIGHT == NONE", "#if DIRECT_LIGHT == NONE && defined PROGRAM_TEXTURED")]),
    ("a picture in half floats of means in floats", "PackPicture.is_in_floats*",
     [("include/buffers.glsl", "colortex0Format = RGBA32F", "colortex0Format = RGBA16F")]),
    ("the filter mixes what is no noise", "GiFilter.leaves*",
     [(FILTER, "float near = exp(", "float near = 1.0 + 0.0 * exp(")]),
    ("the filter mixes next to nothing", "GiFilter.takes*",
     [(FILTER, "const float noise_reach = 3.5;", "const float noise_reach = 0.1;")]),
    ("bright pixels give more to the filter than they get", "GiFilter.takes*",
     [(FILTER, "(a.light.a + b.light.a)", "2.0 * a.light.a")]),
    ("the filter takes all noise for as large as before", "GiFilter.leaves_what*",
     [(FILTER, "sqrt(variance) / sum.a);", "sqrt(center.light.a));")]),
    ("pixels at edges mix with one side alone", "GiFilter.keeps*",
     [(FILTER, "weights = min(weights, mix(weights.yx, weights, one_sided));", "")]),
    ("pixels at edges never mix with one side alone", "GiFilter.takes*", [(FILTER, "mix(weights.yx, weights, one_sided)", "weights.yx")]),
    ("the filter sees luminance only", "GiFilter.leaves_edges*",
     [(NOISE, "return max(max(off.r, off.g), off.b);", "return pow(luminance(a - b), 2.0);")]),
    ("a mean has the noise of a sample", "GiFilter.fades*",
     [(NOISE, "sqrt(variance) * noise_left(mean.a)", "sqrt(variance)"), (NOISE, "noise / noise_left(before.a)", "noise")]),
    ("noise is that of the last sample", "GiFilter.leaves_what*",
     [(NOISE, "mean.rgb), weight_of_sample(mean.a))", "mean.rgb), 1.0)")]),
    ("noise is that of the last samples", "GiFilter.knows*",
     [(NOISE, "mean.rgb), weight_of_sample(mean.a))", "mean.rgb), weight_of_sample(min(mean.a, 64.0)))")]),
    ("noise is not kept", "GiFilter.leaves_what*", [("program/gi/mean.glsl", "if (mean.a > 0.0) noise =", "if (mean.a < 0.0) noise =")]),
    ("all noise counts as none", "GiFilter.takes*", [("program/gi/mean.glsl", "out_plane.w = noise_with", "out_plane.w = 0.0 * noise_with")]),
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
