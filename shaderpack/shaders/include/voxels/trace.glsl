// Rays through the voxels: cell by cell (Amanatides & Woo 1987, "A Fast Voxel Traversal Algorithm"), or
// with RAY_WALK=DISTANCE in leaps through empty cubes. Loops ask at their end whether they go on: llvmpipe runs the
// body of one that asks at its beginning once more, for no ray.
#if !defined INCLUDED_VOXELS_TRACE
#define INCLUDED_VOXELS_TRACE

#include "/include/debug/count.glsl"
#include "/include/math/random.glsl"
#include "/include/voxels/holes.glsl"
#include "/include/voxels/octants.glsl"
#include "/include/voxels/voxel.glsl"
#if HAS_DISTANCES
#include "/include/voxels/distance.glsl"
#endif

struct Hit {
    bool found;       // false: the ray left the volume
    ivec3 cell;
    vec3 position;    // volume space
    vec3 normal;
    Voxel voxel;
    vec3 transmittance;  // of the translucent cells that it passed
    bool inner;          // on a plane through the middle of its cell, beyond that of a stained pane beside the face, or on
                         // what is drawn of a small lamp
};

/// Where a ray is as it walks through the cells. Floats, as they are compared and rounded faster.
struct Walk {
    vec3 origin;
    vec3 direction;
    vec3 inverse;
    vec3 stride;  // -1 or 1
    vec3 cell;
    int reach;    // 0: something is here, or the ray has left the volume; stopped: what is here stops it
};

int face_of_hit(Hit hit) {
    return is_plant(hit.voxel.code) ? face_of_plant : face_of(hit.normal) + (hit.inner ? face_inner : 0);
}

const int stopped = 15;

Walk begin_walk(vec3 origin, vec3 direction) {
    // A zero would make 0 * inf; no direction is that exact.
    direction = mix(direction, vec3(1e-6), lessThan(abs(direction), vec3(1e-6)));
    return Walk(origin, direction, 1.0 / direction, sign(direction), floor(origin), 1);
}

ivec3 cell_of(Walk walk) { return ivec3(walk.cell); }

/// Distances to the planes by which the ray leaves the cube of cells nearer than `reach`; by which it came
/// into its cell for 0.
vec3 plane_distances(Walk walk, float reach) {
    return (walk.cell + (0.5 - walk.origin + walk.stride * (reach - 0.5))) * walk.inverse;
}

/// To the first cell beyond that cube. One axis at a time, ties included, so that no ray slips through
/// a diagonal edge.
void leave_cube(inout Walk walk, float reach) {
    vec3 leave = plane_distances(walk, reach);
    bool x = leave.x < leave.y && leave.x < leave.z;
    bool y = !x && leave.y < leave.z;
    vec3 there = walk.cell;
#if HAS_DISTANCES
    there = floor(walk.origin + walk.direction * min(leave.x, min(leave.y, leave.z)));
    there = clamp(there, walk.cell - (reach - 1.0), walk.cell + (reach - 1.0));
#endif
    walk.cell = mix(there, walk.cell + walk.stride * reach, bvec3(x, y, !x && !y));
}

/// On to the next cell that is not known to be empty.
void walk_on(inout Walk walk) {
#if HAS_DISTANCES
    walk.reach = max(1, walk.reach);
    int i = 0;
    do {
        leave_cube(walk, float(walk.reach));
        walk.reach = empty_reach(cell_of(walk));
    } while (++i < 3 * VOLUME && uint(walk.reach - 1) < uint(stopped - 1));
#else
    leave_cube(walk, 1.0);
    walk.reach = 0;
#endif
}

vec4 texel_of(ivec3 cell) { return texelFetch(shadowcolor0, atlas_texel(cell), 0); }

/// The distances to where the ray enters its cell and to where it leaves it.
vec2 span_in_cell(Walk walk) {
    vec3 leave = plane_distances(walk, 1.0);
    vec3 came = plane_distances(walk, 0.0);
    return vec2(max(came.x, max(came.y, came.z)), min(leave.x, min(leave.y, leave.z)));
}

/// The part of a ray's distances x to y that lies below the height where water ends in its cell.
vec2 below_surface(vec2 span, float height, float slope) {
    float crossing = height / (abs(slope) < 1e-6 ? 1e-6 : slope);
    return slope > 0.0 ? vec2(span.x, min(span.y, crossing)) : vec2(max(span.x, crossing), span.y);
}

