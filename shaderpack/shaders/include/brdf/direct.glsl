// Reflection of one distant light.
#if !defined INCLUDED_BRDF_DIRECT
#define INCLUDED_BRDF_DIRECT

#include "/include/math/sampling.glsl"

// Phong with the published exponent, gated by the cosine and normalised by (n + 2) / (2 pi); the two
// shares sum to one.
const float phong_exponent = 5.0;
const float phong_specular = 0.1;

vec3 reflect_phong(vec3 albedo, vec3 n, vec3 v, vec3 l) {
    float lobe = pow(max(dot(reflect(-l, n), v), 1e-6), phong_exponent);
    return albedo * ((1.0 - phong_specular) / pi) +
           phong_specular * lobe * (phong_exponent + 2.0) / (2.0 * pi);
}

// As published (Pratiwi 2024, README.md): the light's power holds pi, and the lobe has neither the cosine nor a norm, so that
// it reflects more than it receives at grazing angles and shines on faces turned away.
const float published_specular = 0.3;

vec3 reflect_as_published(vec3 albedo, vec3 n, vec3 v, vec3 l) {
    float lobe = pow(max(dot(reflect(-l, n), v), 1e-6), phong_exponent);
    return (albedo * max(dot(n, l), 0.0) + published_specular * lobe) / pi;
}

// GGX with Schlick's Fresnel and the Smith term in the form of Karis 2013 ("Real Shading in Unreal
// Engine 4"): rough dielectric blocks. The diffuse part has what the specular one leaves of the light
// (Kelemen and Szirmay-Kalos 2001), so that white reflects all it receives, at every angle.
const float ggx_alpha = 0.49;
const float ggx_reflectance = 0.04;

/// What the specular part reflects of light with this cosine, within 0.001; for the two values above.
float ggx_share(float cosine) { return 0.0275 + 0.06 * pow(max(1.0 - cosine, 1e-6), 3.5); }
const float ggx_white = 1.0 / (1.0 - 0.0323);  // 0.0323: its mean over the hemisphere

// Both parts have one constant factor, 1 / pi, and all others stand within sums: NVIDIA's compiler (580.159) gives the
// second part the constant factor of the first.
vec3 reflect_ggx(vec3 albedo, vec3 n, vec3 v, vec3 l) {
    vec3 h = normalize(v + l);
    float nl = max(dot(n, l), 1e-4);
    float nv = max(dot(n, v), 1e-4);
    float nh = max(dot(n, h), 0.0);
    float fresnel =
        ggx_reflectance + (1.0 - ggx_reflectance) * pow(1.0 - max(dot(v, h), 0.0), 5.0);
    float d = (ggx_alpha - 1.0 / ggx_alpha) * nh * nh + 1.0 / ggx_alpha;  // of 1 / d^2
    float k = 0.5 * ggx_alpha;
    float smith = 1.0 / ((nl * (1.0 - k) + k) * (nv * (4.0 - 4.0 * k) + 4.0 * k));
    float left = (1.0 - ggx_share(nl)) * (ggx_white - ggx_white * ggx_share(nv));
    return (albedo * left + fresnel * smith / (d * d)) / pi;
}

/// Radiance toward `v` (unit, from the surface) for irradiance 1 on a plane facing the light.
vec3 reflect_direct(vec3 albedo, vec3 n, vec3 v, vec3 l) {
    float cosine = max(dot(n, l), 0.0);
#if DIRECT_LIGHT == DIRECT_LIGHT_LAMBERT_GGX
    return cosine * reflect_ggx(albedo, n, v, l);
#elif DIRECT_LIGHT == DIRECT_LIGHT_PHONG_PUBLISHED
    return reflect_as_published(albedo, n, v, l);
#else
    return cosine * reflect_phong(albedo, n, v, l);
#endif
}

#endif
