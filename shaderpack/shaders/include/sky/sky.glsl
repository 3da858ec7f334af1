// Sun, moon and sky: a gradient, not an atmosphere. Radiance in units where a white wall in the
// noon sun is SUN_STRENGTH / pi.
#if !defined INCLUDED_SKY_SKY
#define INCLUDED_SKY_SKY

#include "/include/uniforms.glsl"

/// Direction to the sun or, at night, the moon; world axes.
vec3 light_direction() {
    return normalize(mat3(gbufferModelViewInverse) * shadowLightPosition);
}

vec3 sun_direction() { return normalize(mat3(gbufferModelViewInverse) * sunPosition); }

/// 0 at night, 1 by day.
float daylight() { return smoothstep(-0.12, 0.12, sun_direction().y); }

/// Irradiance on a plane that faces the sun or the moon.
vec3 light_irradiance() {
    float height = sun_direction().y;
    // Both fade out at the horizon, where shadowLightPosition changes from one to the other.
    float fade = smoothstep(0.0, 0.06, abs(height));
    vec3 sun = mix(vec3(1.0, 0.45, 0.15), vec3(1.0, 0.93, 0.83), smoothstep(0.0, 0.4, height));
    vec3 moon = vec3(0.010, 0.014, 0.024);
    return (height > 0.0 ? sun : moon) * (SUN_STRENGTH * fade * (1.0 - 0.8 * rainStrength));
}

vec3 sky_zenith() {
    return SKY_STRENGTH * mix(vec3(0.002, 0.003, 0.007), vec3(0.22, 0.42, 0.90), daylight());
}

vec3 sky_horizon() {
    return SKY_STRENGTH * mix(vec3(0.004, 0.006, 0.010), vec3(0.68, 0.82, 0.98), daylight());
}

/// Radiance from a direction; below the horizon a ground that reflects a third.
vec3 sky_radiance(vec3 direction) {
    vec3 above = mix(sky_horizon(), sky_zenith(), sqrt(clamp(direction.y, 0.0, 1.0)));
    vec3 sun = sun_direction();
    float dusk = daylight() * (1.0 - smoothstep(0.1, 0.35, abs(sun.y)));
    float toward = 0.5 + 0.5 * dot(direction, sun);
    above += SKY_STRENGTH * dusk * toward * toward * (1.0 - clamp(direction.y, 0.0, 1.0)) *
             vec3(0.7, 0.22, 0.02);
    return above * mix(1.0, 0.33, smoothstep(0.0, 0.08, -direction.y));
}

/// Mean radiance over the hemisphere of a normal under an open sky: sky_radiance in its upper
/// half, the ground in the lower one.
vec3 sky_ambient(vec3 normal) {
    vec3 dome = mix(sky_horizon(), sky_zenith(), 0.6);
    return dome * mix(0.33, 1.0, 0.5 + 0.5 * normal.y);
}

#endif
