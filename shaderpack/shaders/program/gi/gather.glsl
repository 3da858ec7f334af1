// Light from everything but the direct sun: GI_SAMPLES rays a pixel through the voxels, averaged
// with the frames before. Radiance is constant along a ray, so nothing is divided by distance.
#include "/settings.glsl"

#if defined VERTEX_STAGE

#include "/include/gi/rest.glsl"

#if HAS_FACE_CACHE
flat out int drawing;
#endif

void main() {
    gl_Position = drawn_corner(ftransform());
#if HAS_FACE_CACHE
    drawing = number_of_drawing();
#endif
}

#else

#if HAS_VOXEL_CHANGES
#extension GL_ARB_shader_image_load_store : enable
#endif

#define HAS_GBUFFER_READS
#define HAS_VOXEL_READS
#include "/include/gbuffer.glsl"
#include "/include/plane.glsl"
#include "/include/math/half.glsl"
#include "/include/math/random.glsl"
#include "/include/gi/hit.glsl"
#include "/include/gi/rest.glsl"
#if HAS_AIR_LIGHT
#include "/include/floodfill/light_field.glsl"
#endif
#if HAS_FACE_CACHE
layout(rgba16f) uniform readonly image3D face_light;
layout(r32ui) uniform readonly uimage2D face_memory;
#include "/include/face_cache/face_cache.glsl"

/// B of a face, and its number of updates.
vec4 light_of(ivec3 cell, int face) { return trusted(imageLoad(face_light, face_texel(cell, face))); }
#endif
#include "/include/gi/leaves.glsl"
#if HAS_GLOSSY
#include "/include/brdf/glossy.glsl"

uniform sampler2D colortex8;
#endif
#if HAS_LAMP_RAYS
layout(r32ui) uniform readonly uimage2D face_list;
layout(r32ui) uniform readonly uimage2D face_tally;
const int lamp_candidates = 4;
#include "/include/lights/lamp_sample.glsl"
#endif

#if HAS_LAMPS
#include "/include/lights/lamps.glsl"
#endif

#if GI_METHOD == GI_METHOD_BOUNCE_4
const int gi_bounces = 4;
#elif GI_METHOD == GI_METHOD_BOUNCE_2 || HAS_FACE_CACHE
const int gi_bounces = 2;
#else
const int gi_bounces = 1;
#endif

#if HAS_FACE_CACHE
flat in int drawing;
#endif

uniform sampler2D colortex3;
uniform sampler2D colortex5;

#if HAS_GLOSSY
/* RENDERTARGETS: 3,5,8 */
layout(location = 2) out vec4 out_mirrored;
#else
/* RENDERTARGETS: 3,5 */
#endif
layout(location = 0) out vec4 out_radiance;
layout(location = 1) out vec4 out_plane;

/// Does deferred4 add the light of a lamp that the ray from the pixel hits here?
bool lit_directly(int bounce, vec3 position) {
#if HAS_LAMPS
    return bounce == 0 && in_lamp_volume(ivec3(floor(to_lamp_space(from_volume(position)))));
#else
    return false;
#endif
}

/// Plants and leaves look to either side by chance: turns the normal of half of the rays round.
/// Returns what counts for the light that comes from there.
vec3 choose_side(Surface s, inout vec3 normal) {
    if (!s.thin) return vec3(1.0);
    if (next_random().x < 0.5) return vec3(2.0);
    normal = -normal;
    return 2.0 * passed_share(s.albedo);
}