/// How many blocks of its colour a ray passes between those distances. `middle`: of its cell, from the ray's origin. A pane
/// counts as one where a ray comes into it, however aslant, by a side or by its end; what lies between its sides sees no side
/// from outside. `goes_on`: the cell before has the same pane, or the ray begins here.
float filter_depth(int code, bool goes_on, vec3 middle, vec3 inverse, vec2 span) {
    vec3 axis = partition_axis(code);
    float center = dot(middle * inverse, axis);
    float half_way = pane_radius * dot(abs(inverse), axis);
    bool enters = center - half_way > span.x || (!goes_on && center + half_way > span.x);
    float crossed = float(enters && center - half_way <= span.y);
    return is_tinted_pane(code) ? crossed : max(0.0, span.y - span.x);
}

/// Where a ray meets a block in its cell.
struct Meeting {
    bool found;
    float t;    // distance along the ray
    vec3 axis;  // 0 where it enters the cell; else the normal, times -stride: of a plane through the middle, 1 along an axis
};

/// Where a ray meets what is drawn of a translucent block: a stained pane within its cell. `span`: as for filter_depth.
Meeting side_of_filter(Walk walk, int code, vec2 span) {
    vec3 axis = partition_axis(code);
    float t = dot((walk.cell + 0.5 - walk.origin - pane_radius * walk.stride) * walk.inverse, axis);
    return Meeting(is_tinted_pane(code), max(t, span.x), axis);
}

/// Panes part what light falls on the two halves of the faces beside them. Is a hit on the upper one?
bool is_beyond_pane(Hit hit, vec3 cell, int code) {
    vec3 axis = parted_axis(code, ivec3(cell));
    if (axis == vec3(0.0)) return false;
    bool beside = vec3(hit.cell) + hit.normal == cell && dot(hit.normal, axis) == 0.0 && is_full(hit.voxel.code);
    return beside && dot(hit.position - cell, axis) > 0.5;
}

/// The first of these octants that the ray comes into: where it enters the cell, or by one of the planes
/// through its middle. `span` of meet: distances to where it enters, negative if it begins here, and leaves.
Meeting meet_octants(Walk walk, uint octants, vec2 span) {
    vec4 at = vec4((walk.cell + 0.5 - walk.origin) * walk.inverse, span.x);
    uvec4 x = uvec4(equal(lessThanEqual(at.xxxx, at), bvec4(walk.stride.x > 0.0)));
    uvec4 y = uvec4(equal(lessThanEqual(at.yyyy, at), bvec4(walk.stride.y > 0.0)));
    uvec4 z = uvec4(equal(lessThanEqual(at.zzzz, at), bvec4(walk.stride.z > 0.0)));
    uvec4 filled = uvec4(octants) >> (x + 2u * y + 4u * z) & 1u;
    const float never = 1e9;
    at += never * vec4(equal(filled, uvec4(0u)));
    at += never * vec4(lessThan(at, vec4(max(span.x, 0.0))));
    float t = min(min(at.x, at.y), min(at.z, at.w));
    bool x_first = t == at.x;
    bool y_first = !x_first && t == at.y;
    vec3 axis = vec3(x_first, y_first, !x_first && !y_first);
    // In a corner of the cell the ray has no length, but stops as well.
    return Meeting(t <= max(span.x, span.y), t, t < at.w ? axis : vec3(0.0));
}

/// Is this point of a block's side in one of its holes? Those of doors: a square in each quarter, as large as what the
/// texture leaves open. `within`: from the lower end of the cell; `normal`: of the side, out of the block.
bool in_hole(int code, vec3 within, vec3 normal) {
    if (is_glass(code) || is_pane(code)) return in_texture_hole(code, face_of(normal), within);
    vec3 off = abs(fract(2.0 * within) - 0.5) * (1.0 - abs(normal));
    return max(off.x, max(off.y, off.z)) < 0.5 * sqrt(hole_share(code));
}

/// 1 where the two are equal, of x, y, z the first.
vec3 axis_of(float t, vec3 at) {
    bool x = t == at.x;
    bool y = !x && t == at.y;
    return vec3(x, y, !x && !y);
}

