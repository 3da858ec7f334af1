// Rays through the voxels: cell by cell (Amanatides & Woo 1987, "A Fast Voxel Traversal Algorithm"), or
// with RAY_WALK=DISTANCE in leaps through empty cubes.
#if !defined INCLUDED_VOXEL_TRACE
#define INCLUDED_VOXEL_TRACE

#include "/include/voxel/voxel.glsl"
#if DISTANCES
#include "/include/voxel/distance.glsl"
#endif

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

/// Where a ray is on its way through the cells.
struct Walk {
    vec3 origin;
    vec3 direction;
    vec3 inverse;
    ivec3 stride;
    ivec3 cell;
    ivec3 axis;   // of the face by which it came into the cell
    float enter;  // and how far that is
};

Walk begin_walk(vec3 origin, vec3 direction) {
    // A zero would make 0 * inf; no direction is that exact.
    direction = mix(direction, vec3(1e-6), lessThan(abs(direction), vec3(1e-6)));
    return Walk(origin, direction, 1.0 / direction, ivec3(sign(direction)), ivec3(floor(origin)),
                ivec3(0), 0.0);
}

/// Ways to the planes by which the ray leaves the cube of cells nearer than `reach`.
vec3 ways_out(Walk walk, int reach) {
    ivec3 plane = walk.cell + ivec3(greaterThan(walk.stride, ivec3(0))) + walk.stride * (reach - 1);
    return (vec3(plane) - walk.origin) * walk.inverse;
}

/// To the first cell beyond that cube. One axis at a time, ties included, so that no ray slips
/// through a diagonal edge.
void leave_cube(inout Walk walk, int reach) {
    vec3 leave = ways_out(walk, reach);
    walk.axis = leave.x < leave.y ? (leave.x < leave.z ? ivec3(1, 0, 0) : ivec3(0, 0, 1))
                                  : (leave.y < leave.z ? ivec3(0, 1, 0) : ivec3(0, 0, 1));
    walk.enter = min(leave.x, min(leave.y, leave.z));
    ivec3 there = ivec3(floor(walk.origin + walk.direction * walk.enter));
    there = clamp(there, walk.cell - (reach - 1), walk.cell + (reach - 1));
    walk.cell = there + walk.axis * (walk.cell + walk.stride * reach - there);
}

/// On to the next cell that is not known to be empty.
void walk_on(inout Walk walk) {
#if DISTANCES
    int reach = in_volume(walk.cell) ? max(1, empty_reach(walk.cell)) : 1;
    for (int i = 0; i < 3 * VOLUME && reach > 0; ++i) {
        leave_cube(walk, reach);
        if (!in_volume(walk.cell)) return;
        reach = empty_reach(walk.cell);
    }
#else
    leave_cube(walk, 1);
#endif
}

/// First block from `origin` (volume space) on. The first cell is not tested: rays start on a face,
/// and there the cell holds either nothing or the partial block that the face belongs to.
Hit trace(vec3 origin, vec3 direction) {
    Walk walk = begin_walk(origin, direction);
    Hit hit;
    hit.found = false;
    hit.transmittance = vec3(1.0);
    vec4 texel = vec4(0.0);
    for (int i = 0; i < 3 * VOLUME; ++i) {
        walk_on(walk);
        if (!in_volume(walk.cell)) break;

        texel = texelFetch(shadowcolor0, atlas_texel(walk.cell), 0);
        int code = int(texel.a * 255.0 + 0.5);
        vec3 leave = ways_out(walk, 1);
        float exit = min(leave.x, min(leave.y, leave.z));
        vec2 heights = origin.y + walk.direction.y * vec2(walk.enter, exit) - float(walk.cell.y);
        vec3 to_center = vec3(walk.cell) + 0.5 - origin;
        float along = dot(to_center, walk.direction);
        float miss_squared = dot(to_center, to_center) - along * along;
        if (touches(code, min(heights.x, heights.y), max(heights.x, heights.y), miss_squared)) {
            hit.found = true;
            break;
        }
        if (code == voxel_translucent) hit.transmittance *= texel.rgb * texel.rgb;
    }

    hit.cell = walk.cell;
    hit.voxel = decode_voxel(texel);
    hit.position = origin + walk.direction * walk.enter;
    hit.normal = -vec3(walk.axis * walk.stride);
    // A slab entered beside its block is hit on its flat face.
    float height = hit.position.y - float(walk.cell.y);
    bool above = hit.voxel.code == voxel_slab_bottom && height > 0.5;
    bool below = hit.voxel.code == voxel_slab_top && height < 0.5;
    if (above || below) {
        hit.normal = vec3(0.0, above ? 1.0 : -1.0, 0.0);
        hit.position += walk.direction * ((0.5 - height) * walk.inverse.y);
    }
    return hit;
}

#endif