/// One sample of the mean incoming radiance, the pixel's n-th over all frames.
vec3 gather(Surface s, vec3 light, int number) {
    vec3 normal = s.normal;
    vec3 throughput = choose_side(s, normal);
    vec3 origin = to_volume(s.player) + normal * pixel_offset(s.player);
    vec3 radiance = vec3(0.0);
    begins_on_lamp = s.emission > 0.0;
#if HAS_LAMP_RAYS
    // Rays into the hemisphere and to lamps take turns, over frames and over squares of 4 x 4 pixels: processors draw these
    // together, so that what either kind of ray costs is spent on half of the picture.
    uint lamps = listed_lamps();
    ivec2 square = ivec2(gl_FragCoord.xy) / 4;
    int turn = number + square.x + square.y;
    bool aimed = lamps > 0u && (turn & 1) == 1;
    if (lamps > 0u) number = turn >> 1;
#endif
    for (int bounce = 0; bounce < gi_bounces; ++bounce) {
        vec2 u = next_random().xy;
#if HAS_FACE_CACHE
        if (bounce == 0) u = spread_point(ivec2(gl_FragCoord.xy), number);
#endif
        vec3 direction = cosine_direction(normal, u);
        vec3 from = origin;
#if HAS_LAMP_RAYS
        LampSample lamp;
        for (int i = 0; i < int(aimed); ++i) {
            lamp = choose_lamp(Receiver(origin, normal), lamps, u);
            direction = lamp.direction;
        }
        Hit hit = trace_from_face(from, direction);
        if (lamps > 0u) throughput *= 2.0;
        if (aimed) {
            if (hit.found && hit.cell == lamp.cell) radiance += throughput * hit.transmittance * lamp.light;
            break;
        }
#else
        Hit hit = trace_from_face(from, direction);
#endif
        for (int i = 0; i < int(s.thin && bounce == 0 && begins_in_leaves(origin)); ++i)
            radiance += throughput * light_of_leaves(origin, direction, light, s.light.y);
        throughput *= hit.transmittance;
        if (!hit.found) {
            radiance += throughput * sky_beyond(hit, direction, s.light.y);
            break;
        }
        if (is_lamp_voxel(hit.voxel.code)) {
#if HAS_LAMP_RAYS
            radiance += throughput * met_lamp(hit, Receiver(origin, normal), direction);
#else
            radiance += throughput * lamp_light(hit.voxel) *
                        float(!lit_directly(bounce, hit.position));
#endif
        }
        normal = hit.normal;
        origin = hit.position + normal * face_offset;
        begins_on_lamp = false;
        throughput *= voxel_albedo(hit.voxel);
        radiance += throughput * sun_at(hit, light, s.light.y);
#if HAS_AIR_LIGHT
        // The cells before a lamp hold its own light: what it reflects is not known.
        if (is_lamp_voxel(hit.voxel.code)) break;
        radiance += throughput * light_at_face(hit.position, normal, next_random().xy) *
                    FLOODFILL_STRENGTH;
#elif HAS_FACE_CACHE
        // From so near the mean of a face is not what is seen of it: gathered anew, as final gathering with photon
        // maps does (Jensen 2001, "Realistic Image Synthesis Using Photon Mapping").
        if (bounce == 0 && (distance(hit.position, from) < FACE_NEAR || faces_stained_glass(hit))) {
#if HAS_LAMP_RAYS
            aimed = lamps > 0u && next_random().x < 0.5;
#endif
            continue;
        }
        radiance += throughput * light_of(hit.cell, face_of_hit(hit)).rgb;
        break;
#endif
        // A loop that is not known to end here costs a quarter more on llvmpipe.
        if (gi_bounces == 1) break;
    }
    return radiance;
}

#if HAS_GLOSSY
/// One sample of what a polished block or a metal mirrors.
vec3 mirrored(Surface s, vec3 light) {
    vec3 v = -normalize(s.player);
    float alpha = gloss_alpha(s.gloss);
    vec3 facet = ggx_facet(s.normal, v, alpha, next_random().xy);
    vec3 direction = reflect(-v, facet);
    vec3 weight = gloss_fresnel(s.gloss, s.albedo, dot(v, facet)) *
                  ggx_masking(dot(s.normal, direction), alpha);
    Hit hit = trace_from_face(to_volume(s.player) + s.normal * pixel_offset(s.player), direction);
    weight *= hit.transmittance;
    if (!hit.found) return weight * sky_beyond(hit, direction, s.light.y);
    vec3 lamp = is_lamp_voxel(hit.voxel.code) ? lamp_light(hit.voxel) : vec3(0.0);
    vec3 cached = light_of(hit.cell, face_of_hit(hit)).rgb;
    return weight * (lamp + voxel_albedo(hit.voxel) * (sun_at(hit, light, s.light.y) + cached));
}
#endif

