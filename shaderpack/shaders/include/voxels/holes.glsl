// Which texels of clear glass light passes: for each of its sides, and of those of panes and leaves, 16 x 16 bits, as the texture
// of the first such block that the shadow pass meets has them; of eight kinds of plants; and of two of fire. In voxel_sums, behind
// lake_now: two rows of texels a word, and a word that is one more than all that are open, where a picture is known.
#if !defined INCLUDED_VOXELS_HOLES
#define INCLUDED_VOXELS_HOLES

#include "/include/voxels/octants.glsl"

const int hole_words = 8;
const int hole_pictures = 28;

/// The first word of a picture.
ivec2 holes_of_picture(int index) { return lake_now + ivec2(1 + (hole_words + 1) * index, 0); }

/// That of a side: `face` looks out of the block.
ivec2 holes_of_side(int code, int face) { return holes_of_picture(face + (is_pane(code) ? 6 : is_glass(code) ? 0 : 12)); }

/// That of a plant or of fire: its texture, from its upper left corner on.
ivec2 holes_of_plane(int code) { return holes_of_picture(18 + (code == voxel_soul_fire ? 9 : code - voxel_plant)); }

#if defined HAS_OCTANT_WRITES
/// The texture of the quad along two axes of a picture, if it is not known, whatever part of that the quad shows: panes are made
/// in parts. `middle`: of the block. Of quads that are drawn side by side one writes.
void note_holes(ivec2 words, vec3 across, vec3 up, vec3 middle) {
    ivec2 last = words + ivec2(hole_words, 0);
    if (imageLoad(voxel_sums, last).r != 0u || imageAtomicCompSwap(voxel_sums, last, 0u, 1u) != 0u) return;
    mat3x2 per_block = uv_per_block();
    vec3 first = middle - vertex_player[0] - 0.46875 * (across + up);  // the middle of the first texel
    uint known = 1u;
    for (int word = 0; word < hole_words; ++word) {
        uint open = 0u;
        for (int i = 0; i < 32; ++i) {
            vec3 at = first + float(i & 15) / 16.0 * across + float(2 * word + (i >> 4)) / 16.0 * up;
            uint is_open = uint(textureLod(gtexture, vertex_uv[0] + per_block * at, 0.0).a < cutout_alpha);
            open |= is_open << uint(i);
            known += is_open;
        }
        imageStore(voxel_sums, words + ivec2(word, 0), uvec4(open));
    }
    imageStore(voxel_sums, last, uvec4(known));
}
#else
/// Is this place of a picture, 0..1, a hole?
bool is_hole(ivec2 words, vec2 at) {
#if HAS_VOXEL_CHANGES
    uvec2 texel = uvec2(clamp(at * 16.0, 0.0, 15.0));
    uint open = imageLoad(voxel_sums, words + ivec2(texel.y >> 1u, 0)).r;
    return (open >> (texel.x + 16u * (texel.y & 1u)) & 1u) == 1u;
#else
    return false;
#endif
}

/// Is this point of a plane of a plant or of fire in one of its holes? `off`: from the middle of the cell; `normal`: to the side
/// that is seen.
bool in_hole_of_plane(int code, vec3 off, vec3 normal) { return is_hole(holes_of_plane(code), place_on_plane(code, off, normal)); }

/// Is this point of a side in one of its holes? `within`: from the lower end of the cell.
bool in_texture_hole(int code, int face, vec3 within) {
    return is_hole(holes_of_side(code, face), face < 2 ? within.zy : face < 4 ? within.xz : within.xy);
}

/// What the holes take of a picture.
float open_share(ivec2 words) {
#if HAS_VOXEL_CHANGES
    return float(max(imageLoad(voxel_sums, words + ivec2(hole_words, 0)).r, 1u) - 1u) / 256.0;
#else
    return 0.0;
#endif
}
#endif

#endif
