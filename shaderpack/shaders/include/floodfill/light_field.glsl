// Floodfill light by cell: colortex4, laid out as the voxels are, or with FLOODFILL_STORAGE=IMAGE_3D
// an image (include/floodfill/flood_image.glsl).
#if !defined INCLUDED_FLOODFILL_LIGHT_FIELD
#define INCLUDED_FLOODFILL_LIGHT_FIELD

#include "/include/voxels/voxel.glsl"
#include "/include/math/sampling.glsl"

#if HAS_FLOOD_IMAGE
#include "/include/floodfill/flood_image.glsl"
#if defined HAS_FLOOD_WRITES
layout(FLOODFILL_FORMAT) uniform FLOODFILL_IMAGE flood_light;
const uint steps_back = 1u;  // what this frame's step reads
#else
layout(FLOODFILL_FORMAT) uniform readonly FLOODFILL_IMAGE flood_light;
const uint steps_back = 0u;
#endif

vec3 stored_light(ivec3 cell) {
    ivec3 texel = flood_texel(store_cell(cell), step_stamp() - steps_back);
    return light_of(imageLoad(flood_light, texel));
}
#else
uniform sampler2D colortex4;

const float light_max = 65504.0;  // largest half float

vec3 stored_light(ivec3 cell) {
    vec3 light = texelFetch(colortex4, atlas_texel(cell), 0).rgb;
    // Comparisons with NaN are false; min and max need not be.
    return mix(vec3(0.0), light,
               bvec3(light.r >= 0.0 && light.r <= light_max, light.g >= 0.0 && light.g <= light_max,
                     light.b >= 0.0 && light.b <= light_max));
}
#endif

/// Light stored for a cell; 0 outside the volume and for anything that is not a number.
vec3 light_at(ivec3 cell) {
    if (!in_volume(cell)) return vec3(0.0);
    return stored_light(cell);
}

/// As published: the cell at a random half-block offset into the hemisphere. Cells of walls and
/// lamps are read like any other, so concave edges come out an eighth too dark for each wall.
vec3 light_published(vec3 position, vec3 normal, vec2 u) {
    return light_at(ivec3(floor(position + 0.5 * hemisphere_direction(normal, u))));
}

/// Bilinear in the layer of cells before the face; walls and lamps have no weight, and the others
/// are weighed up to one.
vec3 light_solid_aware(vec3 position, vec3 normal) {
    vec3 corner = position + 0.5 * normal - 0.5;
    ivec3 base = ivec3(floor(corner));
    vec3 high = corner - vec3(base);
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 8; ++i) {
        ivec3 offset = ivec3(i & 1, (i >> 1) & 1, i >> 2);
        vec3 w = mix(1.0 - high, high, vec3(offset));
        float weight = w.x * w.y * w.z;
        ivec3 cell = base + offset;
        if (is_opaque_voxel(voxel_at(cell).code) || !in_volume(cell)) weight = 0.0;
        sum += weight * vec4(light_at(cell), 1.0);
    }
    return sum.rgb / max(sum.a, 1e-4);
}

/// Light arriving at a face, as mean radiance. `position` in volume space; `u` random.
vec3 light_at_face(vec3 position, vec3 normal, vec2 u) {
#if FLOODFILL_LOOKUP == FLOODFILL_LOOKUP_SOLID_AWARE
    return light_solid_aware(position, normal);
#else
    return light_published(position, normal, u);
#endif
}

#endif
