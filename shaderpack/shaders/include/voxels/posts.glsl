// Shapes of boxes. Fences, walls and chests: a post in the middle of the cell and arms to its sides; doors and
// trapdoors: a plate along one side; glass: its sides; panes: thin walls; carpets; what is drawn of a small lamp. Which of them there are is kept
// where stairs keep their octants: a bit each, arms or plates at -x +x -z +z, then the post, then plates at -y +y; of a small lamp and of
// what covers a floor those below.
#if !defined INCLUDED_VOXELS_POSTS
#define INCLUDED_VOXELS_POSTS

#include "/include/voxels/voxel.glsl"

const uint arms_along_x = 3u;
const uint arms_along_z = 12u;
const uint arms_of_pane = 15u;
const uint part_post = 16u;
const uint part_bottom = 32u;  // of water: below it there is none

const float plate_thickness = 0.1875;
const float pane_radius = 0.0625;

// What is drawn of small lamps: the rod of a torch, the foot of an end rod, the body of a lantern, logs.
const uint lamp_rod = 1u;
const uint lamp_foot = 2u;
const uint lamp_body = 4u;
const uint lamp_logs = 8u;

/// Of what covers a floor, by its height in blocks: of carpets, and of one to three layers of snow.
uint part_of_cover(float height) { return 1u << (uint(height * 16.0 + 0.5) / 2u); }

/// The height of the cover with this bit.
float cover_height(int bit) { return bit == 0 ? 0.0625 : 0.125 * float(bit); }

/// Half of the width of the widest.
float lamp_radius(uint parts) {
    return (parts & lamp_logs) != 0u ? 0.4375 : (parts & lamp_body) != 0u ? 0.1875 : (parts & lamp_foot) != 0u ? 0.125 : (parts & lamp_rod) != 0u ? 0.0625 : 0.0;
}

bool is_post(int code) { return (code >= voxel_fence && code < voxel_small_lamp) || code == voxel_cover; }

/// Are its boxes plates along the sides of the cell?
bool has_plates(int code) { return is_plate(code) || is_glass(code); }

/// Half of the width of the post.
float post_radius(int code) {
    return is_pane(code) ? pane_radius : code == voxel_fence ? 0.125 : code == voxel_wall ? 0.25 : 0.4375;
}

/// The plate whose face this is, by where it lies and looks.
uint plate_of_quad(vec3 middle, vec3 size, vec3 normal) {
    vec3 side = dot(middle, normal) > 0.0 ? normal : -normal;
    if (size.x + size.y + size.z < 1.5) return 0u;
    uvec3 at = uvec3(side.x > 0.5 ? 2u : side.x < -0.5 ? 1u : 0u, side.y > 0.5 ? 64u : side.y < -0.5 ? 32u : 0u,
                     side.z > 0.5 ? 8u : side.z < -0.5 ? 4u : 0u);
    return at.x | at.y | at.z;
}

/// Of a small lamp, by a quad: what is wide is a plane with holes, or the logs of a campfire, which end a quarter high.
uint part_of_lamp(vec3 low, vec3 high) {
    vec3 size = high - low;
    float width = max(size.x, size.z);
    bool on_logs = size.y < 0.01 && abs(high.y + 0.25) < 0.02;
    return width < 0.2 ? lamp_rod : width < 0.3 ? lamp_foot : width < 0.6 ? lamp_body : on_logs ? lamp_logs : 0u;
}

/// The part that a quad belongs to, which reaches from `low` to `high` as seen from the middle of its block.
/// What touches a side of the cell is an arm, what is wide and does not is the post.
uint part_of_quad(int code, vec3 low, vec3 high, vec3 normal) {
    if (has_plates(code)) return plate_of_quad(0.5 * (low + high), high - low, normal);
    const float side = 0.45;
    uint arms = (low.x < -side ? 1u : 0u) | (high.x > side ? 2u : 0u) | (low.z < -side ? 4u : 0u) |
                (high.z > side ? 8u : 0u);
    vec3 size = high - low;
    if (code == voxel_cover) return normal.y < 0.0 ? 0u : part_of_cover(high.y + 0.5);
    if (is_ball(code)) return part_of_lamp(low, high);
    if (code == voxel_chest) return part_post | arms;
    bool post = code == voxel_fence || max(size.x, size.z) > 1.9 * post_radius(code);
    return arms != 0u ? arms : post ? part_post : 0u;
}

// Of the game's model, from corner to corner.
const float plant_width = 1.2728;

/// From one end of a plane of a plant or of fire to the other.
float width_of_plane(int code) { return is_plant(code) ? plant_width : 1.0; }

/// The normal of one of the two planes through the middle of a plant or of fire.
vec3 plane_through_middle(int code, int index) {
    vec3 diagonal = vec3(index == 0 ? 0.70711 : -0.70711, 0.0, 0.70711);
    return is_plant(code) ? diagonal : vec3(1 - index, 0, index);
}

