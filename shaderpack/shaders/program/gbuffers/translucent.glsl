// Water, glass, weather (PROGRAM_WEATHER) and clouds (PROGRAM_CLOUDS): lit where they are drawn, blended over the lit
// scene.
#include "/settings.glsl"
#include "/include/block_vertex.glsl"
#include "/include/blocks.glsl"

#if defined VERTEX_STAGE

#if HAS_TRANSLUCENT_RAYS
#include "/include/gi/rest.glsl"

flat out int drawing;
flat out vec2 band;
#endif
out vec3 player;
flat out float is_water;
flat out float emission;  // level 0..15
#if HAS_FACE_CACHE && !HAS_LAMPS
flat out vec3 block;  // its middle, player space
#endif

void main() {
    int id = place_vertex();
#if defined PROGRAM_CLOUDS
    // They have no light levels, which reads as full; no lamp reaches them.
    light = vec2(0.0, 1.0);
#endif
    player = (gbufferModelViewInverse * (gl_ModelViewMatrix * gl_Vertex)).xyz;
#if HAS_FACE_CACHE && !HAS_LAMPS
    block = player + at_midBlock.xyz / 64.0;
#endif
#if HAS_TRANSLUCENT_RAYS
    drawing = number_of_drawing();
    band = next_band();
#endif
    is_water = float(id == block_water);
    emission = block_emission(id, at_midBlock.w);
}

#else

#if HAS_LAMPS || HAS_VOXEL_CHANGES
#extension GL_ARB_shader_image_load_store : enable
#endif
#if HAS_VOXELS
#define HAS_VOXEL_READS
#endif
#include "/include/math/color.glsl"
#include "/include/gi/ambient.glsl"
#include "/include/brdf/direct.glsl"
#include "/include/shadow/shadow.glsl"
#if HAS_WATER_WAVES
#include "/include/water/waves.glsl"
#endif
#if HAS_LAMPS
#include "/include/lights/lit_by_lamps.glsl"
#endif
#if HAS_AIR_LIGHT
#include "/include/floodfill/light_field.glsl"
#endif
#if HAS_FACE_CACHE
#include "/include/face_cache/face_lookup.glsl"
#include "/include/gi/hit.glsl"
#include "/include/voxels/tiles.glsl"

vec4 light_of(ivec3 cell, int face) { return cached_light(cell, face); }
#include "/include/face_cache/path_end.glsl"
#endif
#if HAS_TRANSLUCENT_RAYS
#include "/include/gi/gather.glsl"

flat in int drawing;
flat in vec2 band;
#endif
#if HAS_TRANSLUCENT_MEANS
#include "/include/gi/history.glsl"

uniform sampler2D colortex10;
uniform sampler2D colortex11;
#endif

in vec3 player;
flat in float is_water;
flat in float emission;
#if HAS_FACE_CACHE && !HAS_LAMPS
flat in vec3 block;
#endif

uniform sampler2D gtexture;

#if HAS_TRANSLUCENT_MEANS
/* RENDERTARGETS: 0,12,13 */
layout(location = 1) out vec4 out_mean;
layout(location = 2) out vec4 out_plane;
#else
/* RENDERTARGETS: 0 */
#endif
layout(location = 0) out vec4 out_color;

/// Mean radiance over the hemisphere, without rays: with floodfill, lamps from its cells instead of the lightmap;
/// with the face cache, that of the block's face. Both hold the lamps' light, which lamps of a list add themselves.
vec3 expected_radiance(vec3 n) {
#if HAS_AIR_LIGHT && !HAS_LAMPS
    vec3 position = to_volume(player);
    if (in_volume(ivec3(floor(position))))
        return ambient_radiance(vec2(0.0, light.y), n) +
               light_solid_aware(position, n) * FLOODFILL_STRENGTH;
#endif
    vec2 levels = light;
#if HAS_LAMPS
    levels.x *= unlisted_share(player);
#endif
    vec3 lightmap = ambient_radiance(levels, n);
#if HAS_FACE_CACHE && !HAS_LAMPS
    vec3 middle = to_volume(block);
    vec4 cached = light_at(to_volume(player), ivec3(floor(middle)), face_of(n));
    float share = cached.a > 0.0 ? inside_volume(middle) : 0.0;
    return mix(lightmap, cached.rgb + AMBIENT_MINIMUM, share);
#else
    return lightmap;
#endif
}

