// Of the hits of a path one, by chance, gets light of the sun, for all of them: what the sun's light at a hit costs is spent once
// (weighted reservoir sampling, Chao 1982, "A general purpose unequal probability sampling plan").
#if !defined INCLUDED_GI_SUNLIT
#define INCLUDED_GI_SUNLIT

#include "/include/gi/hit.glsl"
#include "/include/math/color.glsl"
#include "/include/math/random.glsl"

struct Sunlit {
    Hit hit;
    vec3 direction;
    vec3 throughput;  // over its weight, with the albedo of the hit
    float sum;        // of the weights of all hits; 0: no hit looks to the sun
};

Sunlit no_sunlit() {
    Sunlit none;
    none.throughput = vec3(0.0);
    none.sum = 0.0;
    return none;
}

/// One more hit. Its weight is what the sun gives there if nothing hides it.
void choose_sunlit(inout Sunlit chosen, Hit hit, vec3 direction, vec3 throughput, vec3 light) {
    float slope = dot(hit.normal, light);
    float weight = luminance(throughput) * (is_thin(hit.voxel.code) ? abs(slope) : max(slope, 0.0));
    chosen.sum += weight;
    if (weight == 0.0 || (chosen.sum > weight && next_random().x * chosen.sum >= weight)) return;
    chosen.hit = hit;
    chosen.direction = direction;
    chosen.throughput = throughput / weight;
}

/// `sky`: level where the path began.
vec3 light_of_sunlit(Sunlit chosen, vec3 light, float sky) {
    return chosen.sum == 0.0 ? vec3(0.0) : chosen.sum * chosen.throughput * sun_at(chosen.hit, chosen.direction, light, sky);
}

#endif
