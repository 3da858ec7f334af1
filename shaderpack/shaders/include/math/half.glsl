// Half floats, as images store them.
#if !defined INCLUDED_MATH_HALF
#define INCLUDED_MATH_HALF

/// The half float next to a number that is not negative: 10 bits, below 2^-14 steps of 2^-24. Drivers
/// may cut a half float off instead of rounding it, and a loop amplifies that loss.
vec3 round_to_half(vec3 x) {
    vec3 normal = uintBitsToFloat((floatBitsToUint(x) + 0x1000u) & 0xFFFFE000u);
    vec3 small = floor(x * 16777216.0 + 0.5) / 16777216.0;
    return mix(normal, small, lessThan(x, vec3(1.0 / 16384.0)));
}

/// Light as targets keep it that many frames are averaged in, and the picture: floats from 256 frames on (include/buffers.glsl).
vec3 as_stored(vec3 x) {
#if HAS_LONG_MEANS
    return x;
#else
    return round_to_half(x);
#endif
}

/// A half float next to it, up or down by `chance` (0..1, at random), so that the mean of many is what it was.
vec3 dithered_half(vec3 x, float chance) {
    vec3 normal = uintBitsToFloat((floatBitsToUint(x) + uint(chance * 8192.0)) & 0xFFFFE000u);
    vec3 small = floor(x * 16777216.0 + chance) / 16777216.0;
    return mix(normal, small, lessThan(x, vec3(1.0 / 16384.0)));
}

#endif
