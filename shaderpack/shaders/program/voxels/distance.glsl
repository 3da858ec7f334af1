// The distances of include/voxels/distance.glsl from the bits, 32 cells at a time: a cell is within k of a
// block if the block's bit, moved by up to k along each axis, covers it. The distance is the number of
// k, from 0 on, for which none does.
#include "/settings.glsl"

layout(local_size_x = 64) in;
const ivec3 workGroups = ivec3(16, 1, 1);

#define HAS_DISTANCE_WRITES
#include "/include/voxels/distance.glsl"

layout(r32ui) uniform readonly uimage3D voxel_bits;
layout(r32ui) uniform writeonly uimage3D voxel_distance;

/// The bits of a word and those of the words before and after it.
struct Bits {
    uint before;
    uint here;
    uint after;
};

/// Rows beyond the edge repeat the one at the edge, which is nearer.
void add_row(inout Bits bits, ivec3 word) {
    word.yz = clamp(word.yz, ivec2(0), volume_size.yz - 1);
    bits.here |= imageLoad(voxel_bits, word).r;
    if (word.x > 0) bits.before |= imageLoad(voxel_bits, word - ivec3(1, 0, 0)).r;
    if (word.x < words_of_row - 1) bits.after |= imageLoad(voxel_bits, word + ivec3(1, 0, 0)).r;
}

/// Rows at distance k in y or z.
void add_ring(inout Bits bits, ivec3 word, int k) {
    for (int i = -k; i <= k; ++i) {
        add_row(bits, word + ivec3(0, i, -k));
        if (k == 0) return;
        add_row(bits, word + ivec3(0, i, k));
        add_row(bits, word + ivec3(0, -k, i));
        add_row(bits, word + ivec3(0, k, i));
    }
}

/// Moved by up to k along x.
uint covered(Bits bits, int k) {
    uint all = bits.here;
    for (uint i = 1u; i <= uint(k); ++i)
        all |= bits.here << i | bits.here >> i | bits.before >> (32u - i) | bits.after << (32u - i);
    return all;
}

/// Adds a bit to each of 32 numbers, whose binary digits are the planes.
void count(inout uvec4 planes, uint bits) {
    for (int digit = 0; digit < 4; ++digit) {
        uint carry = planes[digit] & bits;
        planes[digit] ^= bits;
        bits = carry;
    }
}

/// Bit i of a byte to bit 4 i.
uint spread(uint byte) {
    byte = (byte | byte << 12) & 0x000F000Fu;
    byte = (byte | byte << 6) & 0x03030303u;
    return (byte | byte << 3) & 0x11111111u;
}

void store_distances(ivec3 word, uvec4 planes) {
    int eights = min(4, VOLUME / 8 - word.x * 4);
    for (int i = 0; i < eights; ++i) {
        uvec4 bytes = planes >> uint(8 * i) & 255u;
        uint eight = spread(bytes.x) | spread(bytes.y) << 1 | spread(bytes.z) << 2 | spread(bytes.w) << 3;
        imageStore(voxel_distance, ivec3(word.x * 4 + i, word.yz), uvec4(eight));
    }
}

void main() {
    int words = distances_are_old() ? words_of_row * VOLUME_HEIGHT * VOLUME : 0;
    int stride = int(gl_NumWorkGroups.x * gl_WorkGroupSize.x);
    for (int i = int(gl_GlobalInvocationID.x); i < words; i += stride) {
        ivec3 word = ivec3(i % words_of_row, i / words_of_row % VOLUME_HEIGHT, i / (words_of_row * VOLUME_HEIGHT));
        Bits bits = Bits(0u, 0u, 0u);
        uvec4 planes = uvec4(0u);
        uint open = ~0u;
        for (int k = 0; k < farthest_reach && open != 0u; ++k) {
            add_ring(bits, word, k);
            open = ~covered(bits, k);
            count(planes, open);
        }
        planes |= imageLoad(voxel_bits, word + ivec3(words_of_row, 0, 0)).r;
        store_distances(word, planes);
    }
}
