// Which cells hold something, and which are filled, a bit each, when that may have changed.
#include "/settings.glsl"

layout(local_size_x = 64) in;
const ivec3 workGroups = ivec3(16, 1, 1);

#define HAS_VOXEL_READS
#define HAS_DISTANCE_WRITES
#include "/include/voxels/voxel.glsl"
#include "/include/voxels/distance.glsl"

layout(r32ui) uniform writeonly uimage3D voxel_bits;

void main() {
    int words = distances_are_old() ? words_of_row * VOLUME_HEIGHT * VOLUME : 0;
    int stride = int(gl_NumWorkGroups.x * gl_WorkGroupSize.x);
    for (int i = int(gl_GlobalInvocationID.x); i < words; i += stride) {
        ivec3 word = ivec3(i % words_of_row, i / words_of_row % VOLUME_HEIGHT, i / (words_of_row * VOLUME_HEIGHT));
        ivec3 first = word * ivec3(32, 1, 1);
        ivec2 texel = atlas_texel(first);
        int cells = min(32, VOLUME - first.x);
        uint bits = 0u;
        uint full = 0u;
        for (int x = 0; x < cells; ++x) {
            int code = int(texelFetch(shadowcolor0, texel + ivec2(x, 0), 0).a * 255.0 + 0.5);
            bits |= uint(code != voxel_air) << uint(x);
            full |= uint(code == voxel_solid || (code >= voxel_lamp && code != voxel_lava)) << uint(x);
        }
        imageStore(voxel_bits, word, uvec4(bits));
        imageStore(voxel_bits, word + ivec3(words_of_row, 0, 0), uvec4(full));
    }
}
