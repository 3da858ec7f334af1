// How far rays may leap: for each cell the distance to the next block, as half the side of the largest
// empty cube about it (Chebyshev); 0 where something is. Made anew when the voxels change
// (voxels/bits, voxels/distance).
//
//   voxel_bits      r32ui, 32 cells along x in a texel: is something there? Then, in as many texels
//                   again: does a block fill the cell?
//   voxel_distance  r32ui, 8 cells along x in a texel, 4 bits each: 0..farthest_reach, 15 where a block
//                   fills the cell
#if !defined INCLUDED_VOXELS_DISTANCE
#define INCLUDED_VOXELS_DISTANCE

#include "/include/voxels/changes.glsl"

const int farthest_reach = 8;
const int words_of_row = (VOLUME + 31) / 32;

#if defined HAS_DISTANCE_WRITES
layout(r32ui) uniform readonly uimage2D voxel_memory;

bool distances_are_old() {
    return changed_within(imageLoad(voxel_memory, change_of_any).r, 1) || volume_scroll() != ivec3(0) ||
           frameCounter == 0;
}
#else
layout(r32ui) uniform readonly uimage3D voxel_distance;

/// Cells nearer than this on every axis are empty; 0: this one is not, or it is outside, where images
/// read 0; 15: nothing passes.
int empty_reach(ivec3 cell) {
    uint eight = imageLoad(voxel_distance, ivec3(cell.x >> 3, cell.yz)).r;
    return int(eight >> uint((cell.x & 7) * 4) & 15u);
}
#endif

#endif
