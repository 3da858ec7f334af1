// What global illumination does in a frame, counted with GI_COUNTERS for `orris render --json`.
//
//   gi_state  r32ui, empty when a frame begins: voxels written, one for each face of their blocks; rays
#if !defined INCLUDED_DEBUG_COUNT
#define INCLUDED_DEBUG_COUNT

#if HAS_COUNTERS
layout(r32ui) uniform uimage2D gi_state;

void count_voxel() { imageAtomicAdd(gi_state, ivec2(0, 0), 1u); }

void count_ray() { imageAtomicAdd(gi_state, ivec2(1, 0), 1u); }
#else
void count_voxel() {}

void count_ray() {}
#endif

#endif
