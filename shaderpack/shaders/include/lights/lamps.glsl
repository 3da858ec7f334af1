// Lamps as a list: every block that gives light within LIGHT_DISTANCE of the camera, collected by the
// shadow pass, sorted by place, so that frames are reproducible.
//
//   lamp_cells   r32ui, empty when a frame begins: what lamp a cell holds (pack_lamp), 0 none
//   lamp_tally   r32ui, empty when a frame begins: lamps of a row along x at (y, z), those of a layer z
//                at (lamp_volume, z), and sums beside them, lamp_checksum and so on
//   light_table  rgba32f, kept: two texels a lamp in rows of table_width, (place, 1 / range^2) and
//                (intensity, radius^2 or minus a spot's direction - 1)
//   light_state  r32ui, kept: texels state_*, what the table and the grid were made for
//
// Of lights_changed() and view_changed() everything else follows: nothing is made anew in frames
// where neither holds.
#if !defined INCLUDED_LIGHTS_LAMPS
#define INCLUDED_LIGHTS_LAMPS

#include "/include/uniforms.glsl"

// Cells along an axis. Lamp space: player space + cameraPositionFract + LIGHT_DISTANCE.
const int lamp_volume = 2 * LIGHT_DISTANCE;

const uint table_capacity = uint(LIGHT_CAPACITY);
const int table_width = 512;  // lamps in a row

// AUTO: up to so many lamps it costs no more to ask all than to look up which; docs/results/many-lights.md.
const uint auto_lamps = 8u;

/// Do so many lamps of the table get lists by cluster?
bool has_lists(uint lamps) {
#if LIGHT_METHOD == AUTO
    return lamps > auto_lamps;
#elif HAS_LIGHT_GRID
    return true;
#else
    return false;
#endif
}

const int kind_cube = 1;  // a lamp that fills its cell
const int kind_ball = 2;  // a small one
const int kind_spot = 3;  // + 0..5 = towards -x +x -y +y -z +z: a small one that shines one way

const ivec2 lamp_checksum = ivec2(lamp_volume + 1, 0);
const ivec2 lamp_total = ivec2(lamp_volume + 1, 1);
const ivec2 lamp_spilled = ivec2(lamp_volume + 1, 2);
const ivec2 lamp_longest = ivec2(lamp_volume + 1, 3);
const ivec2 lamp_entries = ivec2(lamp_volume + 1, 4);

const int state_checksum = 0;
const int state_lamps = 1;          // in the table
const int state_lamps_dropped = 2;  // for which it had no room
const int state_spilled = 3;        // entries beyond the room of their list, asked for by bits
const int state_longest = 4;        // most lamps of a cluster
const int state_entries = 5;        // of all clusters
const int state_tables = 6;         // how often the table was made
const int state_grids = 7;          // how often the lists were made

vec3 to_lamp_space(vec3 player) { return player + cameraPositionFract + float(LIGHT_DISTANCE); }

vec3 from_lamp_space(vec3 place) { return place - cameraPositionFract - float(LIGHT_DISTANCE); }

bool in_lamp_volume(ivec3 cell) {
    return all(greaterThanEqual(cell, ivec3(0))) && all(lessThan(cell, ivec3(lamp_volume)));
}

/// Share of the block light of the lightmap that lamps of the list do not replace: 0 in their volume,
/// 1 outside, over four cells.
float unlisted_share(vec3 player) {
    vec3 place = to_lamp_space(player);
    vec3 margin = min(place, float(lamp_volume) - place);
    return 1.0 - clamp(min(margin.x, min(margin.y, margin.z)) / 4.0, 0.0, 1.0);
}

/// `level` 1..15, `color` 0..1.
uint pack_lamp(vec3 color, int level, int kind) {
    uvec3 c = uvec3(sqrt(clamp(color, 0.0, 1.0)) * 255.0 + 0.5);
    return uint(level) | uint(kind) << 4 | c.r << 8 | c.g << 16 | c.b << 24;
}

int packed_level(uint lamp) { return int(lamp & 15u); }

int packed_kind(uint lamp) { return int(lamp >> 4 & 15u); }

vec3 packed_color(uint lamp) {
    vec3 root = vec3(uvec3(lamp >> 8, lamp >> 16, lamp >> 24) & 255u) / 255.0;
    return root * root;
}

ivec2 table_texel(uint lamp) {
    return ivec2(int(lamp) % table_width * 2, int(lamp) / table_width);
}

#endif
