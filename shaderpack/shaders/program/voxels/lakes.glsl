// The depths of lakes: water between water has no faces, so the shadow pass draws no voxels of it. Each
// column of cells is filled from a surface of water down to the next block, or to where water shows its bottom.
#include "/settings.glsl"

layout(local_size_x = 64) in;
const ivec3 workGroups = ivec3(16, 1, 1);

#include "/include/voxels/octants.glsl"
#include "/include/voxels/volume.glsl"
#include "/include/voxels/voxel.glsl"

layout(rgba8) uniform image2D shadowcolorimg0;

void fill_column(ivec2 column, int height) {
    vec4 water = vec4(0.0);
    for (int y = height - 1; y >= 0; --y) {
        ivec3 cell = ivec3(column.x, y, column.y);
        ivec2 texel = atlas_texel(cell);
        vec4 voxel = imageLoad(shadowcolorimg0, texel);
        int code = int(voxel.a * 255.0 + 0.5);
        if (code == voxel_water_surface) water = encode_voxel(decode_voxel(voxel).color, voxel_translucent);
        // What stands in the water, as slabs do, is taken for the ground.
        if (code != voxel_water_surface && code != voxel_air && code != voxel_translucent)
            water = vec4(0.0);
        if (code == voxel_air && water.a > 0.0) imageStore(shadowcolorimg0, texel, water);
        if (water.a > 0.0 && (kept_shape(cell) & part_bottom) != 0u) water = vec4(0.0);
    }
}

void main() {
    // No cells where no water is.
    int height = imageLoad(voxel_sums, lake_now).r != 0u ? VOLUME_HEIGHT : 0;
    int stride = int(gl_NumWorkGroups.x * gl_WorkGroupSize.x);
    for (int i = int(gl_GlobalInvocationID.x); i < VOLUME * VOLUME; i += stride)
        fill_column(ivec2(i % VOLUME, i / VOLUME), height);
}
