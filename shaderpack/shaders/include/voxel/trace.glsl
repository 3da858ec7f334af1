// Rays through the voxels: Amanatides & Woo 1987, "A Fast Voxel Traversal Algorithm".
#if !defined INCLUDED_VOXEL_TRACE
#define INCLUDED_VOXEL_TRACE

#include "/include/voxel/voxel.glsl"

struct Hit {
    bool found;       // false: the ray left the volume
    ivec3 cell;
    vec3 position;    // volume space
    vec3 normal;
    Voxel voxel;
    vec3 transmittance;  // of the translucent cells on the way
};

/// Does the part of the ray in this cell, heights low to high within it, touch the block?
bool touches(int code, float low, float high, float miss_squared) {
    if (code == voxel_air || code == voxel_translucent) return false;
    if (code == voxel_slab_bottom) return low < 0.5;
    if (code == voxel_slab_top) return high > 0.5;
    if (code >= voxel_small_lamp) return miss_squared < small_lamp_radius * small_lamp_radius;
    return true;
}

/// First block from `origin` (volume space) on. The first cell is not tested: rays start on a face,
/// and there the cell holds either nothing or the partial block that the face belongs to.
Hit trace(vec3 origin, vec3 direction) {
    // A zero would make 0 * inf; no direction is that exact.
    direction = mix(direction, vec3(1e-6), lessThan(abs(direction), vec3(1e-6)));
    vec3 inverse = 1.0 / direction;
    ivec3 stride = ivec3(sign(direction));
    ivec3 cell = ivec3(floor(origin));
    vec3 leave = (vec3(cell) + step(0.0, direction) - origin) * inverse;
    vec3 delta = abs(inverse);

    Hit hit;
    hit.found = false;
    hit.transmittance = vec3(1.0);
    vec4 texel = vec4(0.0);
    ivec3 axis = ivec3(0);
    float enter = 0.0;
    for (int i = 0; i < 3 * VOLUME; ++i) {
        // One axis at a time, ties included, so that no ray slips through a diagonal edge.
        axis = leave.x < leave.y ? (leave.x < leave.z ? ivec3(1, 0, 0) : ivec3(0, 0, 1))
                                 : (leave.y < leave.z ? ivec3(0, 1, 0) : ivec3(0, 0, 1));
        enter = dot(leave, vec3(axis));
        cell += axis * stride;
        leave += vec3(axis) * delta;
        if (!in_volume(cell)) break;

        texel = texelFetch(shadowcolor0, atlas_texel(cell), 0);
        int code = int(texel.a * 255.0 + 0.5);
        float exit = min(leave.x, min(leave.y, leave.z));
        vec2 heights = origin.y + direction.y * vec2(enter, exit) - float(cell.y);
        vec3 to_center = vec3(cell) + 0.5 - origin;
        float along = dot(to_center, direction);
        float miss_squared = dot(to_center, to_center) - along * along;
        if (touches(code, min(heights.x, heights.y), max(heights.x, heights.y), miss_squared)) {
            hit.found = true;
            break;
        }
        if (code == voxel_translucent) hit.transmittance *= texel.rgb * texel.rgb;
    }

    hit.cell = cell;
    hit.voxel = decode_voxel(texel);
    hit.position = origin + direction * enter;
    hit.normal = -vec3(axis * stride);
    // A slab entered beside its block is hit on its flat face.
    float height = hit.position.y - float(cell.y);
    bool above = hit.voxel.code == voxel_slab_bottom && height > 0.5;
    bool below = hit.voxel.code == voxel_slab_top && height < 0.5;
    if (above || below) {
        hit.normal = vec3(0.0, above ? 1.0 : -1.0, 0.0);
        hit.position += direction * ((0.5 - height) * inverse.y);
    }
    return hit;
}

#endif
