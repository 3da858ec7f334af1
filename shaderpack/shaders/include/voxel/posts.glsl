// Fences and walls: a post in the middle of the cell and arms to its sides, as boxes. Which of them there
// are is kept where stairs keep their octants: a bit each, arms to -x +x -z +z, then the post.
#if !defined INCLUDED_VOXEL_POSTS
#define INCLUDED_VOXEL_POSTS

#include "/include/voxel/voxel.glsl"

const uint part_post = 16u;

bool is_post(int code) { return code == voxel_fence || code == voxel_wall; }

/// Half of the width of the post.
float post_radius(int code) { return code == voxel_fence ? 0.125 : 0.25; }

/// The part that a quad belongs to, which reaches from `low` to `high` as seen from the middle of its block.
/// What touches a side of the cell is an arm, what is wide and does not is the post.
uint part_of_quad(int code, vec3 low, vec3 high) {
    const float side = 0.45;
    uint arms = (low.x < -side ? 1u : 0u) | (high.x > side ? 2u : 0u) | (low.z < -side ? 4u : 0u) |
                (high.z > side ? 8u : 0u);
    vec3 size = high - low;
    bool post = code == voxel_fence || max(size.x, size.z) > 1.9 * post_radius(code);
    return arms != 0u ? arms : post ? part_post : 0u;
}

/// A box, as seen from the middle of the cell.
struct Box {
    vec3 low;
    vec3 high;
};

/// 0: the post; 1..4 the arms, of fences the lower rails; 5..8 the upper rails.
Box post_box(int code, int index) {
    float radius = post_radius(code);
    if (index == 0) return Box(vec3(-radius, -0.5, -radius), vec3(radius, 0.5, radius));
    int arm = (index - 1) & 3;
    bool fence = code == voxel_fence;
    float thin = fence ? 0.0625 : 0.1875;
    float bottom = fence ? (index < 5 ? -0.125 : 0.25) : -0.5;
    float top = fence ? bottom + 0.1875 : 0.375;
    vec2 along = (arm & 1) == 0 ? vec2(-0.5, 0.0) : vec2(0.0, 0.5);
    vec2 across = vec2(-thin, thin);
    vec2 x = arm < 2 ? along : across;
    vec2 z = arm < 2 ? across : along;
    return Box(vec3(x.x, bottom, z.x), vec3(x.y, top, z.y));
}

int post_boxes(int code) { return code == voxel_fence ? 9 : code == voxel_wall ? 5 : 0; }

bool has_part(uint parts, int index) {
    return (parts >> uint(index == 0 ? 4 : (index - 1) & 3) & 1u) == 1u;
}

#endif
