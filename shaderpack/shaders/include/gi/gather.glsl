// Light from everything but the direct sun at a point of a surface, by a ray through the voxels. Radiance is constant
// along a ray, so nothing is divided by distance. With the face cache light_of(cell, face), B of a face and its number of
// updates, belongs to the program.
#if !defined INCLUDED_GI_GATHER
#define INCLUDED_GI_GATHER

#include "/include/gbuffer.glsl"
#include "/include/math/random.glsl"
#include "/include/gi/hit.glsl"
#if HAS_AIR_LIGHT
#include "/include/floodfill/light_field.glsl"
#endif
#if HAS_FACE_CACHE
#include "/include/face_cache/path_end.glsl"
#endif
#include "/include/gi/thin.glsl"
#if HAS_LAMP_RAYS
layout(r32ui) uniform readonly uimage2D face_list;
layout(r32ui) uniform readonly uimage3D face_seen;
const int lamp_candidates = 4;
#include "/include/lights/lamp_sample.glsl"
#include "/include/gi/turns.glsl"
#endif
#if HAS_LAMPS
#include "/include/lights/lamps.glsl"
#endif

#if GI_METHOD == GI_METHOD_BOUNCE_4 || HAS_FACE_CACHE
const int gi_bounces = 4;
#elif GI_METHOD == GI_METHOD_BOUNCE_2
const int gi_bounces = 2;
#else
const int gi_bounces = 1;
#endif

/// Does deferred6 add the light of a lamp that the ray from the pixel hits here?
bool lit_directly(int bounce, vec3 position) {
#if HAS_LAMPS
    return bounce == 0 && in_lamp_volume(ivec3(floor(to_lamp_space(from_volume(position)))));
#else
    return false;
#endif
}

#if HAS_LAMP_RAYS
/// A sample by a ray to a lamp, the pixel's n-th of those: what gather() makes of it, without the rest of that.
vec3 gather_by_lamp(Surface s, ivec2 pixel, int number) {
    vec3 normal = s.normal;
    vec3 throughput = 2.0 * choose_side(s.thin, s.albedo, normal);
    vec3 from = to_volume(s.player) + normal * pixel_offset(s.player);
    begins_on_lamp = s.emission > 0.0;
    next_random();  // as in gather(), so that both choose alike
    LampSample lamp = choose_lamp(Receiver(from, normal), listed_lamps(), spread_point(pixel, number));
    Hit hit = trace_from_face(from, lamp.direction);
    return hit.found && hit.cell == lamp.cell ? throughput * hit.transmittance * lamp.light : vec3(0.0);
}
#endif

/// One sample of the mean incoming radiance, the pixel's n-th over all frames, or of its kind. `aimed`: by a ray to a lamp.
vec3 gather(Surface s, ivec2 pixel, vec3 light, int number, bool aimed) {
    vec3 normal = s.normal;
    vec3 throughput = choose_side(s.thin, s.albedo, normal);
    vec3 origin = to_volume(s.player) + normal * pixel_offset(s.player);
    vec3 radiance = vec3(0.0);
    begins_on_lamp = s.emission > 0.0;
#if HAS_LAMP_RAYS
    uint lamps = listed_lamps();
#endif
    vec3 direction;
    bool goes_straight = false;
    Hit hit;
#if HAS_FACE_CACHE
    Sunlit sunlit = no_sunlit();
#endif
    for (int bounce = 0; bounce < gi_bounces; ++bounce) {
        vec2 u = next_random().xy;
#if HAS_FACE_CACHE
        if (bounce == 0) u = spread_point(pixel, number);
#endif
        direction = goes_straight ? direction : cosine_direction(normal, u);
        vec3 from = origin;
#if HAS_LAMP_RAYS
        LampSample lamp;
        if (aimed) {
            lamp = choose_lamp(Receiver(origin, normal), lamps, u);
            direction = lamp.direction;
        }
        hit = trace_from_face(from, direction);
        if (lamps > 0u && !goes_straight) throughput *= 2.0;
        if (aimed) {
            if (hit.found && hit.cell == lamp.cell) radiance += throughput * hit.transmittance * lamp.light;
            break;
        }
#else
        hit = trace_from_face(from, direction);
#endif
        throughput *= hit.transmittance;
#if !HAS_FACE_CACHE
        if (!hit.found) radiance += throughput * sky_beyond(hit, direction, s.light.y);
#endif
        if (is_lamp_voxel(hit.voxel.code)) {
#if HAS_LAMP_RAYS
            float share = goes_straight ? 1.0 : met_share(hit, Receiver(origin, normal), direction);
#else
            float share = float(!lit_directly(goes_straight ? 0 : bounce, hit.position));
#endif
            radiance += throughput * lamp_light(hit, from, direction) * share;
        }
#if HAS_FACE_CACHE
        // As in update.glsl.
        goes_straight = bounce == 0 && goes_on(hit);
#endif
        if (!hit.found) break;
#if HAS_FACE_CACHE
        if (goes_straight) {
            origin = point_in_ball(hit, from, direction);
#if HAS_LAMP_RAYS
            aimed = false;
#endif
            continue;
        }
        // From so near the mean of a face is not what is seen of it: gathered anew, as final gathering with photon
        // maps does (Jensen 2001, "Realistic Image Synthesis Using Photon Mapping").
        bool is_near = distance(hit.position, from) < FACE_NEAR;
        if (bounce == gi_bounces - 1 || !(is_near || is_ill_known(hit))) break;
        throughput *= albedo_of(hit);
        choose_sunlit(sunlit, hit, direction, throughput, light);
#else
        throughput *= albedo_of(hit);
        radiance += throughput * sun_at(hit, direction, light, s.light.y);
#endif
        bool thin = is_thin(hit.voxel.code);
        normal = thin && dot(hit.normal, direction) > 0.0 ? -hit.normal : hit.normal;
        throughput *= choose_side(thin, hit.voxel.color, normal);
        origin = hit.position + normal * face_offset;
        begins_on_lamp = is_on_body(hit);
#if HAS_AIR_LIGHT
        // The cells before a lamp hold its own light: what it reflects is not known.
        if (is_lamp_voxel(hit.voxel.code)) break;
        radiance += throughput * light_at_face(hit.position, normal, next_random().xy) *
                    FLOODFILL_STRENGTH;
#endif
#if HAS_LAMP_RAYS
        aimed = lamps > 0u && next_random().x < 0.5;
#endif
        // A loop that is not known to end here costs a quarter more on llvmpipe.
        if (gi_bounces == 1) break;
    }
#if HAS_FACE_CACHE
#if HAS_LAMP_RAYS
    if (aimed) throughput = vec3(0.0);  // a ray to a lamp finds nothing else
#endif
    radiance += end_of_path(hit, origin, direction, throughput, sunlit, light, s.light.y);
#endif
    return radiance;
}

#endif
