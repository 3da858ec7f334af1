// The published step on y = I^gamma: y' = (alpha/6)^gamma * the sum of the open neighbours' y. Linear, so
// without powers; by columns, so that a cell takes what its neighbours below and above have loaded. Lamps and walls
// hold what they send, and each cell knows what of its block matters (floodfill/image_cells).
#if !defined INCLUDED_FLOODFILL_POWER_STEP
#define INCLUDED_FLOODFILL_POWER_STEP

#include "/include/voxels/changes.glsl"
#include "/include/floodfill/light_field.glsl"

const float step_gain = pow(FLOODFILL_ALPHA / 6.0, FLOODFILL_GAMMA);
// Smaller changes are none, by this share and the least light: about what codes round.
const float change_least = 1.0 / 1024.0;

/// The columns of cells about one: their texels, and all bits or none by whether the volume has them.
struct Ring {
    ivec4 place;  // x - 1, x + 1, z - 1, z + 1
    uvec4 inside;
};

Ring ring_about(ivec3 lowest, ivec3 cell, int side) {
    ivec3 low = wrap(lowest - 1, volume_size);
    ivec3 high = wrap(lowest + 1, volume_size);
    bvec4 inside = bvec4(cell.x > 0, cell.x < VOLUME - 1, cell.z > 0, cell.z < VOLUME - 1);
    return Ring(ivec4(low.x, high.x, low.z + side, high.z + side), uvec4(inside) * ~0u);
}

uvec2 word_at(ivec3 texel) { return imageLoad(flood_light, texel).rg; }

vec3 ring_power(Ring ring, ivec3 texel) {
    return power_of(word_at(ivec3(ring.place.x, texel.yz)) & ring.inside.x) +
           power_of(word_at(ivec3(ring.place.y, texel.yz)) & ring.inside.y) +
           power_of(word_at(ivec3(texel.xy, ring.place.z)) & ring.inside.z) +
           power_of(word_at(ivec3(texel.xy, ring.place.w)) & ring.inside.w);
}

/// Has the cell the same light as before, or all but?
bool rests(vec3 power, vec3 before) {
    return all(lessThanEqual(abs(power - before), change_least * before + power_least));
}

/// Is something of the column's light new, and which of its cells have yet to take the colour of their
/// block (floodfill/image_tint)? A bit each; their light counts as new when they have.
bool step_column(ivec3 lowest, uint stamp, out uint filters) {
    int side = flood_texel(ivec3(0), stamp - 1u).z;
    int other_side = VOLUME - side;
    ivec3 cell = stored_at(lowest);
    Ring ring = ring_about(lowest, cell, side);
    ivec3 texel = lowest + ivec3(0, 0, side);
    filters = 0u;
    bool changed = false;

    vec3 below = power_of(word_at(ivec3(texel.x, wrap(lowest - 1, volume_size).y, texel.z)));
    uvec2 own = word_at(texel);
    vec3 own_power = power_of(own);
    int height = cell.y;
    for (int y = 0; y < brick_size; ++y) {
        int over = y < brick_size - 1 ? texel.y + 1 : wrap(lowest + brick_size, volume_size).y;
        uvec2 above = word_at(ivec3(texel.x, over, texel.z));
        vec3 above_power = power_of(above);
        vec3 sum = ring_power(ring, texel);
        sum += height > 0 && (own.y & trait_closed_down) == 0u ? below : vec3(0.0);
        sum += height < VOLUME_HEIGHT - 1 && (own.y & trait_closed_up) == 0u ? above_power : vec3(0.0);

        vec3 power = min(step_gain * sum, vec3(power_max));
        bool filters_light = (own.y & trait_filter) != 0u;
        bool same = !filters_light && ((own.y & trait_fixed) != 0u || rests(power, own_power));
        uvec2 next = same ? own : texel_of_power(power, own.y & 0xFFFF0000u).xy;
        imageStore(flood_light, ivec3(texel.xy, lowest.z + other_side), next.xyxy);
        changed = changed || (next != own && !filters_light);
        filters |= uint(filters_light) << uint(y);

        below = own_power;
        own = above;
        own_power = above_power;
        texel.y++;
        height = height == VOLUME_HEIGHT - 1 ? 0 : height + 1;
    }
    return changed;
}

#endif
