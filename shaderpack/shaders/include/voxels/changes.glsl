// When the blocks of the volume changed, by bricks of 8^3 cells that keep their place in the world,
// so that what is made of the voxels is made anew only then.
//
//   voxel_sums    r32ui, empty when a frame begins: a checksum of each brick's quads, by the shadow pass
//   voxel_memory  r32ui, kept: row 0 these of the frame before, row 1 the frame of each brick's last
//                 change, (0, 2) that of any, (1, 2) the last one with a lake
//
// Frames are numbered from 1 here; 0 is never.
#if !defined INCLUDED_VOXELS_CHANGES
#define INCLUDED_VOXELS_CHANGES

#include "/include/voxels/volume.glsl"

const int brick_size = 8;
const ivec3 bricks = volume_size / brick_size;  // along each axis
const int brick_count = bricks.x * bricks.y * bricks.z;
const ivec2 change_of_any = ivec2(0, 2);
const ivec2 lake_seen = ivec2(1, 2);

/// Of a place among the bricks, in which cells are stored.
int brick_index(ivec3 place) { return (place.z * bricks.y + place.y) * bricks.x + place.x; }

ivec3 brick_place(int brick) {
    return ivec3(brick % bricks.x, brick / bricks.x % bricks.y, brick / (bricks.x * bricks.y));
}

uint change_stamp() { return uint(frameCounter) + 1u; }

/// Was the change in this frame or one of the `frames - 1` before it?
bool changed_within(uint stamp, int frames) { return change_stamp() - stamp < uint(frames); }

#endif
