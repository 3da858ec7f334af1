// How the samples of a pixel are shared between rays into the hemisphere and rays to lamps: half of them each. A single one takes
// turns, over frames and over squares of 4 x 4 pixels, and the squares of a kind lie side by side in the target of its samples, so
// that what either kind costs is spent on half of the picture: drivers run for each pixel what any may need.
#if !defined INCLUDED_GI_TURNS
#define INCLUDED_GI_TURNS

#if defined VERTEX_STAGE
#include "/include/face_cache/face_cache.glsl"

uniform usampler3D face_seen_texture;

int listed_lamps() { return int(texelFetch(face_seen_texture, listed_lamps_texel, 0).r); }
#endif

const int square_side = 4;

bool kinds_take_turns(int lamps) { return GI_SAMPLES == 1 && lamps > 0; }

/// Does the pixel's n-th sample go to a lamp? `number`: then that among its samples of the kind.
bool is_turn_of_lamps(ivec2 pixel, inout int number) {
    ivec2 square = pixel / square_side;
    int turn = number + square.x + square.y;
    number = turn >> 1;
    return (turn & 1) == 1;
}

/// Where the sample of a pixel is, of the squares side by side.
ivec2 place_of_sample(ivec2 pixel) {
    return ivec2(pixel.x / (2 * square_side) * square_side + pixel.x % square_side, pixel.y);
}

/// How many pixels wide a picture is there.
int width_of_samples(int width) { return (width + 2 * square_side - 1) / (2 * square_side) * square_side; }

/// The pixel whose n-th sample, of the kind, is there. It may lie beyond the picture's right side.
ivec2 pixel_of_sample(ivec2 place, int number, bool to_lamp) {
    ivec2 square = place / square_side;
    int odd = (number + square.y + int(to_lamp)) & 1;
    return ivec2((2 * square.x + odd) * square_side + place.x % square_side, place.y);
}

#endif
