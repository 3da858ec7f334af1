// Where in the atlas the textures of stained glass, ice and slime lie, for mirrors, which show them as they are drawn: voxels
// have their mean colour alone. In voxel_sums: a bit of the byte that stairs keep their octants in, one of five by chance, and for
// each of these, behind the pictures of holes, a word: a texture. Of two textures with one number the larger word stays, whoever
// writes first, so that frames are alike.
#if !defined INCLUDED_VOXELS_TILES
#define INCLUDED_VOXELS_TILES

#include "/include/voxels/holes.glsl"

const int tile_count = 5;
const uint tile_bits = 31u;

ivec2 word_of_tile(int tile) { return holes_of_picture(hole_pictures) + ivec2(tile, 0); }

#if defined HAS_OCTANT_WRITES
/// A texture in a word: how often each axis of the atlas is halved to have its size, 4 bits each, and which of these parts it is, 12
/// bits each. Atlases and textures are powers of two wide, and textures lie at multiples of their size. `place`: lower and upper end.
uint pack_tile(vec4 place) {
    vec2 halvings = clamp(round(-log2(place.zw - place.xy)), 0.0, 12.0);
    uvec2 part = uvec2(floor(0.5 * (place.xy + place.zw) * exp2(halvings)));
    return uint(halvings.x) | uint(halvings.y) << 4 | part.x << 8 | part.y << 20;
}

/// `place`: lower and upper end of the texture of a block in the atlas.
void note_tile(ivec3 cell, vec4 place) {
    uint word = pack_tile(place);
    int tile = int(hash(uvec3(word)).x % uint(tile_count));
    add_octants(cell, 1u << uint(tile));
    imageAtomicMax(voxel_sums, word_of_tile(tile), word);
}
#elif HAS_VOXEL_CHANGES
// Off the edges of a texture, as a share of it.
const float tile_inset = 0.001;

/// A place of a texture in the atlas. `word`: as packed; `at`: 0..1.
vec2 place_in_tile(uint word, vec2 at) {
    vec2 part = vec2(word >> 8 & 4095u, word >> 20);
    return (part + clamp(at, tile_inset, 1.0 - tile_inset)) * exp2(-vec2(word & 15u, word >> 4 & 15u));
}

/// The texture of a translucent block, as packed; 0: it is not known.
uint tile_of(ivec3 cell) {
    uint bits = kept_shape(cell) & tile_bits;
    return bits == 0u ? 0u : imageLoad(voxel_sums, word_of_tile(int(log2(float(bits & (~bits + 1u))) + 0.5))).r;
}

/// Which place of its texture, 0..1, a point of a side shows. `within`: from the lower end of the cell; `normal`: of the side.
/// Textures are drawn as the game does, upright, and unmirrored from outside.
vec2 place_on_side(vec3 within, vec3 normal) {
    vec3 back = 1.0 - within;
    vec2 at = vec2(normal.z > 0.0 ? within.x : back.x, back.y);
    if (normal.x != 0.0) at.x = normal.x > 0.0 ? back.z : within.z;
    if (normal.y != 0.0) at = vec2(within.x, normal.y > 0.0 ? within.z : back.z);
    return at;
}
#endif

#endif
