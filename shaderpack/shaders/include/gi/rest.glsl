// The picture at rest: where eye and blocks have stayed for so long that all means are full, one more sample
// makes none better, so a frame draws an eighth of it, bands in turn. The rest of a target that is not cleared
// is the frame before. What changes without an edit of blocks (time of day, weather, what moves about) then
// takes eight frames where it took one. Bands, since drivers leave out what is not drawn, not single pixels.
#if !defined INCLUDED_GI_REST
#define INCLUDED_GI_REST

#include "/include/uniforms.glsl"

bool camera_is_still() {
    return cameraPosition == previousCameraPosition &&
           gbufferModelView == gbufferPreviousModelView &&
           gbufferProjection == gbufferPreviousProjection;
}

const int rest_bands = 8;

#if HAS_REST && defined VERTEX_STAGE
#include "/include/face_cache/face_cache.glsl"

uniform usampler2D face_list_texture;

// Full means forget what they held before in so many frames, all but a twentieth: exp(-history_ramp).
const int still_frames = TEMPORAL_FRAMES;

bool picture_rests() {
    int edited = int(texelFetch(face_list_texture, last_edit, 0).r) + face_hurry_frames;
    int moved = int(texelFetch(face_list_texture, last_motion, 0).r);
    return frameCounter - max(edited, moved) >= still_frames;
}

/// A corner of the rectangle that covers the picture to one of what has to be drawn of it.
vec4 drawn_corner(vec4 corner) {
    float below = float(frameCounter % rest_bands);
    if (picture_rests()) corner.y = (corner.y + 1.0 + 2.0 * below) / float(rest_bands) - 1.0;
    return corner;
}

/// Counts the frames in which a pixel is drawn.
int number_of_drawing() { return picture_rests() ? frameCounter / rest_bands : frameCounter; }

/// The band that the next frame draws; -1: all of the picture.
int next_band() { return picture_rests() ? (frameCounter + 1) % rest_bands : -1; }
#else
vec4 drawn_corner(vec4 corner) { return corner; }

int number_of_drawing() { return frameCounter; }

int next_band() { return -1; }
#endif

/// Is a pixel in this band, or in the picture? `row`: of its middle, in pixels.
bool in_band(int band, float row) { return band < 0 || int(row / viewHeight * float(rest_bands)) == band; }

#endif
