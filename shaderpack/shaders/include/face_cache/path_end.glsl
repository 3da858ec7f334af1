// What comes from where a path ends, with the face cache. The program has light_of(cell, face), B of a face and its number of
// updates.
#if !defined INCLUDED_FACE_CACHE_PATH_END
#define INCLUDED_FACE_CACHE_PATH_END

#include "/include/face_cache/light_at.glsl"
#include "/include/gi/sunlit.glsl"

/// Radiance of what a ray ends at, without the sun: of the sky, or what the cache has of a face. Behind the volume the hit becomes
/// that of the ground. `sky`: level where the path began.
vec3 light_of_end(inout Hit hit, vec3 from, vec3 direction, float sky) {
#if HAS_SHADOW_MAP
    if (!hit.found && direction.y < 0.0) find_ground(hit, from, direction);
#endif
    return hit.found ? albedo_of(hit) * light_on(hit) : sky_beyond(hit, direction, sky);
}

/// Radiance by the last hit of a path, and by the sun at all of its hits. `from`, `direction`: of the last ray; `throughput`: without
/// the albedo of the last hit; `sunlit`: of the hits before; `sky`: level where the path began.
vec3 end_of_path(Hit hit, vec3 from, vec3 direction, vec3 throughput, Sunlit sunlit, vec3 light, float sky) {
    vec3 radiance = light_of_end(hit, from, direction, sky);
    if (hit.found) choose_sunlit(sunlit, hit, direction, throughput * albedo_of(hit), light);
    return throughput * radiance + light_of_sunlit(sunlit, light, sky);
}

#endif