#ifdef TEMPORAL_ACCUMULATION

/// What earlier frames found for this surface: rgb, and how many of them; 0 where it was not seen.
vec4 history(Surface s) {
    vec3 player = s.player + (cameraPosition - previousCameraPosition);
    vec4 clip = gbufferPreviousProjection * (gbufferPreviousModelView * vec4(player, 1.0));
    vec2 uv = clip.xy / clip.w * 0.5 + 0.5;
    ivec2 pixel = ivec2(floor(uv * vec2(viewWidth, viewHeight)));
    bool on_screen = clip.w > 0.0 && all(greaterThanEqual(uv, vec2(0.0))) &&
                     all(lessThan(uv, vec2(1.0)));
    if (!on_screen) return vec4(0.0);

    vec4 before = texelFetch(colortex5, pixel, 0);
    bool same = same_plane(before, surface_plane(player, s.normal));
    return same ? texelFetch(colortex3, pixel, 0) : vec4(0.0);
}

// While the cache still fills, early frames are wrong rather than noisy: let them fade as the
// frames' number cubed instead of keeping them in a plain mean.
#if HAS_AIR_LIGHT || HAS_FACE_CACHE
const float history_ramp = 3.0;
#else
const float history_ramp = 1.0;
#endif

vec4 accumulate(vec3 radiance, vec4 before) {
#if HAS_FACE_CACHE
    if (light_changes(imageLoad(face_memory, memory_last).r))
        before.a = min(before.a, face_edited_updates);
#endif
    float floor_weight = camera_is_still() ? 1.0 / float(TEMPORAL_FRAMES) : TEMPORAL_WEIGHT;
    float weight = max(floor_weight, history_ramp / (before.a + history_ramp));
    vec3 mean = mix(before.rgb, radiance, weight);
#if TEMPORAL_FRAMES <= 128
    // What drivers cut off is lost anew in each frame of the mean: 1.6 % of it at 128.
    mean = round_to_half(mean);
#endif
    return vec4(mean, min(before.a + 1.0, float(TEMPORAL_FRAMES)));
}

#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Surface s = read_surface(pixel);
    seed_random(pixel, frameCounter);
    vec3 light = light_direction();

    vec3 radiance = vec3(0.0);
    // Of the sky no ray is sent: a loop without turns costs nothing, a branch may.
    int samples = s.sky ? 0 : GI_SAMPLES;
#if HAS_FACE_CACHE
    int first = drawing * GI_SAMPLES;
#else
    int first = 0;
#endif
    for (int i = 0; i < samples; ++i) radiance += gather(s, light, first + i);
    radiance /= float(GI_SAMPLES);

    out_radiance = vec4(radiance, 1.0);
#ifdef TEMPORAL_ACCUMULATION
    out_radiance = accumulate(radiance, history(s));
#endif
#if HAS_GLOSSY
    // No turn for what is diffuse.
    out_mirrored = vec4(0.0);
    for (int i = 0; i < min(s.gloss, 1); ++i) out_mirrored = vec4(mirrored(s, light), 1.0);
#ifdef TEMPORAL_ACCUMULATION
    // What is mirrored moves with the eye.
    out_mirrored =
        accumulate(out_mirrored.rgb, camera_is_still() ? texelFetch(colortex8, pixel, 0) : vec4(0.0));
#endif
#endif
    out_plane = surface_plane(s.player, s.normal);
    if (s.sky) {
        out_radiance = vec4(0.0);
        out_plane = vec4(0.0);
    }
}

#endif