#if HAS_TRANSLUCENT_RAYS
/// Mean of this frame's rays.
vec3 gathered_radiance(Surface s) {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    seed_random(pixel, frameCounter);
    vec3 light = light_direction();
    vec3 radiance = vec3(0.0);
    int i = 0;
    do {
        int number = drawing * GI_SAMPLES + i;
#if HAS_LAMP_RAYS
        bool aimed = listed_lamps() > 0u && is_turn_of_lamps(pixel, number);
#else
        const bool aimed = false;
#endif
        radiance += gather(s, pixel, light, number, aimed);
    } while (++i < GI_SAMPLES);
    return radiance / float(GI_SAMPLES);
}
#endif

#if HAS_TRANSLUCENT_MEANS
// A surface that the frame before has not seen begins as if what is expected were the mean of so many frames: what a cache
// knows is near the mean; the lightmap is not, and a plain mean of frames would keep it.
#if HAS_FACE_CACHE
const float expected_frames = 16.0;
#else
const float expected_frames = 1.0;
#endif

/// Mean over frames at this pixel. There is room for one surface, the nearest, which is drawn last: what lies behind it keeps
/// what is expected, since rays without a mean would flicker. `expected`: radiance without rays.
vec3 mean_radiance(Surface s, vec3 expected) {
    Before before = before_of(s);
    vec4 mean = history(colortex10, colortex11, before.pixel, before.plane);
    bool is_new = mean.a == 0.0;
    if (is_new) mean = vec4(expected - AMBIENT_MINIMUM, expected_frames);
    // Where the picture rests, what the next frame does not keep is not gathered.
    bool gathers = is_new ? !was_hidden(colortex11, before) : in_band(band, gl_FragCoord.y);
    if (gathers) mean = accumulate(gathered_radiance(s), mean);
    out_mean = mean;
    out_plane = with_stamp(surface_plane(s.player, s.normal));
#ifdef GI_FILTER
    // Smoothed for the eye alone, within the face.
    vec4 sum = vec4(mean.rgb, 1.0);
    for (int i = 0; i < 25; ++i) {
        ivec2 offset = ivec2(i % 5, i / 5) - 2;
        if (offset == ivec2(0)) continue;
        vec4 near = history(colortex10, colortex11, before.pixel + offset, before.plane);
        sum += float(near.a > 0.0) * vec4(near.rgb, 1.0);
    }
    return sum.rgb / sum.a;
#else
    return mean.rgb;
#endif
}
#endif

/// Mean radiance over the hemisphere, without the direct sun.
vec3 indirect_radiance(vec3 n) {
    vec3 expected = expected_radiance(n);
#if HAS_TRANSLUCENT_RAYS
#if HAS_TRANSLUCENT_MEANS
    out_mean = vec4(0.0);
    out_plane = vec4(0.0);
#endif
    Surface s = Surface(player, n, vec3(0.0), light, emission, false, 0, false);
    float share = inside_volume(to_volume(player));
    if (share <= 0.0) return expected;
#if HAS_TRANSLUCENT_MEANS
    vec3 seen = mean_radiance(s, expected);
#else
    vec3 seen = gathered_radiance(s);
#endif
    return mix(expected, seen + AMBIENT_MINIMUM, share);
#else
    return expected;
#endif
}

#if HAS_FACE_CACHE
const int mirrored_layers = 3;

/// How much a hit hides of what is behind it, as it is drawn. `water`: what water does.
float drawn_alpha(Hit hit, float water) {
    if (!hit.found || !is_filter_voxel(hit.voxel.code)) return 1.0;
    uint tile = tile_of(hit.cell);
    vec2 place = place_in_tile(tile, place_on_side(hit.position - vec3(hit.cell), hit.normal));
    return tile == 0u ? water : textureLod(gtexture, place, 0.0).a;
}

