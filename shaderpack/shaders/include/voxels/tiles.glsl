// Where in the atlas the textures of stained glass, ice and slime lie, for mirrors, which show them as they are drawn: voxels
// have their mean colour alone. In voxel_sums: a bit of the byte that stairs keep their octants in, one of five by chance, and for
// each of these, behind the pictures of holes, two words: the lower and the upper end of a texture, 0: there is none.
#if !defined INCLUDED_VOXELS_TILES
#define INCLUDED_VOXELS_TILES

#include "/include/voxels/holes.glsl"

const int tile_count = 5;
const uint tile_bits = 31u;

ivec2 words_of_tile(int tile) { return holes_of_picture(hole_pictures) + ivec2(2 * tile, 0); }

#if defined HAS_OCTANT_WRITES
/// `place`: lower and upper end of the texture of a block in the atlas.
void note_tile(ivec3 cell, vec4 place) {
    int tile = int(hash(floatBitsToUint(place.xyy)).x % uint(tile_count));
    add_octants(cell, 1u << uint(tile));
    imageStore(voxel_sums, words_of_tile(tile), uvec4(packUnorm2x16(place.xy)));
    imageStore(voxel_sums, words_of_tile(tile) + ivec2(1, 0), uvec4(packUnorm2x16(place.zw)));
}
#elif HAS_VOXEL_CHANGES
/// Where in the atlas a point of a side lies; 0: the texture is not known. `within`: from the lower end of the cell; `normal`: of
/// the side. Textures are drawn as the game does, upright, and unmirrored from outside.
vec2 place_in_atlas(ivec3 cell, vec3 within, vec3 normal) {
    uint bits = kept_shape(cell) & tile_bits;
    if (bits == 0u) return vec2(0.0);
    ivec2 words = words_of_tile(int(log2(float(bits & (~bits + 1u))) + 0.5));
    vec2 low = unpackUnorm2x16(imageLoad(voxel_sums, words).r);
    vec2 high = unpackUnorm2x16(imageLoad(voxel_sums, words + ivec2(1, 0)).r);
    vec3 back = 1.0 - within;
    vec2 at = vec2(normal.z > 0.0 ? within.x : back.x, back.y);
    if (normal.x != 0.0) at.x = normal.x > 0.0 ? back.z : within.z;
    if (normal.y != 0.0) at = vec2(within.x, normal.y > 0.0 ? within.z : back.z);
    return mix(low, high, at);
}
#endif

#endif
