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

/// A plane as the map sees it about one of its points. What is compared lies in the plane: no offset that would hide its
/// slope moves the edges of shadows, which a low sun would carry on by blocks (Isidoro 2006, "Shadow Mapping: GPU-based Tips
/// and Techniques"). Where the light is so aslant that the middle of a texel would lie a block away, in the open beyond a
/// wall, the point is moved off its plane instead.
struct PlaneInMap {
    vec3 view;      // the point in the light's view space
    vec2 slope;     // of the plane's depth there; x and y per block
    vec2 clip;      // the point before the distortion
    vec2 position;  // in texels
};

PlaneInMap plane_in_map(vec3 player, vec3 normal) {
    vec3 across = mat3(shadowModelView) * normal;
    vec2 scale = vec2(shadowProjection[0][0], shadowProjection[1][1]);
    PlaneInMap plane;
    plane.view = (shadowModelView * vec4(player, 1.0)).xyz;
    float texel = shadow_texel(plane.view.xy * scale + shadow_snap());
    bool aslant = across.z < 0.8 * texel;
    plane.view += aslant ? across * (shadow_tap * 1.4143 * texel) : vec3(0.0);
    plane.slope = aslant ? vec2(0.0) : across.xy / across.z;
    plane.clip = plane.view.xy * scale;
    plane.position = (distort_shadow(plane.clip + shadow_snap()) * 0.5 + 0.5) * vec2(shadow_map_size);
    return plane;
}

vec2 middle_of_texel(vec2 texel) {
    return straighten_shadow((texel + 0.5) / vec2(shadow_map_size) * 2.0 - 1.0) - shadow_snap();
}

/// The plane's depth in the middle of a texel, 0..1.
float depth_in_texel(PlaneInMap plane, vec2 texel) {
    vec2 off = (middle_of_texel(texel) - plane.clip) / vec2(shadowProjection[0][0], shadowProjection[1][1]);
    float z = plane.view.z - dot(off, plane.slope);
    return (shadowProjection[2][2] * z + shadowProjection[3][2]) * 0.5 + 0.5;
}

/// What is allowed for the rounding of depths: a hundredth of a block.
float plane_bias() { return 0.005 * abs(shadowProjection[2][2]); }

/// Does light arrive at a point of a plane, as the texel says into which it falls? `depth`: the plane's there.
float point_visibility(PlaneInMap plane, float depth, float sky) {
    bool outside = any(lessThan(plane.position, vec2(0.0))) || any(greaterThanEqual(plane.position, vec2(shadow_map_size))) ||
                   depth < 0.0 || depth >= 1.0;
    return outside ? unmapped_visibility(sky) : lit_at(floor(plane.position) + 0.5, depth - plane_bias());
}

#if SHADOW_COMPARE == SHADOW_COMPARE_TEXEL
/// The edge of a shadow, where it passes between the four texels of the map about a point of a plane.
struct EdgeInMap {
    bool found;
    bool dark;    // is one of the texels?
    vec3 caster;  // player space: what throws the shadow
    vec3 lit;     // a texel that has light, and the plane's depth there
};

EdgeInMap edge_in_map(PlaneInMap plane) {
    vec2 own = floor(plane.position);
    vec2 aside = mix(vec2(-1.0), vec2(1.0), step(0.5, plane.position - own));
    vec3 dark = vec3(-1.0);
    vec3 lit = vec3(-1.0);
    // Of each kind that nearest to the point counts, which comes last.
    for (int i = 3; i >= 0; --i) {
        vec2 texel = clamp(own + aside * vec2(i & 1, i >> 1), vec2(0.0), vec2(shadow_map_size) - 1.0);
        float stored = texelFetch(shadowtex1, ivec2(texel) + ivec2(0, shadow_map_bottom), 0).r;
        float depth = depth_in_texel(plane, texel);
        bool is_lit = depth - plane_bias() <= stored;
        lit = is_lit ? vec3(texel, depth) : lit;
        dark = is_lit ? dark : vec3(texel, stored);
    }
    vec2 scale = vec2(shadowProjection[0][0], shadowProjection[1][1]);
    // A little away from the light, into what throws the shadow: its very edge may lie in the middle of the texel.
    vec2 inside = middle_of_texel(dark.xy + 0.25 * (dark.xy - (lit.x < 0.0 ? dark.xy : lit.xy)));
    vec3 view = vec3(inside / scale, (dark.z * 2.0 - 1.0 - shadowProjection[3][2]) / shadowProjection[2][2]);
    return EdgeInMap(min(dark.x, lit.x) >= 0.0, dark.x >= 0.0, (shadowModelViewInverse * vec4(view, 1.0)).xyz, lit);
}
#endif

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

#endif

#endif
