// Sun and moon shadows by a map.
#if !defined INCLUDED_SHADOW_SHADOW
#define INCLUDED_SHADOW_SHADOW

#include "/include/shadow/shadow_space.glsl"

/// Where there is no map: the sky's level, 0..1, keeps the sun out of caves.
float unmapped_visibility(float sky) { return smoothstep(0.3, 0.6, sky); }

#if HAS_SHADOW_MAP

#if SHADOW_COMPARE == SHADOW_COMPARE_HARDWARE
const bool shadowHardwareFiltering1 = true;
uniform sampler2DShadow shadowtex1;
#else
uniform sampler2D shadowtex1;
#endif

#if SHADOW_METHOD == SHADOW_METHOD_MAP
const int shadow_radius = 0;
#else
const int shadow_radius = 1;
#endif

/// How far from its middle a tap reads, in texels.
const float shadow_tap = SHADOW_COMPARE == SHADOW_COMPARE_HARDWARE ? 1.0 : 0.5;

/// Receiver and bias for a surface: xyz texel position and depth 0..1, w depth to allow.
vec4 shadow_receiver(vec3 player, vec3 normal, vec3 light, int radius) {
    float cosine = clamp(dot(normal, light), 0.0, 1.0);
    float depth_per_block = 0.5 * abs(shadowProjection[2][2]);
#if SHADOW_BIAS == PUBLISHED
    // In depth, so it grows with the range of the light: shadows stand off their casters.
    float bias = max(0.05 * (1.0 - cosine), 0.005);
#else
    // The least offset along the normal that hides the slope of a plane within the filter, along
    // the diagonal of the texels; bounded, as the sine is.
    vec2 middle = (shadowProjection * (shadowModelView * vec4(player, 1.0))).xy;
    float reach = (float(radius) + shadow_tap) * 1.4143 * shadow_texel(middle + shadow_snap());
    player += normal * (reach * sqrt(1.0 - cosine * cosine));
    float bias = 0.01 * depth_per_block;
#endif
    vec4 clip = shadow_clip(shadowProjection * (shadowModelView * vec4(player, 1.0)));
    vec3 unit = clip.xyz * 0.5 + 0.5;
    return vec4(unit.xy * vec2(shadow_map_size), unit.z, bias);
}

/// Share of one tap that is lit. `position` in texels of the map.
float lit_at(vec2 position, float depth) {
#if SHADOW_COMPARE == SHADOW_COMPARE_HARDWARE
    // Of four texels; none may be a row of the voxels.
    position = clamp(position, vec2(0.5), vec2(shadow_map_size) - 0.5);
    vec2 uv = (position + vec2(0.0, shadow_map_bottom)) / float(SHADOW_TARGET);
    return texture(shadowtex1, vec3(uv, depth));
#else
    ivec2 texel = clamp(ivec2(floor(position)), ivec2(0), shadow_map_size - 1);
    return float(depth <= texelFetch(shadowtex1, texel + ivec2(0, shadow_map_bottom), 0).r);
#endif
}

/// The middle of the texel of the map into which a point of a plane falls, and the plane's depth there, 0..1. What is
/// compared lies in the plane: no offset that would hide its slope moves the edges of shadows, which a low sun would
/// carry on by blocks (Isidoro 2006, "Shadow Mapping: GPU-based Tips and Techniques"). Where the light is so aslant that the
/// middle would lie a block away, in the open beyond a wall, the point is moved off its plane instead.
vec3 plane_receiver(vec3 player, vec3 normal, vec3 light) {
    vec4 view = shadowModelView * vec4(player, 1.0);
    vec3 across = mat3(shadowModelView) * normal;
    vec2 clip = (shadowProjection * view).xy;
    vec2 size = vec2(shadow_map_size);
    if (across.z < 0.8 * shadow_texel(clip + shadow_snap()))
        return shadow_receiver(player, normal, light, 0).xyz;
    vec2 texel = floor((distort_shadow(clip + shadow_snap()) * 0.5 + 0.5) * size);
    vec2 middle = straighten_shadow((texel + 0.5) / size * 2.0 - 1.0) - shadow_snap();
    vec2 off = (middle - clip) / vec2(shadowProjection[0][0], shadowProjection[1][1]);
    view.z -= dot(off, across.xy) / across.z;
    return vec3(texel + 0.5, (shadowProjection * view).z * 0.5 + 0.5);
}

/// Does light arrive at a point of a plane that rays have hit?
float point_visibility(vec3 player, vec3 normal, vec3 light, float sky) {
    vec3 receiver = plane_receiver(player, normal, light);
    bool outside = any(lessThan(receiver, vec3(0.0))) ||
                   any(greaterThanEqual(receiver, vec3(shadow_map_size, 1.0)));
    float bias = 0.005 * abs(shadowProjection[2][2]);  // a hundredth of a block
    return outside ? unmapped_visibility(sky) : lit_at(receiver.xy, receiver.z - bias);
}

/// Share of the light that arrives, 0..1.
float light_visibility(vec3 player, vec3 normal, vec3 light, int radius, float sky) {
    vec4 receiver = shadow_receiver(player, normal, light, radius);
    bool outside = any(lessThan(receiver.xyz, vec3(0.0))) ||
                   any(greaterThan(receiver.xyz, vec3(shadow_map_size, 1.0)));
    float lit = 0.0;
    for (int y = -radius; y <= radius; ++y)
        for (int x = -radius; x <= radius; ++x)
            lit += lit_at(receiver.xy + vec2(x, y), receiver.z - receiver.w);
    float taps = float((2 * radius + 1) * (2 * radius + 1));
    return outside ? unmapped_visibility(sky) : lit / taps;
}

#if HAS_SHADOW_VOLUMES && defined HAS_VOXEL_READS
#include "/include/shadow/sheets.glsl"
#include "/include/voxels/voxel.glsl"

/// Share of the light that passes what has no shadow volume: glass, panes, plants.
float open_share(vec3 player, vec3 normal, vec3 light) {
    const int radius = 1;
    vec4 receiver = shadow_receiver(player, normal, light, radius);
    float lit = 0.0;
    for (int y = -radius; y <= radius; ++y) {
        for (int x = -radius; x <= radius; ++x) {
            vec2 position = receiver.xy + vec2(x, y);
            ivec2 texel = clamp(ivec2(floor(position)), ivec2(0), shadow_map_size - 1);
            bool holes = has_holes(texelFetch(shadowcolor0, texel + ivec2(0, shadow_map_bottom), 0));
            lit += holes ? lit_at(position, receiver.z - receiver.w) : 1.0;
        }
    }
    return lit / float((2 * radius + 1) * (2 * radius + 1));
}
#endif

#else

const int shadow_radius = 0;

float light_visibility(vec3 player, vec3 normal, vec3 light, int radius, float sky) {
    return unmapped_visibility(sky);
}

float point_visibility(vec3 player, vec3 normal, vec3 light, float sky) { return unmapped_visibility(sky); }

#endif

#endif
