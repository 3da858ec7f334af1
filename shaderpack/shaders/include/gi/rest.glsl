// The picture at rest: the longer eye and blocks have stayed, the less a sample more changes the mean of a pixel, so a frame
// draws a part of the picture, bands in turn: half of it once means hold many samples, an eighth where they are full and get no
// better. The rest of a target that is not cleared is the frame before. What changes without an edit of blocks (time of day,
// weather, what moves about) then takes two or eight frames where it took one. Bands, since drivers leave out what is not drawn,
// not single pixels.
#if !defined INCLUDED_GI_REST
#define INCLUDED_GI_REST

#include "/include/uniforms.glsl"

bool camera_is_still() {
    return cameraPosition == previousCameraPosition &&
           gbufferModelView == gbufferPreviousModelView &&
           gbufferProjection == gbufferPreviousProjection;
}

#if HAS_REST && defined VERTEX_STAGE
#include "/include/face_cache/face_cache.glsl"

uniform usampler2D face_list_texture;

// Frames at rest from which on halves are drawn: means of so many samples have a fifteenth of a sample's noise (sequence_power).
const int halves_from = min(64, TEMPORAL_FRAMES);
// And eighths: a mean has TEMPORAL_FRAMES samples, and what it held before is forgotten, all but a twentieth: exp(-history_ramp).
const int eighths_from = halves_from + 2 * (TEMPORAL_FRAMES - halves_from);

/// For how many frames eye and blocks have stayed, and the cache had time to adapt; less than 0 while it does.
int frames_at_rest() {
    int edited = int(texelFetch(face_list_texture, last_edit, 0).r) + face_hurry_frames;
    int moved = int(texelFetch(face_list_texture, last_motion, 0).r);
    return frameCounter - max(edited, moved);
}

/// The part of the picture's height that a frame draws: where it begins and ends, 0..1. `at_rest`: frames, then.
vec2 band_of(int frame, int at_rest) {
    int bands = at_rest < halves_from ? 1 : at_rest < eighths_from ? 2 : 8;
    return vec2(frame % bands, frame % bands + 1) / float(bands);
}

/// A corner of the rectangle that covers the picture to one of what has to be drawn of it.
vec4 drawn_corner(vec4 corner) {
    vec2 band = band_of(frameCounter, frames_at_rest());
    corner.y = 2.0 * mix(band.x, band.y, 0.5 * corner.y + 0.5) - 1.0;
    return corner;
}

/// Counts the frames in which a pixel is drawn.
int number_of_drawing() {
    int at_rest = frames_at_rest();
    int by_halves = clamp(at_rest - halves_from, 0, eighths_from - halves_from);
    int by_eighths = max(at_rest - eighths_from, 0);
    return frameCounter - by_halves - by_eighths + by_halves / 2 + by_eighths / 8;
}

vec2 next_band() { return band_of(frameCounter + 1, frames_at_rest() + 1); }
#else
vec4 drawn_corner(vec4 corner) { return corner; }

int number_of_drawing() { return frameCounter; }

/// What the next frame draws, as band_of.
vec2 next_band() { return vec2(0.0, 1.0); }
#endif

/// `row`: of a pixel's middle, in pixels.
bool in_band(vec2 band, float row) { return row >= band.x * viewHeight && row < band.y * viewHeight; }

#endif
