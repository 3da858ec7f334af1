// Block ids of block.properties, by class.
#if !defined INCLUDED_BLOCKS
#define INCLUDED_BLOCKS

const int block_plant = 10;
const int block_leaves = 11;
const int block_open = 12;         // thin shapes: drawn, but light passes
const int block_slab_bottom = 13;
const int block_slab_top = 14;
const int block_stairs = 15;       // what fills some of the eighths of its cell
const int block_fence = 16;        // posts with arms
const int block_wall = 17;
const int block_chest = 18;        // chests, shulker boxes, pots
const int block_plate = 19;        // doors, trapdoors
const int block_water = 20;
const int block_translucent = 21;  // stained glass, ice, slime
const int block_glass = 22;        // clear, a full block
const int block_pane = 23;         // posts with thin arms and holes
const int block_cover = 24;        // carpets
const int block_tinted_pane = 25;  // stained
const int block_polished = 30;     // full blocks with a smooth coat
const int block_metal = 31;        // full blocks
const int block_lamp = 100;        // full cubes, 100 + colour
const int block_fire = 111;        // planes with holes along the sides of the cell and through its middle
const int block_soul_fire = 115;
const int block_portal = 117;      // two planes about the middle
const int block_small_lamp = 200;  // torches and the like, 200 + colour
const int block_spot_lamp = 300;   // small ones that shine one way, 300 + 10 * direction + colour:
                                   // towards -x +x -y +y -z +z
const int block_lamps_end = 360;

/// Not what a roof is made of.
bool lets_light_pass(int id) {
    return id == block_plant || id == block_open || id == block_water || id == block_translucent ||
           id == block_glass || id == block_pane || id == block_tinted_pane;
}

/// Does block.properties list it? What it does not is 65535, 0 or -1.
bool is_block_class(int id) { return id >= block_plant && id < block_lamps_end; }

bool is_lamp(int id) { return id >= block_lamp && id < block_lamps_end; }

bool is_small_lamp(int id) { return id >= block_small_lamp && id < block_lamps_end; }

/// Class of include/brdf/glossy.glsl; 0 is diffuse.
int block_gloss(int id) { return id == block_polished || id == block_metal ? id - block_polished + 1 : 0; }

/// Light colour by the last digits of a lamp's id, linear, brightest channel 1; black means the
/// block's own texture decides.
vec3 lamp_color(int id) {
    const vec3 colors[10] = vec3[10](
        vec3(0.0),               // 0 own texture
        vec3(1.0, 0.56, 0.22),   // 1 fire: torch, lantern, campfire
        vec3(1.0, 0.70, 0.38),   // 2 glowstone, shroomlight, redstone lamp
        vec3(0.78, 0.93, 1.0),   // 3 sea lantern, conduit, beacon
        vec3(1.0, 0.10, 0.04),   // 4 redstone
        vec3(0.16, 0.80, 1.0),   // 5 soul fire
        vec3(1.0, 0.92, 0.84),   // 6 end rod, white
        vec3(0.62, 0.26, 1.0),   // 7 amethyst, crying obsidian, portal
        vec3(0.45, 1.0, 0.36),   // 8 green froglight, sea pickle
        vec3(1.0, 0.34, 0.06));  // 9 lava, magma
    return colors[id % 10];
}

/// Light level where the host gives none with the vertex (Iris before 1.7).
float lamp_level(int id) {
    const float levels[10] =
        float[10](15.0, 14.0, 15.0, 15.0, 7.0, 10.0, 14.0, 10.0, 12.0, 15.0);
    return is_lamp(id) ? levels[id % 10] : 0.0;
}

/// Light level of a vertex's block: at_midBlock.w where it means that, else by id.
float block_emission(int id, float given) {
#if defined IRIS_FEATURE_BLOCK_EMISSION_ATTRIBUTE
    // An attribute that a draw lacks reads (0, 0, 0, 1), which is no lamp.
    return given > 1.5 ? given : 0.0;
#else
    return lamp_level(id);
#endif
}

#endif
