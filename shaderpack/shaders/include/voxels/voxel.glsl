// One voxel is one RGBA8 texel of shadowcolor0: rgb is the square root of the linear albedo or, of a small lamp, light
// colour, the fourth root of a tint; a one of the codes below.
#if !defined INCLUDED_VOXELS_VOXEL
#define INCLUDED_VOXELS_VOXEL

#include "/include/blocks.glsl"

const int voxel_air = 0;
const int voxel_solid = 1;
const int voxel_slab_bottom = 2;
const int voxel_slab_top = 3;
const int voxel_translucent = 4;
const int voxel_water_surface = 5;  // translucent up to water_height
const int voxel_stairs = 6;  // fills a part of its cell: include/voxels/octants.glsl
const int voxel_fence = 7;   // posts with arms: include/voxels/posts.glsl
const int voxel_wall = 8;
const int voxel_chest = 9;
const int voxel_plate = 10;  // .. 15: doors and trapdoors, with holes of 0..5 eighths
const int voxel_glass = 16;  // the sides that are drawn, with holes: include/voxels/holes.glsl
const int voxel_pane = 17;   // a post with arms, thin, with such holes
const int voxel_small_lamp = 32;  // + light level 1..15, a ball in the cell
const int voxel_cover = 48;       // a carpet on the floor of the cell
const int voxel_tinted_pane = 49;  // a stained pane across x; + 1: across z
const int voxel_leaves = 51;       // the sides of the cell, with holes: include/voxels/holes.glsl
const int voxel_plant = 52;        // .. 59: two crossed planes, with holes by one of eight pictures
const int voxel_fire = 60;         // four planes at the sides and two in the middle, with holes
const int voxel_portal = 61;       // a portal across x; + 1: across z
const int voxel_soul_fire = 63;
const int voxel_lamp = 64;        // + 16 * digit of lamp_color + light level 1..15, fills the cell

// Lava: the only lamp of its colour at that level. With something else above it it ends where water does.
const int voxel_lava = voxel_lamp + 16 * 9 + 15;

// Of still water with air above it, as the game draws it.
const float water_height = 8.0 / 9.0;

// How far the planes of a portal lie off the middle of the cell.
const float portal_radius = 0.125;

// The ball of a small lamp, and how much brighter it is than a full block of that level: about
// the ratio of the areas seen.
const float small_lamp_radius = 0.25;
const float small_lamp_boost = 5.0;

struct Voxel {
    vec3 color;  // linear: albedo, tint or light colour
    int code;
};

bool is_tinted_pane(int code) { return code == voxel_tinted_pane || code == voxel_tinted_pane + 1; }

/// Does the block fill its cell?
bool is_full(int code) { return code == voxel_solid || code == voxel_leaves || code >= voxel_lamp; }

/// Light passes, and takes its colour.
bool is_filter_voxel(int code) {
    return code == voxel_translucent || code == voxel_water_surface || is_tinted_pane(code);
}

// Stained glass passes a few thousandths of the other colours: three percent of that are a step of a fourth root.
vec4 encode_voxel(vec3 color, int code) {
    vec3 root = sqrt(clamp(color, 0.0, 1.0));
    return vec4(is_filter_voxel(code) ? sqrt(root) : root, float(code) / 255.0);
}

Voxel decode_voxel(vec4 texel) {
    vec3 square = texel.rgb * texel.rgb;
    int code = int(texel.a * 255.0 + 0.5);
    return Voxel(is_filter_voxel(code) ? square * square : square, code);
}

/// A small lamp.
bool is_ball(int code) { return code >= voxel_small_lamp && code < voxel_cover; }

bool is_portal(int code) { return code == voxel_portal || code == voxel_portal + 1; }

bool is_fire(int code) { return code == voxel_fire || code == voxel_soul_fire; }

/// A stained pane or a portal: it parts its cell.
bool is_partition(int code) { return is_tinted_pane(code) || is_portal(code); }

/// What a partition lies across: x if its code is odd.
vec3 partition_axis(int code) { return (code & 1) == 1 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 0.0, 1.0); }

bool is_lamp_voxel(int code) { return code >= voxel_fire || is_ball(code); }

/// The light level of a lamp.
int level_of_lamp(int code) {
    return code >= voxel_lamp || is_ball(code) ? code & 15 : code == voxel_fire ? 15 : code == voxel_soul_fire ? 10 : 11;
}

bool is_plate(int code) { return code >= voxel_plate && code < voxel_glass; }

bool is_glass(int code) { return code == voxel_glass; }

bool is_pane(int code) { return code == voxel_pane; }

/// Do rays meet it by planes inside of its cell or about it, which have holes or lie off the middle?
bool has_planes(int code) { return code >= voxel_leaves && code < voxel_lamp; }

/// A portal or fire.
bool has_planes_of_lamp(int code) { return code >= voxel_fire && code < voxel_lamp; }

bool is_plant(int code) { return code >= voxel_plant && code < voxel_plant + 8; }

/// Is it lit from both sides?
bool is_thin(int code) { return code == voxel_leaves || is_plant(code); }

/// Light passes it by the holes of its texture.
bool is_clear(int code) { return is_glass(code) || is_pane(code); }

/// What holes take of a side of a door or trapdoor.
float hole_share(int code) { return is_plate(code) ? float(code - voxel_plate) / 8.0 : 0.0; }

/// Light of the propagation does not pass; slabs leave half of their cell open.
bool is_opaque_voxel(int code) {
    return code == voxel_solid || code == voxel_leaves || code == voxel_stairs || is_plate(code) || is_lamp_voxel(code);
}

/// As bright as a colour of that hue can be.
vec3 brightest(vec3 color) { return color / max(max(color.r, color.g), max(color.b, 1e-3)); }

/// Radiance of a lamp of that colour and level, as a block that fills its cell.
vec3 lamp_radiance(vec3 color, int level) {
    float share = float(level) / 15.0;
    return color * (EMISSION_STRENGTH * share * share);
}

vec3 lamp_radiance(Voxel v) {
    int of_planes = v.code == voxel_fire ? block_fire : v.code == voxel_soul_fire ? block_soul_fire : block_portal;
    int digit = is_ball(v.code) ? 0 : v.code < voxel_lamp ? of_planes : (v.code - voxel_lamp) >> 4;
    return lamp_radiance(digit == 0 ? brightest(v.color) : lamp_color(digit), level_of_lamp(v.code));
}

/// What a block sends back; balls are not there for that.
vec3 voxel_albedo(Voxel v) { return is_ball(v.code) ? vec3(0.0) : v.color; }

/// What is left of light after so many blocks of a translucent colour.
vec3 filtered(vec3 color, float thickness) { return pow(max(color, vec3(1e-3)), vec3(thickness)); }

#if defined HAS_VOXEL_READS
#include "/include/voxels/volume.glsl"

uniform sampler2D shadowcolor0;

/// Air outside the volume.
Voxel voxel_at(ivec3 cell) {
    if (!in_volume(cell)) return Voxel(vec3(0.0), voxel_air);
    return decode_voxel(texelFetch(shadowcolor0, atlas_texel(cell), 0));
}
#endif

#endif
