// Clusters of the view: tiles of the screen times slices of distance along the view's axis
// (Olsson et al. 2012, "Clustered Deferred and Forward Shading"). TILED has one slice.
//
//   light_bits   r32ui, kept: (word, tile, slice), one bit a lamp; what is in the list leaves it, what
//                has no room there stays, and is asked for by its bit; in the word length_word how
//                many they are (list_length.glsl)
//   light_list   r16ui, kept: (entry, tile, slice), indices into the table, in their order
//
// Which cluster a surface is in follows from where it is, not from the pixel or the depth buffer, so
// translucent surfaces and any projection have one too.
#if !defined INCLUDED_LIGHTS_GRID
#define INCLUDED_LIGHTS_GRID

#include "/include/lights/list_length.glsl"
#include "/include/uniforms.glsl"

const int grid_columns = LIGHT_COLUMNS;
const int grid_rows = LIGHT_ROWS;
const int grid_tiles = grid_columns * grid_rows;
const int grid_slices = LIGHT_GRID_SLICES;
const int grid_clusters = grid_tiles * grid_slices;

const uint list_capacity = uint(LIGHT_LIST);
const int length_word = LIGHT_CAPACITY / 32;

// Slice 0 ends at first_slice; the others divide the way from there to far_slice, the last has no end.
const float first_slice = LIGHT_FIRST_SLICE;
const float far_slice = float(LIGHT_DISTANCE);
const float log_slices = float(max(grid_slices - 1, 1));

/// Distance at which a slice begins. 0 for the first.
float slice_start(int slice) {
    if (slice <= 0) return 0.0;
#if LIGHT_SLICING == LIGHT_SLICING_LINEAR
    return far_slice * float(slice) / float(grid_slices);
#else
    return first_slice * exp2(float(slice - 1) * (log2(far_slice / first_slice) / log_slices));
#endif
}

/// The slice of a distance. Logarithm and power of a driver need not agree, so the guess is corrected
/// by the very bounds that lamps are assigned by.
int slice_of(float distance_along) {
#if LIGHT_SLICING == LIGHT_SLICING_LINEAR
    float guess = distance_along * (float(grid_slices) / far_slice);
#else
    float guess = 1.0 + log2(max(distance_along, 1e-6) / first_slice) *
                            (log_slices / log2(far_slice / first_slice));
#endif
    int slice = int(clamp(floor(guess), 0.0, float(grid_slices - 1)));
    if (slice > 0 && distance_along < slice_start(slice)) slice -= 1;
    if (slice < grid_slices - 1 && distance_along >= slice_start(slice + 1)) slice += 1;
    return slice;
}

/// Half the screen in units of distance: at distance 1 it ends at +-1 / scale.
vec2 tile_scale() { return vec2(gbufferProjection[0][0], gbufferProjection[1][1]); }

/// The column (axis 0) or row (axis 1) of a slope, x or y over distance; the nearest of those beside
/// the screen.
int tile_of(float slope, int axis) {
    int count = axis == 0 ? grid_columns : grid_rows;
    float place = (slope * tile_scale()[axis] * 0.5 + 0.5) * float(count);
    return int(floor(clamp(place, 0.0, float(count) - 0.5)));
}

/// Slope at which a column or row begins.
float tile_start(int tile, int axis) {
    int count = axis == 0 ? grid_columns : grid_rows;
    return (float(tile) / float(count) * 2.0 - 1.0) / tile_scale()[axis];
}

// What is beside the screen, as a hand that is drawn by another projection, has no cluster.
const ivec2 no_cluster = ivec2(-1, 0);

/// x: tile, y: slice.
ivec2 cluster_of(vec3 view) {
    float distance_along = max(-view.z, 1e-4);
    vec2 slope = view.xy / distance_along;
    if (any(greaterThan(abs(slope * tile_scale()), vec2(1.0)))) return no_cluster;
    return ivec2(tile_of(slope.y, 1) * grid_columns + tile_of(slope.x, 0), slice_of(distance_along));
}

#endif
