// Two pixels of the same face lie in one plane: that, rather than depth, says whether they may
// share their light. xy normal, by Lambert's azimuthal projection, whose pole is not opposite to a side of a block; z its
// distance from the camera along the normal; w belongs to whoever stores it. 0: no plane.
#if !defined INCLUDED_PLANE
#define INCLUDED_PLANE

// The last one is the pole: (2, -1, 0) / sqrt(5), (3, 6, -5) / sqrt(70), (1, 2, 3) / sqrt(14).
const mat3 plane_axes = mat3(0.894427, -0.447214, 0.0, 0.358569, 0.717137, -0.597614, 0.267261, 0.534522, 0.801784);

vec4 surface_plane(vec3 player, vec3 normal) {
    vec3 n = normal * plane_axes;
    return vec4(n.xy * sqrt(2.0 / max(1.0 + n.z, 1e-4)), dot(normal, player), 0.0);
}

vec3 plane_normal(vec4 plane) {
    float square = min(dot(plane.xy, plane.xy), 4.0);
    return plane_axes * vec3(plane.xy * sqrt(1.0 - 0.25 * square), 1.0 - 0.5 * square);
}

/// Normals differ by less than some 20 degrees. Half floats hold 64 blocks to 1/32.
bool same_plane(vec4 a, vec4 b) { return all(lessThan(abs(a.xyz - b.xyz), vec3(0.3, 0.3, 0.1))); }

#endif
