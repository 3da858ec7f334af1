// What a sample counts in a pixel's mean, and how far samples lie from it, which says what of a difference between pixels is noise
// (Schied et al. 2017, "Spatiotemporal Variance-Guided Filtering").
#if !defined INCLUDED_GI_NOISE
#define INCLUDED_GI_NOISE

#include "/include/math/color.glsl"
#include "/include/math/half.glsl"

// While the cache still fills, early frames are wrong rather than noisy: let them fade as the
// frames' number cubed instead of keeping them in a plain mean.
#if HAS_AIR_LIGHT || HAS_FACE_CACHE
const float history_ramp = 3.0;
#else
const float history_ramp = 1.0;
#endif

/// Weight of a sample in the mean of `count` with it.
float weight_of_sample(float count) { return history_ramp / (count - 1.0 + history_ramp); }

/// In the mean of so many a sample has this weight.
float samples_of_weight(float weight) { return history_ramp / weight + 1.0 - history_ramp; }

/// Squared distance of two lights, in units of luminance, in the channel where they differ most beside the light `about` them:
/// the edge of blue light in a red room is an edge.
float squared_distance(vec3 a, vec3 b, vec3 about) {
    float level = luminance(about);
    vec3 off = (a - b) * level / (about + 0.05 * level + 1e-9);
    off *= off;
    return max(max(off.r, off.g), off.b);
}

// The squared error of a mean falls by this power of the number of samples. With the face cache a pixel's rays follow a sequence;
// those of other methods are independent (1.0), so that the filter takes their long means for less noisy than they are and mixes less.
const float sequence_power = 1.3;

/// Standard deviation of a mean of `count` samples, over that of a sample.
float noise_left(float count) {
    // The sum of squared weights of a mean whose n-th sample has a weight of n^(history_ramp - 1).
    float of_ramp = history_ramp * history_ramp / (2.0 * history_ramp - 1.0);
    return min(1.0, sqrt(of_ramp) * pow(max(count, 1.0), -0.5 * sequence_power));
}

/// Noise of a mean (its standard deviation), with one more sample. `noise`: without it. `before`, `mean`: rgb the mean without and
/// with it, a how many samples are in it.
float noise_with(float noise, vec3 radiance, vec4 before, vec4 mean) {
    float deviation = noise / noise_left(before.a);
    // Over all of the mean's samples: of those that seldom find light, few say nothing of how far they lie apart.
    float variance = mix(deviation * deviation, squared_distance(radiance, before.rgb, mean.rgb), weight_of_sample(mean.a));
    return round_to_half(vec3(sqrt(variance) * noise_left(mean.a))).x;
}

#endif