/// The first box of a fence, wall or chest that the ray comes into from outside. Of a pane only the two large sides are
/// drawn: a ray passes the holes of both, or stops at the inside of the second, where it may begin.
Meeting meet_post(Walk walk, int code) {
    Meeting met = Meeting(false, 1e9, vec3(0.0));
    uint parts = post_boxes(code) > 0 ? kept_shape(cell_of(walk)) : 0u;
    vec3 from = walk.origin - walk.cell - 0.5;  // the middle of the cell
    for (int i = 0; i < post_boxes(code); ++i) {
        Box box = post_box(code, i);
        vec3 a = (box.low - from) * walk.inverse;
        vec3 b = (box.high - from) * walk.inverse;
        vec3 near = min(a, b);
        vec3 far = max(a, b);
        float t = max(near.x, max(near.y, near.z));
        float leave = min(far.x, min(far.y, far.z));
        bool begins = is_pane(code) && t <= 0.0 && leave > 0.0;
        bool hit = has_part(code, parts, i) && (t > 0.0 || begins) && t <= leave;
        if (!hit || t >= met.t) continue;
        vec3 axis = axis_of(t, near);
        vec3 normal = -axis * walk.stride;
        if (is_glass(code)) normal = plate_normal(i);
        bool passes = begins || !has_side(code, parts, i, normal) || in_hole(code, from + walk.direction * t + 0.5, normal);
        if (passes && is_pane(code)) {
            t = leave;
            axis = axis_of(t, far);
            normal = axis * walk.stride;
            passes = t >= met.t || !has_side(code, parts, i, normal) || in_hole(code, from + walk.direction * t + 0.5, normal);
        }
        if (!passes) met = Meeting(true, t, axis);
    }
    return met;
}

/// Is the lava of a cell whole, since there is lava above it?
bool is_whole_lava(ivec3 cell) { return int(texel_of(cell + ivec3(0, 1, 0)).a * 255.0 + 0.5) == voxel_lava; }

/// Lava up to its surface.
Meeting meet_lava(Walk walk, vec2 span) {
    bool surface = !is_whole_lava(cell_of(walk));
    vec2 below = below_surface(span, walk.cell.y + water_height - walk.origin.y, walk.direction.y);
    if (!surface || below.x <= span.x) return Meeting(!surface || below.x < below.y, span.x, vec3(0.0));
    return Meeting(below.x <= below.y, below.x, vec3(0.0, 1.0, 0.0));
}

/// Does a side of leaves or of fire let a ray pass? `outward`: its normal, out of the block; `toward`: to where the ray comes from.
bool is_side_open(int code, vec3 outward, vec3 toward, vec3 within) {
    if (is_fire(code)) return outward.y != 0.0 || in_hole_of_plane(code, within - 0.5, toward);
    return in_texture_hole(code, face_of(outward), within);
}

/// The side of a block of leaves, or of fire, that stops a ray: that by which it comes in, or from inside that by which it goes
/// out; towards a full block leaves have none. `begins`: as in meet_planes.
Meeting meet_sides(Walk walk, int code, bool begins) {
    vec3 came = plane_distances(walk, 0.0);
    vec3 leave = plane_distances(walk, 1.0);
    vec3 from = walk.origin - walk.cell;
    float t = max(came.x, max(came.y, came.z));
    vec3 toward = -axis_of(t, came) * walk.stride;
    if (!begins && !is_side_open(code, toward, toward, from + walk.direction * t)) return Meeting(true, t, vec3(0.0));
    t = min(leave.x, min(leave.y, leave.z));
    vec3 outward = axis_of(t, leave) * walk.stride;
    int beyond = voxel_at(cell_of(walk) + ivec3(outward)).code;
    bool drawn = is_fire(code) || beyond == voxel_leaves || !is_full(beyond);
    bool found = drawn && !is_side_open(code, outward, -outward, from + walk.direction * t);
    return Meeting(found, t, -outward * walk.stride);
}