/// Along such a plane, to the right as seen from the side of `normal`.
vec3 side_of_plane(vec3 normal) { return vec3(normal.z, 0.0, -normal.x); }

/// Where a point of such a plane lies on its texture, from the upper left, as seen from the side of `normal`. `off`: from the
/// middle of the cell.
vec2 place_on_plane(int code, vec3 off, vec3 normal) {
    return vec2(dot(off, side_of_plane(normal)) / width_of_plane(code) + 0.5, 0.5 - off.y);
}

/// Its inverse.
vec3 point_of_plant(vec2 at, vec3 normal) {
    return (at.x - 0.5) * plant_width * side_of_plane(normal) + vec3(0.0, 0.5 - at.y, 0.0);
}

/// A box, as seen from the middle of the cell.
struct Box {
    vec3 low;
    vec3 high;
};

/// 0..5: plates at -x +x -z +z -y +y. Those of glass are as thin as its sides.
Box plate_box(int index, float thickness) {
    vec3 axis = vec3(index < 2, index >= 4, index >= 2 && index < 4) * (1.0 - thickness);
    bool upper = (index & 1) == 1;
    return Box(vec3(-0.5) + (upper ? axis : vec3(0.0)), vec3(0.5) - (upper ? vec3(0.0) : axis));
}

/// 0: the post; 1..4 the arms, of fences the lower rails; 5..8 the upper rails.
Box post_box(int code, int index) {
    if (has_plates(code)) return plate_box(index, is_plate(code) ? plate_thickness : 0.0);
    if (code == voxel_cover) return Box(vec3(-0.5), vec3(0.5, cover_height(index) - 0.5, 0.5));
    if (is_ball(code)) {
        float wide = lamp_radius(1u << uint(index));
        float top = index == 0 ? 0.125 : index == 1 ? -0.4375 : index == 2 ? -0.0625 : -0.25;
        return Box(vec3(-wide, -0.5, -wide), vec3(wide, top, wide));
    }
    float radius = post_radius(code);
    bool chest = code == voxel_chest;
    if (index == 0) return Box(vec3(-radius, -0.5, -radius), vec3(radius, chest ? 0.375 : 0.5, radius));
    int arm = (index - 1) & 3;
    bool fence = code == voxel_fence;
    bool pane = is_pane(code);
    float thin = fence || pane ? 0.0625 : chest ? 0.4375 : 0.1875;
    float bottom = fence ? (index < 5 ? -0.125 : 0.25) : -0.5;
    float top = fence ? bottom + 0.1875 : pane ? 0.5 : 0.375;
    vec2 along = (arm & 1) == 0 ? vec2(-0.5, 0.0) : vec2(0.0, 0.5);
    vec2 across = vec2(-thin, thin);
    vec2 x = arm < 2 ? along : across;
    vec2 z = arm < 2 ? across : along;
    return Box(vec3(x.x, bottom, z.x), vec3(x.y, top, z.y));
}

/// Is the side of a box drawn? Of panes not where the pane goes on, above and below, and from the post to an arm.
bool has_side(int code, uint parts, int index, vec3 normal) {
    if (!is_pane(code)) return true;
    int side = normal.x != 0.0 ? int(normal.x > 0.0) : 2 + int(normal.z > 0.0);
    bool to_arm = index == 0 && (parts >> uint(side) & 1u) == 1u;
    bool along_arm = index > 0 && (side < 2) == (index < 3);
    return normal.y == 0.0 && !to_arm && !along_arm;
}

/// Out of the block, of the plate with this index.
vec3 plate_normal(int index) {
    vec3 axis = vec3(index < 2, index >= 4, index >= 2 && index < 4);
    return (index & 1) == 1 ? axis : -axis;
}

int post_boxes(int code) {
    int boxes = code == voxel_fence ? 9 : has_plates(code) ? 6 : 5;
    return code == voxel_cover || is_ball(code) ? 4 : is_post(code) ? boxes : 0;
}

bool has_part(int code, uint parts, int index) {
    int bit = has_plates(code) ? index + int(index >= 4) : is_ball(code) || code == voxel_cover ? index : index == 0 ? 4 : (index - 1) & 3;
    return (parts >> uint(bit) & 1u) == 1u;
}

/// The box whose sides are the block's for the face cache.
Box main_box(int code, uint parts) {
    if (is_glass(code)) return Box(vec3(-0.5), vec3(0.5));
    int index = 0;
    bool has_one = is_plate(code) || code == voxel_cover;
    for (int i = 1; has_one && i < post_boxes(code) && !has_part(code, parts, index); ++i) index = i;
    return post_box(code, index);
}

#endif
