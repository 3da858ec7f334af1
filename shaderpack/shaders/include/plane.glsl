// Two pixels of the same face lie in one plane: that, rather than depth, says whether they may
// share their light. xyz normal, w its distance from the camera along the normal.
#if !defined INCLUDED_PLANE
#define INCLUDED_PLANE

vec4 surface_plane(vec3 player, vec3 normal) { return vec4(normal, dot(normal, player)); }

/// Half floats hold 64 blocks to 1/32.
bool same_plane(vec4 a, vec4 b) { return dot(a.xyz, b.xyz) > 0.9 && abs(a.w - b.w) < 0.1; }

#endif
