// What a ray finds at the block it hits.
#if !defined INCLUDED_LIGHTING_HIT
#define INCLUDED_LIGHTING_HIT

#include "/include/lighting/shadow.glsl"
#include "/include/lighting/sky.glsl"
#include "/include/lighting/sun_tint.glsl"
#include "/include/math/sampling.glsl"
#include "/include/voxel/trace.glsl"

// A little off the face, more than depth rounds at the edge of the volume.
const float ray_offset = 0.02;

/// Radiance of a lamp where a ray hits it: small ones are balls.
vec3 lamp_light(Voxel v) {
    return lamp_radiance(v) * (is_ball(v.code) ? small_lamp_boost : 1.0);
}

/// The way from `origin` to where a ray leaves its first cell.
float way_out(vec3 origin, vec3 direction) {
    direction = mix(direction, vec3(1e-6), lessThan(abs(direction), vec3(1e-6)));
    vec3 ways = (floor(origin) + step(0.0, direction) - origin) / direction;
    return min(ways.x, min(ways.y, ways.z));
}

/// The first block of a ray from a face. The face shares its cell with the water above it, with a slab, with
/// the rest of the stairs that it belongs to, or with a small lamp that stands on it; the lamp's own faces lie
/// in its ball, and see none.
Hit trace_from_face(vec3 origin, vec3 direction) {
    ivec3 cell = ivec3(floor(origin));
    Voxel own = voxel_at(cell);
    vec3 to_center = vec3(cell) + 0.5 - origin;
    float along = dot(to_center, direction);
    float off = dot(to_center, to_center) - along * along;
    const float ball = small_lamp_radius * small_lamp_radius;
    if (is_ball(own.code) && along > 0.0 && off < ball && dot(to_center, to_center) > ball)
        return Hit(true, cell, origin, -direction, own, vec3(1.0), false);
    Walk walk = begin_walk(origin, direction);
    vec3 within = floor((origin - vec3(cell)) * 2.0);
    uint octants = octants_of(own.code, cell);
    // What is thinner than half a block has its face inside of what stands for it.
    octants = (octants >> uint(dot(within, vec3(1.0, 2.0, 4.0))) & 1u) == 1u ? 0u : octants;
    Meeting met = meet_octants(walk, octants, vec2(-1.0, way_out(origin, direction)));
#if NOTICE_CHANGES
    if (is_post(own.code)) met = meet_post(walk, own.code);
#endif
    if (met.found)
        return Hit(true, cell, origin + direction * met.way, -met.axis * walk.stride, own, vec3(1.0),
                   !is_post(own.code));
    Hit hit = trace(origin, direction);
    if (is_filter_voxel(own.code)) {
        vec2 ways = vec2(0.0, way_out(origin, direction));
        if (own.code == voxel_water_surface)
            ways = below_surface(ways, float(cell.y) + water_height - origin.y, direction.y);
        hit.transmittance *= filtered(own.color, max(0.0, ways.y - ways.x));
    }
    return hit;
}

/// Of a ray that has left the volume: none in a cave, where neither the place of leaving gets light of the sky nor that
/// where the ray began: `sky`, the level there.
vec3 sky_beyond(Hit hit, vec3 direction, float sky) {
    return sky_radiance(direction) * (sky_comes_to(hit.position) ? 1.0 : smoothstep(0.0, 0.1, sky));
}

/// Sun or moon light that a hit reflects, without its albedo. `sky`: level where the ray began.
vec3 sun_at(Hit hit, vec3 light, float sky) {
    vec3 player = from_volume(hit.position);
    return light_irradiance() * (max(dot(hit.normal, light), 0.0) / pi) *
           light_visibility(player, hit.normal, light, 0, sky) *
           sun_tint(player, hit.cell + ivec3(hit.normal));
}

#endif
