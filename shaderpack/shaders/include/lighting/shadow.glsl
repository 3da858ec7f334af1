// Sun and moon shadows by a map.
#if !defined INCLUDED_LIGHTING_SHADOW
#define INCLUDED_LIGHTING_SHADOW

#include "/include/lighting/shadow_space.glsl"

/// Where no map tells: the sky's level, 0..1, keeps the sun out of caves.
float unmapped_visibility(float sky) { return smoothstep(0.3, 0.6, sky); }

#if SHADOW_MAP

uniform sampler2D shadowtex1;

#if SHADOW_METHOD == MAP_PCF
const int shadow_radius = 1;
#else
const int shadow_radius = 0;
#endif

/// Receiver and bias for a surface: xyz texel position and depth 0..1, w depth to allow.
vec4 shadow_receiver(vec3 player, vec3 normal, vec3 light, int radius) {
    float cosine = clamp(dot(normal, light), 0.0, 1.0);
    float depth_per_block = 0.5 * abs(shadowProjection[2][2]);
#if SHADOW_BIAS == PUBLISHED
    // In depth, so it grows with the range of the light: shadows stand off their casters.
    float bias = max(0.05 * (1.0 - cosine), 0.005);
#else
    // The least offset along the normal that hides the slope of a plane within the filter,
    // (radius + 1/2) texels along the diagonal; never more than 2.12 texels.
    float texel = 2.0 * SHADOW_DISTANCE / float(shadow_map_size.y);
    float sine = sqrt(1.0 - cosine * cosine);
    player += normal * ((float(radius) + 0.5) * 1.4143 * texel * sine);
    float bias = 0.01 * depth_per_block;
#endif
    vec3 clip = (shadowProjection * (shadowModelView * vec4(player, 1.0))).xyz;
    vec3 unit = clip * 0.5 + 0.5;
    return vec4(unit.xy * vec2(shadow_map_size), unit.z, bias);
}

bool lit_at(ivec2 texel, float depth) {
    texel = clamp(texel, ivec2(0), shadow_map_size - 1);
    return depth <= texelFetch(shadowtex1, texel + ivec2(0, shadow_map_bottom), 0).r;
}

/// Share of the light that arrives, 0..1.
float light_visibility(vec3 player, vec3 normal, vec3 light, int radius, float sky) {
    vec4 receiver = shadow_receiver(player, normal, light, radius);
    bool outside = any(lessThan(receiver.xyz, vec3(0.0))) ||
                   any(greaterThan(receiver.xyz, vec3(shadow_map_size, 1.0)));
    ivec2 texel = ivec2(floor(receiver.xy));
    float lit = 0.0;
    for (int y = -radius; y <= radius; ++y)
        for (int x = -radius; x <= radius; ++x)
            lit += float(lit_at(texel + ivec2(x, y), receiver.z - receiver.w));
    float taps = float((2 * radius + 1) * (2 * radius + 1));
    return outside ? unmapped_visibility(sky) : lit / taps;
}

#else

const int shadow_radius = 0;

float light_visibility(vec3 player, vec3 normal, vec3 light, int radius, float sky) {
    return unmapped_visibility(sky);
}

#endif

#endif