/// What a mirror shows of the voxels from a point on: translucent blocks blended over what is behind them, as the eye sees them.
vec3 mirrored_scene(vec3 from, vec3 direction, vec3 l, float water) {
    vec3 radiance = vec3(0.0);
    float share = 1.0;
    int code = voxel_air;
    for (int i = 0; i < mirrored_layers; ++i) {
        Hit hit = trace(from, direction, code, ray_of_eye);
        float alpha = i == mirrored_layers - 1 ? 1.0 : drawn_alpha(hit, water);
        vec3 seen = lamp_light(hit, from, direction) + light_of_end(hit, from, direction, light.y);
#if DIRECT_LIGHT != NONE
        if (hit.found) seen += albedo_of(hit) * sun_at(hit, direction, l, light.y);
#endif
        radiance += share * alpha * seen;
        share *= 1.0 - alpha;
        if (share == 0.0) break;
        from = hit.position - hit.normal * face_offset;
        code = hit.voxel.code;
    }
    return radiance;
}
#endif

/// What water mirrors: the scene, as the voxels know it, or the sky where that reaches it. `alpha`: of the water.
vec3 mirrored_radiance(vec3 n, vec3 direction, vec3 l, float alpha) {
#if HAS_FACE_CACHE
    vec3 position = to_volume(player);
    if (inside_volume(position) > 0.0) return mirrored_scene(position + n * pixel_offset(player), direction, l, alpha);
#endif
    return sky_radiance(direction) * light.y * light.y;
}

void main() {
#ifdef SHADOW_VIEW
    discard;
#endif
#if HAS_VOXEL_VIEW
    discard;
#endif
    vec4 color = texture(gtexture, uv) * vec4(tint.rgb, 1.0);
#if defined PROGRAM_WEATHER
    color.a *= tint.a;  // fades with distance; of blocks alpha is occlusion
#endif
    if (color.a < alphaTestRef) discard;
    vec3 albedo = to_linear(color.rgb);

    vec3 v = -normalize(player);
#if defined PROGRAM_CLOUDS
    // Light goes through them: sides differ by the shades that the game gives them.
    vec3 n = vec3(0.0, 1.0, 0.0);
#else
    vec3 n = dot(normal, v) < 0.0 ? -normal : normal;
#endif
    vec3 l = light_direction();
    vec3 mirror = n;  // normal of what mirrors
#if HAS_WATER_WAVES
    Waves waves = waves_at(player);
    bool has_waves = is_water > 0.0 && abs(n.y) > 0.5;
    if (has_waves) mirror = n.y > 0.0 ? waves.normal : -waves.normal;
#endif
    float level = emission / 15.0;
    vec3 radiance = albedo * (EMISSION_STRENGTH * level * level + indirect_radiance(n));
#if DIRECT_LIGHT != NONE
    vec3 sun = light_irradiance() * light_visibility(player, n, l, shadow_radius, light.y);
    radiance += sun * reflect_direct(albedo, n, v, l);
#endif
#if HAS_LAMPS
    radiance += lamps_radiance(player, n, 0.0, albedo);
#endif

    // Fresnel: Schlick, reflectance 0.02.
    float fresnel = is_water * (0.02 + 0.98 * pow(1.0 - clamp(dot(mirror, v), 0.0, 1.0), 5.0));
    if (fresnel > 0.0) {
        vec3 direction = reflect(-v, mirror);
        // Waves that turn away from the eye would mirror what is below.
        direction -= 2.0 * min(dot(direction, n), 0.0) * n;
        radiance = mix(radiance, mirrored_radiance(n, direction, l, color.a), fresnel);
    }
#if HAS_WATER_WAVES && DIRECT_LIGHT != NONE
    if (has_waves) radiance += sun * wave_highlight(mirror, waves.variance, v, l);
#endif
    out_color = vec4(radiance, mix(color.a, 1.0, fresnel));
}

#endif
