// Reflection of polished blocks and metals: GGX over a diffuse base.
#if !defined INCLUDED_BRDF_GLOSSY
#define INCLUDED_BRDF_GLOSSY

#include "/include/math/sampling.glsl"

// Classes of block_gloss.
const int gloss_polished = 1;
const int gloss_metal = 2;

// Width of the lobe (roughness squared), and what a smooth coat reflects straight on; what a metal
// reflects is its texture.
const float polished_alpha = 0.06;
const float polished_reflectance = 0.05;
const float metal_alpha = 0.08;

float gloss_alpha(int gloss) { return gloss == gloss_metal ? metal_alpha : polished_alpha; }

/// Fresnel's factor by Schlick 1994; `cosine` between view and mirror's normal.
vec3 gloss_fresnel(int gloss, vec3 albedo, float cosine) {
    vec3 straight = gloss == gloss_metal ? albedo : vec3(polished_reflectance);
    return straight + (1.0 - straight) * pow(clamp(1.0 - cosine, 1e-6, 1.0), 5.0);
}

/// Share of the light that the diffuse base gets; metals have none.
vec3 diffuse_share(int gloss, vec3 albedo, float cosine) {
    return gloss == gloss_metal ? vec3(0.0) : 1.0 - gloss_fresnel(gloss, albedo, cosine);
}

/// What twice the cosine is divided by for Smith's masking (Walter et al. 2007).
float ggx_divisor(float cosine, float alpha) { return cosine + sqrt(mix(cosine * cosine, 1.0, alpha * alpha)); }

/// Smith's masking of one direction; 0 below the surface.
float ggx_masking(float cosine, float alpha) {
    return cosine <= 0.0 ? 0.0 : 2.0 * cosine / ggx_divisor(cosine, alpha);
}

/// A normal of the mirror's facets as the view meets them (Dupuy and Benyoub 2023, "Sampling Visible
/// GGX Normals with Spherical Caps"). A reflection at it weighs Fresnel times the masking of the
/// reflected direction.
vec3 ggx_facet(vec3 n, vec3 v, float alpha, vec2 u) {
    float cosine = dot(n, v);
    vec3 stretched = normalize(alpha * (v - cosine * n) + cosine * n);
    float z = 1.0 - u.x * (1.0 + dot(stretched, n));
    float r = sqrt(max(0.0, 1.0 - z * z));
    float turn = 2.0 * pi * u.y;
    vec3 side = normalize(cross(n, abs(n.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
    vec3 h = stretched + z * n + r * (cos(turn) * side + sin(turn) * cross(n, side));
    float height = dot(h, n);
    return normalize(alpha * (h - height * n) + max(height, 1e-6) * n);
}

/// Radiance toward `v` for irradiance 1 on a plane facing the light `l`. Masking of both directions over four times
/// both cosines is one over both divisors.
vec3 reflect_glossy(int gloss, vec3 albedo, vec3 n, vec3 v, vec3 l) {
    float nl = max(dot(n, l), 0.0);
    float nv = max(dot(n, v), 1e-4);
    vec3 h = normalize(v + l);
    float alpha = gloss_alpha(gloss);
    float d = (dot(n, h) * dot(n, h) * (alpha * alpha - 1.0) + 1.0) / alpha;
    float lobe = 1.0 / (d * d * ggx_divisor(nl, alpha) * ggx_divisor(nv, alpha));
    return (albedo * diffuse_share(gloss, albedo, nv) + lobe * gloss_fresnel(gloss, albedo, dot(v, h))) * (nl / pi);
}

#endif
