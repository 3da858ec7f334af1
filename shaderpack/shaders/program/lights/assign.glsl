// Enters each lamp into the clusters that its range touches, as a bit: bits need no order and no room
// to be reserved, and reading them gives sorted lists.
#include "/settings.glsl"

#include "/include/lights/changes.glsl"
#include "/include/lights/grid.glsl"

layout(local_size_x = 64) in;
const ivec3 workGroups = ivec3(64, 1, 1);

layout(rgba32f) uniform readonly image2D light_table;
layout(r32ui) uniform uimage3D light_bits;

// Relative, against rounding: surfaces are placed by other sums than lamps, and both in a space that
// is LIGHT_DISTANCE large.
const float pad = 1e-5;
const float unbounded = 1e6;

struct Sphere {
    vec3 center;    // view space, z the distance along the view's axis
    float radius;
};

Sphere sphere_of(uint lamp) {
    vec4 stored = imageLoad(light_table, table_texel(lamp));
    vec3 view = (gbufferModelView * vec4(from_lamp_space(stored.xyz), 1.0)).xyz;
    float radius = inversesqrt(stored.w);
    return Sphere(vec3(view.xy, -view.z), radius + pad * (radius + length(view) + float(LIGHT_DISTANCE)));
}

/// Slopes between which a circle about (across, along) lies, seen from the origin.
vec2 tangents(float across, float along, float radius) {
    float squared = across * across + along * along - radius * radius;
    if (squared <= 0.0) return vec2(-unbounded, unbounded);
    float t = sqrt(squared);
    float low = along * t + across * radius;
    float high = along * t - across * radius;
    return vec2(low > 0.0 ? (across * t - along * radius) / low : -unbounded,
                high > 0.0 ? (across * t + along * radius) / high : unbounded);
}

/// Slopes of what a slice leaves of the sphere, as a box.
vec2 box_slopes(float across, float radius, vec2 between) {
    float low = across - radius;
    float high = across + radius;
    return vec2(low / (low < 0.0 ? between.x : between.y),
                high / (high < 0.0 ? between.y : between.x));
}

/// First and last tile of an axis; last before first for none.
ivec2 tile_range(Sphere s, int axis, float radius, vec2 between) {
    float across = s.center[axis];
    vec2 outer = tangents(across, s.center.z, s.radius);
    vec2 box = box_slopes(across, radius, between);
    vec2 slopes = vec2(max(outer.x, box.x), min(outer.y, box.y));
    slopes += vec2(-pad, pad) * (1.0 + abs(slopes));
    float edge = 1.0 / tile_scale()[axis];
    if (slopes.x > edge || slopes.y < -edge) return ivec2(0, -1);
    return ivec2(tile_of(slopes.x, axis), tile_of(slopes.y, axis));
}

/// Distance along an axis from the centre to the part of a tile that lies between two distances.
float gap(Sphere s, int tile, int axis, vec2 between) {
    float start = tile_start(tile, axis);
    float end = tile_start(tile + 1, axis);
    float low = start * (start < 0.0 ? between.y : between.x);
    float high = end * (end < 0.0 ? between.x : between.y);
    return max(max(low - s.center[axis], s.center[axis] - high), 0.0);
}

void assign(uint lamp, Sphere s, int slice) {
    bool last = slice == grid_slices - 1;
    vec2 slab = vec2(slice_start(slice), last ? unbounded : slice_start(slice + 1));
    // What the sphere has in the slice, never nearer than surfaces are.
    vec2 between = vec2(max(slab.x, s.center.z - s.radius), min(slab.y, s.center.z + s.radius));
    between = max(between * vec2(1.0 - pad, 1.0 + pad), 1e-4);
    float off = max(max(slab.x - s.center.z, s.center.z - slab.y), 0.0) * (1.0 - pad);
    float radius = sqrt(max(s.radius * s.radius - off * off, 0.0));
    ivec2 columns = tile_range(s, 0, radius, between);
    ivec2 rows = tile_range(s, 1, radius, between);
    uint bit = 1u << (lamp & 31u);
    for (int row = rows.x; row <= rows.y; ++row) {
        float high = gap(s, row, 1, between);
        for (int column = columns.x; column <= columns.y; ++column) {
            float wide = gap(s, column, 0, between);
            if (wide * wide + high * high > radius * radius) continue;
            ivec3 word = ivec3(int(lamp >> 5), row * grid_columns + column, slice);
            imageAtomicOr(light_bits, word, bit);
        }
    }
}

void main() {
    uint lamps = grid_changed() ? listed_lamps() : 0u;
    uint threads = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
    for (uint lamp = gl_GlobalInvocationID.x; lamp < lamps; lamp += threads) {
        Sphere s = sphere_of(lamp);
        float far = s.center.z + s.radius;
        // Lamps wholly behind the camera reach nothing that is seen.
        int first = slice_of(max(s.center.z - s.radius, 0.0) * (1.0 - pad));
        int last = far > 0.0 ? slice_of(far * (1.0 + pad)) : -1;
        for (int slice = first; slice <= last; ++slice) assign(lamp, s, slice);
    }
}
