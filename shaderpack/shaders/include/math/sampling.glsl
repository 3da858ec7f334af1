// Directions about a normal.
#if !defined INCLUDED_MATH_SAMPLING
#define INCLUDED_MATH_SAMPLING

const float pi = 3.14159265;

vec3 sphere_direction(vec2 u) {
    float z = 1.0 - 2.0 * u.x;
    float phi = 2.0 * pi * u.y;
    return vec3(sqrt(max(0.0, 1.0 - z * z)) * vec2(cos(phi), sin(phi)), z);
}

/// Density cos/pi: a point of the unit sphere resting on the plane.
vec3 cosine_direction(vec3 n, vec2 u) {
    // 0.9999 keeps the sum off zero for the direction opposite to the normal.
    return normalize(n + 0.9999 * sphere_direction(u));
}

/// Density 1/(2 pi).
vec3 hemisphere_direction(vec3 n, vec2 u) {
    vec3 direction = sphere_direction(u);
    return dot(direction, n) < 0.0 ? -direction : direction;
}

#endif
