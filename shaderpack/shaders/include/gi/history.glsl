// What earlier frames gathered, and how a new sample joins it.
#if !defined INCLUDED_GI_HISTORY
#define INCLUDED_GI_HISTORY

#include "/include/gbuffer.glsl"
#include "/include/plane.glsl"
#include "/include/math/half.glsl"
#include "/include/gi/noise.glsl"
#include "/include/gi/rest.glsl"
#if HAS_FACE_CACHE
uniform usampler2D face_list_texture;
#include "/include/face_cache/face_cache.glsl"
#endif

/// Where a surface was in the frame before.
struct Before {
    ivec2 pixel;  // far outside of the picture if it was not on the screen
    vec3 player;  // seen from there
    vec4 plane;
};

Before before_of(Surface s) {
    vec3 player = s.player + (cameraPosition - previousCameraPosition);
    vec4 clip = gbufferPreviousProjection * (gbufferPreviousModelView * vec4(player, 1.0));
    vec2 uv = clip.xy / clip.w * 0.5 + 0.5;
    bool on_screen = clip.w > 0.0 && all(greaterThanEqual(uv, vec2(0.0))) &&
                     all(lessThan(uv, vec2(1.0)));
    ivec2 pixel = on_screen ? ivec2(floor(uv * vec2(viewWidth, viewHeight))) : ivec2(-1000);
    return Before(pixel, player, surface_plane(player, s.normal));
}

bool in_picture(ivec2 pixel) {
    return pixel.x >= 0 && pixel.y >= 0 && pixel.x < int(viewWidth) && pixel.y < int(viewHeight);
}

/// What earlier frames found at this pixel for the surface: rgb, and how many of them; 0 where it was not seen.
/// `means`, `planes`: buffers of the frame before.
vec4 history(sampler2D means, sampler2D planes, ivec2 pixel, vec4 plane) {
    if (!in_picture(pixel) || !same_plane(texelFetch(planes, pixel, 0), plane)) return vec4(0.0);
    return texelFetch(means, pixel, 0);
}

/// Was this surface behind another one, at this pixel?
bool was_hidden(sampler2D planes, Before before) {
    if (!in_picture(before.pixel)) return false;
    vec4 plane = texelFetch(planes, before.pixel, 0);
    float along = dot(plane_normal(plane), before.player);
    // Of the way to the surface, what the plane leaves.
    float share = along == 0.0 ? 1.0 : plane.z / along;
    return share > 0.0 && (1.0 - share) * length(before.player) > 0.1;
}

// Not every frame draws a translucent surface at each pixel: w of its plane, which is 1 more than the frame's number in
// this cycle, says when it was. frameCounter begins anew at a multiple of the cycle.
const int stamp_cycle = 240;

/// The plane of a translucent surface, as colortex13 has it.
vec4 with_stamp(vec4 plane) { return vec4(plane.xyz, float(1 + frameCounter % stamp_cycle)); }

/// The plane of what the frame before drew; 0 if it drew nothing.
vec4 of_last_frame(vec4 stored) {
    float stamp = float(1 + (frameCounter + stamp_cycle - 1) % stamp_cycle);
    return stored.w == stamp ? stored : vec4(0.0);
}

vec4 accumulate(vec3 radiance, vec4 before) {
#if HAS_FACE_CACHE
    if (light_changes(texelFetch(face_list_texture, last_edit, 0).r))
        before.a = min(before.a, face_edited_updates);
#endif
    float most = camera_is_still() ? float(TEMPORAL_FRAMES) : samples_of_weight(TEMPORAL_WEIGHT);
    float count = min(before.a + 1.0, most);
    // What drivers cut off of half floats is lost anew in each frame of the mean: 1.6 % of it at 128.
    return vec4(as_stored(mix(before.rgb, radiance, weight_of_sample(count))), count);
}

#endif
