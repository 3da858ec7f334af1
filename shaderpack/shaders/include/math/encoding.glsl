// Numbers in bytes, and unit vectors in two of them. Octahedral map of Cigolle et al. 2014, "A Survey of Efficient
// Representations for Independent Unit Vectors"; zero is byte 128, so that the six axes of a block
// world come back exactly.
#if !defined INCLUDED_MATH_ENCODING
#define INCLUDED_MATH_ENCODING

/// Numbers 0..1 as bytes hold them, up or down by `at` (0..1, at random): so the mean of many is what they were.
vec3 in_bytes(vec3 x, float at) { return floor(x * 255.0 + at) / 255.0; }

vec2 sign_not_zero(vec2 v) { return vec2(v.x >= 0.0 ? 1.0 : -1.0, v.y >= 0.0 ? 1.0 : -1.0); }

vec2 encode_normal(vec3 n) {
    vec2 p = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
    if (n.z < 0.0) p = (1.0 - abs(p.yx)) * sign_not_zero(p);
    return (p * 127.0 + 128.0) / 255.0;
}

vec3 decode_normal(vec2 stored) {
    vec2 p = (floor(stored * 255.0 + 0.5) - 128.0) / 127.0;
    vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    if (n.z < 0.0) n.xy = (1.0 - abs(n.yx)) * sign_not_zero(n.xy);
    return normalize(n);
}

#endif
