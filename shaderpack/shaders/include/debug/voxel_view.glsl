// The volume of voxels in three dimensions, instead of the lit scene (VOXEL_VIEW): what rays from the
// eye meet in it, beyond VOXEL_VIEW_FROM blocks, so that one can look into closed rooms.
//   BLOCKS    colour and shape as stored
//   RADIANCE  light that the cache has for the face, or for the air before it
#if !defined INCLUDED_DEBUG_VOXEL_VIEW
#define INCLUDED_DEBUG_VOXEL_VIEW

#include "/include/voxels/trace.glsl"
#if HAS_AIR_LIGHT
#include "/include/floodfill/light_field.glsl"
#elif HAS_FACE_CACHE
#include "/include/face_cache/face_lookup.glsl"
#endif

/// 0 along the edges of blocks, else 1.
float grid_lines(Hit hit) {
    vec3 edge = min(fract(hit.position), 1.0 - fract(hit.position)) + abs(hit.normal);
    return smoothstep(0.0, 0.06, min(edge.x, min(edge.y, edge.z)));
}

vec3 voxel_view(vec3 player) {
    vec3 direction = normalize(player);
    Hit hit = trace(to_volume(direction * VOXEL_VIEW_FROM), direction, voxel_air, ray_from_point);
    if (!hit.found) return vec3(0.0);
    if (is_lamp_voxel(hit.voxel.code)) return lamp_radiance(hit.voxel) * hit.transmittance;
#if VOXEL_VIEW == VOXEL_VIEW_RADIANCE && HAS_AIR_LIGHT
    vec3 shown = light_solid_aware(hit.position, hit.normal);
#elif VOXEL_VIEW == VOXEL_VIEW_RADIANCE && HAS_FACE_CACHE
    vec3 shown = cached_light(hit.cell, face_of_hit(hit)).rgb;
#else
    vec3 shown = hit.voxel.color * (0.6 + 0.1 * dot(hit.normal, vec3(1.0, 3.0, 2.0)));
#endif
    return shown * hit.transmittance * mix(0.5, 1.0, grid_lines(hit));
}

#endif