/// The plane through the middle of a plant or of fire that a ray meets first, from the side that has this texel.
Meeting meet_crossed(Walk walk, int code) {
    vec3 middle = walk.cell + 0.5 - walk.origin;
    Meeting met = Meeting(false, 1e9, vec3(0.0));
    for (int i = 0; i < 2; ++i) {
        vec3 normal = plane_through_middle(code, i);
        float slope = dot(normal, walk.direction);
        float t = dot(normal, middle) / slope;
        normal *= -sign(slope);
        vec2 at = place_on_plane(code, walk.direction * t - middle, normal);
        bool inside = all(greaterThanEqual(at, vec2(0.0))) && all(lessThanEqual(at, vec2(1.0)));
        if (t > 0.0 && t < met.t && inside && !is_hole(holes_of_plane(code), at)) met = Meeting(true, t, -normal * walk.stride);
    }
    return met;
}

/// The plane of a portal that looks to where a ray comes from.
Meeting meet_portal(Walk walk, int code) {
    vec3 axis = partition_axis(code);
    vec3 plane = walk.cell + 0.5 - portal_radius * walk.stride;
    float t = dot((plane - walk.origin) * walk.inverse, axis);
    vec3 off = abs(walk.origin + walk.direction * t - walk.cell - 0.5) * (1.0 - axis);
    return Meeting(t > 0.0 && max(off.x, max(off.y, off.z)) <= 0.5, t, axis);
}

/// What of leaves, a plant, a portal or fire stops a ray? `begins`: it begins in the cell. From outside fire is a cube with holes,
/// which stops the ray where it comes in: its faces are those of a cube.
Meeting meet_planes(Walk walk, int code, bool begins) {
    Meeting met = Meeting(false, 0.0, vec3(0.0));
    if (is_portal(code)) met = meet_portal(walk, code);
    if (code == voxel_leaves || is_fire(code)) met = meet_sides(walk, code, begins);
    if (is_plant(code) || is_fire(code)) {
        Meeting crossed = meet_crossed(walk, code);
        if (crossed.found && (!met.found || crossed.t < met.t)) met = crossed;
    }
    if (is_fire(code) && !begins) met.axis = vec3(0.0);
    return met;
}

/// Does a ray meet the ball of a small lamp in that cell?
bool meets_ball(ivec3 cell, vec3 origin, vec3 direction) {
    vec3 to_center = vec3(cell) + 0.5 - origin;
    float along = dot(to_center, direction);
    return along > 0.0 && dot(to_center, to_center) - along * along < small_lamp_radius * small_lamp_radius;
}

/// Do rays begin on the faces of a lamp?
bool begins_on_lamp = false;

/// Do rays from a point of a cell see the small lamp in it? What a lamp gives is what leaves it: its own faces do not.
bool sees_own_ball(vec3 off) { return !begins_on_lamp && dot(off, off) > small_lamp_radius * small_lamp_radius; }

/// What of the cell's block stops the ray? `begins`: the ray begins in the cell, on a face that shares it with water above that, with
/// a slab, with the rest of the stairs that it belongs to, or with a small lamp that stands on it.
Meeting meet(Walk walk, int code, bool begins) {
    vec2 span = span_in_cell(walk);
    vec3 within = walk.origin - walk.cell;
    uint octants = octants_of(code, cell_of(walk));
    // What is thinner than half a block has its face inside of what stands for it.
    uint own = octants >> uint(dot(floor(within * 2.0), vec3(1.0, 2.0, 4.0))) & 1u;
    Meeting met = meet_octants(walk, begins && own == 1u ? 0u : octants, span);
    // From above it, off the blocks around it.
    if (code == voxel_lava) met = meet_lava(walk, max(span, 0.0));
#if HAS_VOXEL_CHANGES
    if (has_planes(code) && !(begins && is_fire(code) && begins_on_lamp)) met = meet_planes(walk, code, begins);
#endif
    bool sees_ball = is_ball(code) && (!begins || sees_own_ball(within - 0.5));
    met.found = met.found || (sees_ball && meets_ball(cell_of(walk), walk.origin, walk.direction));
#if HAS_VOXEL_CHANGES
    Meeting post = meet_post(walk, code);
    if (post.found && (sees_ball || !is_ball(code))) return post;
#endif
    return met;
}

