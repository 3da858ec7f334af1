// What comes from where a path ends, with the face cache. The program has light_of(cell, face), B of a face and its number of
// updates.
#if !defined INCLUDED_FACE_CACHE_PATH_END
#define INCLUDED_FACE_CACHE_PATH_END

#include "/include/face_cache/light_at.glsl"
#include "/include/gi/sunlit.glsl"

#if HAS_SHADOW_MAP
/// Of a ray that has left the volume downwards: the ground beyond, if the shadow map knows of any there. It has the height, the
/// light and, where the map does not show it, the colour of that at the edge of the volume.
void find_ground(inout Hit hit, vec3 origin, vec3 direction) {
    ivec3 cell = clamp(hit.cell, ivec3(0), volume_size - 1);
    float height = ground_below(hit.position, cell.xz);
    if (hit.position.y <= height) return;
    cell.y = int(ceil(height)) - 1;
    Voxel ground = voxel_at(cell);
    vec3 position = origin + direction * ((height - origin.y) / direction.y);
    vec2 away = abs(from_volume(position).xz);
    bool near = max(away.x, away.y) < SHADOW_DISTANCE;
    // Light does not come to what lies half a block below it.
    PlaneInMap inside = plane_in_map(from_volume(position) - vec3(0.0, 0.5, 0.0), vec3(0.0, 1.0, 0.0));
    float depth = depth_in_texel(inside, floor(inside.position));
    bool is_there = lit_at(floor(inside.position) + 0.5, depth) == 0.0;
    if (ground.code != voxel_solid || !near || !is_there) return;
    ivec2 texel = sheet_texel(ivec2(inside.position));
    vec4 first = texelFetch(shadowcolor0, texel, 0);
    // How far above that the first surface lies which the light meets.
    float above = blocks_below(texel, depth) * shadowModelView[1].z;
    if (above < 0.75 && first.a == 0.0) ground.color = sheet_color(first);
    hit = Hit(true, cell, position, vec3(0.0, 1.0, 0.0), ground, hit.transmittance, false);
}
#endif

/// Radiance of what a ray ends at, without the sun: of the sky, or what the cache has of a face. Beyond the volume the hit becomes
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