/// Does a ray meet what stops it? `opaque`: after its first cell, a block that fills its cell, or eighths of it, or clear
/// glass or a pane of it; `boxes`: in its first cell or the next, a pane or another block of boxes. Neither: nothing is looked for.
bool is_stopped(vec3 origin, vec3 direction, bool opaque, bool boxes) {
    Walk walk = begin_walk(origin, direction);
    bool found = false;
    int cells = opaque ? 3 * VOLUME : 2 * int(boxes);
    int i = 0;
    if (cells > 0) do {
        ivec3 cell = cell_of(walk);
        if (!in_volume(cell)) break;
        int code = int(texel_of(cell).a * 255.0 + 0.5);
        bool beyond = opaque && i > 0;
        found = beyond && meet_octants(walk, octants_of(code, cell), span_in_cell(walk)).found;
#if HAS_VOXEL_CHANGES
        if ((boxes && i < 2) || (beyond && is_clear(code))) found = found || meet_post(walk, code).found;
#endif
        if (i == 0) leave_cube(walk, 1.0);
        else walk_on(walk);
    } while (++i < cells && !found);
    return found;
}

/// Are planes through the middle of a cell what a ray meets inside of it?
bool has_middle(int code) { return !is_post(code) && code != voxel_lava && !has_planes(code) && !is_tinted_pane(code); }

/// Where the ray came into its cell, or met a block in it, and what it finds there.
void describe(inout Hit hit, Walk walk, Meeting met, vec4 texel) {
    vec3 came = plane_distances(walk, 0.0);
    bool x = came.x > came.y && came.x > came.z;
    bool y = !x && came.y > came.z;
    bool inside = met.found && met.axis != vec3(0.0);
    hit.cell = cell_of(walk);
    hit.voxel = decode_voxel(texel);
    hit.position = walk.origin + walk.direction * (inside ? met.t : max(0.0, max(came.x, max(came.y, came.z))));
    hit.inner = inside && has_middle(hit.voxel.code);
    hit.normal = -(inside ? met.axis : vec3(x, y, !x && !y)) * walk.stride;
}

// Kinds of rays. What is in the cell of its origin stops one from a face alone.
const int ray_from_point = 0;
const int ray_from_face = 1;
const int ray_of_eye = 2;  // the first side of a translucent block stops it, too, and colours nothing

/// First block from `origin` (volume space) on. `first_code`: what the cell of the origin holds.
Hit trace(vec3 origin, vec3 direction, int first_code, int kind) {
    count_ray();
    Walk walk = begin_walk(origin, direction);
    Hit hit;
    hit.transmittance = vec3(1.0);
    Meeting met = Meeting(false, 0.0, vec3(0.0));
    vec3 last_cell = walk.cell;
    int last_code = first_code;
    bool as_drawn = kind == ray_of_eye;
    vec3 last_color = as_drawn ? texel_of(cell_of(walk)).rgb : vec3(0.0);
    if (kind != ray_from_face) walk_on(walk);
    // What a full block stops has no turn here, and branches save nothing on some drivers.
    int i = 0;
    if (walk.reach != stopped && in_volume(cell_of(walk))) do {
        vec4 texel = texel_of(cell_of(walk));
        int code = int(texel.a * 255.0 + 0.5);
        met = meet(walk, code, kind == ray_from_face && i == 0);
        if (met.found) break;
        if (is_filter_voxel(code)) {
            vec2 span = max(span_in_cell(walk), 0.0);
            if (code == voxel_water_surface)
                span = below_surface(span, walk.cell.y + water_height - origin.y, walk.direction.y);
            float depth = filter_depth(code, last_code == code, walk.cell + 0.5 - origin, walk.inverse, span);
            // Between blocks of a kind no side is drawn, but for panes. Bytes are rounded by chance.
            bool other_color = any(greaterThan(abs(texel.rgb - last_color), vec3(1.5 / 255.0)));
            bool is_side = last_code != code || is_tinted_pane(code) || (code == voxel_translucent && other_color);
            if (as_drawn && depth > 0.0 && is_side) {
                met = side_of_filter(walk, code, span);
                break;
            }
            if (!as_drawn) hit.transmittance *= filtered(decode_voxel(texel).color, depth);
            last_color = texel.rgb;
        }
        last_cell = walk.cell;
        last_code = code;
        walk_on(walk);
    } while (++i <= 3 * VOLUME && walk.reach != stopped && in_volume(cell_of(walk)));
    hit.found = in_volume(cell_of(walk));
    vec4 texel = hit.found ? texel_of(cell_of(walk)) : vec4(0.0);
    describe(hit, walk, met, texel);
    hit.inner = hit.inner || is_beyond_pane(hit, last_cell, last_code);
    return hit;
}

#endif
