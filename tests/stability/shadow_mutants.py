"""Mistakes put into shadow maps and reflection, and the tests that must find them.

For kill_list.py --table; rows as in mutants.py.
"""

MAP = "include/shadow/shadow.glsl"
SPACE = "include/shadow/shadow_space.glsl"
HIT = "include/gi/hit.glsl"
SUNLIT = "include/gi/sunlit.glsl"
SHADOW = "program/shadow/shadow.glsl"
VISIBILITY = "include/sun/sun_visibility.glsl"
DIRECT = "include/brdf/direct.glsl"
LIT = "program/lighting.glsl"
TRANSLUCENT = "program/gbuffers/translucent.glsl"

MUTANTS = [
    ("C1 filter wider than its bias", "ShadowBias.least*",
     [(MAP, "y <= radius; ++y)\n        for (int x = -radius; x <= radius; ++x)\n",
                                               "y <= radius + 1; ++y)\n        for (int x = -radius; x <= radius + 1; ++x)\n")]),
    ("C2 constant bias", "PublishedShadowBias.shows*", [(MAP, "max(0.05 * (1.0 - cosine), 0.005)", "0.0005")]),
    ("C3 published bias in blocks", "PublishedShadowBias.detaches*:PublishedShadowBias.leaves*",
     [(MAP, "max(0.05 * (1.0 - cosine), 0.005)",
       "max(0.05 * (1.0 - cosine), 0.005) * depth_per_block")]),
    ("C3 half of the normal offset", "ShadowBias.normal*", [(MAP, "(float(radius) + shadow_tap) * 1.4143 *", "(float(radius) + shadow_tap) * 0.5 *")]),
    ("C3 a block of bias", "ShadowBias.normal*",
     [(MAP, "float bias = 0.01 * depth_per_block;", "float bias = 2.0 * depth_per_block;")]),
    ("C3 a block of bias on a world", "DefaultShadowBias.*",
     [(MAP, "float bias = 0.01 * depth_per_block;", "float bias = 2.0 * depth_per_block;")]),
    ("offset of points that rays hit", "ShadowOfPoints.*long*",
     [(MAP, "bool aslant = across.z < 0.8 * texel;", "bool aslant = true;")]),
    ("slope of points that rays hit not followed", "ShadowOfPoints.*acne*", [(MAP, "plane.view.z - dot(off, plane.slope)", "plane.view.z")]),
    ("planes go on into the open beyond a wall", "ShadowOfPointsIndoors.*",
     [(MAP, "across.z < 0.8 * texel", "across.z < 0.1 * texel")]),
    ("edges of what rays hit by texels", "ShadowOfHits.*", [(HIT, "bool is_exact = edge.found", "bool is_exact = false && edge.found")]),
    ("edges beside what throws the shadow", "ShadowOfHits.*", [(MAP, "0.25 * (dark.xy - ", "0.0 * (dark.xy - ")]),
    ("edges let all light pass", "ShadowOfHits.*", [(HIT, "bool passes = !is_stopped(from, light, is_exact, boxes);", "bool passes = true;")]),
    ("sun on the first hit of a path alone", "SunOfPaths.*", [(SUNLIT, "chosen.sum > weight && next_random().x * chosen.sum >= weight", "chosen.sum > weight")]),
    ("sun on the last hit of a path alone", "SunOfPaths.*", [(SUNLIT, "chosen.sum > weight && next_random().x * chosen.sum >= weight", "false")]),
    ("hits chosen evenly", "SunOfPaths.*", [(SUNLIT, "next_random().x * chosen.sum >= weight", "next_random().x < 0.5")]),
    ("sun on a hit that looks away from it", "SunOfPaths.*", [(SUNLIT, "max(slope, 0.0))", "abs(slope))")]),
    ("C4 normal of the camera's space", "ShadowMapStability.shadows*",
     [(MAP, "clamp(dot(normal, light), 0.0, 1.0)",
       "clamp(dot(mat3(gbufferModelView) * normal, light), 0.0, 1.0)")]),
    ("C5 border of the map goes on outside", "ShadowMapRange.what*",
     [(MAP, "return outside ? unmapped_visibility(sky) : lit / taps;", "return lit / taps;")]),
    ("C5 casters before the near plane vanish", "ShadowMapRange.casters*",
     [(SPACE, "max(clip.z, -1.0)", "clip.z")]),
    ("C6 taps half a texel apart", "ShadowFilter.nine*",
     [(MAP, "vec2(x, y), receiver.z", "0.5 * vec2(x, y), receiver.z")]),
    ("C6 hardware reads the middle of a texel", "ShadowFilter.one*",
     [(MAP, "vec2 uv = (position + ", "vec2 uv = (floor(position) + 0.5 + ")]),
    ("C7 no snap", "ShadowMapStability.texels*", [(SPACE, "return -fract(", "return -0.0 * fract(")]),
    ("C7 no distortion", "ShadowMapStability.a_distorted*",
     [(SPACE, "return clip / (SHADOW_DISTORTION * length(clip) + (1.0 - SHADOW_DISTORTION));",
       "return clip;")]),
    ("E2 lobe without cosine", "Reflection.white*",
     [(DIRECT, "return cosine * reflect_phong(", "return reflect_phong(")]),
    ("E2 Lambert below the specular part", "Reflection.white*",
     [(DIRECT, "(1.0 - ggx_share(nl)) * (ggx_white - ggx_white * ggx_share(nv))", "1.0")]),
    ("E2 published lobe with a cosine", "Reflection.published*",
     [(DIRECT, "published_specular * lobe)", "published_specular * lobe * max(dot(n, l), 0.0))")]),
    ("E3 lit from behind", "Reflection.no*", [(DIRECT, "float cosine = max(dot(n, l), 0.0);",
                                      "float cosine = abs(dot(n, l));")]),
    ("E3 albedo twice", "Reflection.reflected*",
     [(DIRECT, "return albedo * ((1.0 - phong_specular) / pi)",
       "return albedo * albedo * ((1.0 - phong_specular) / pi)")]),
    ("published: shadow factor left out", "Listing.sun*",
     [(LIT, "light_irradiance() * sun_visibility(pixel, s.player, n, l, s.light.y);", "light_irradiance();")]),
    ("published: shadow factor left out of glass", "Listing.sun*",
     [(TRANSLUCENT, "light_irradiance() * light_visibility(player, n, l, shadow_radius, light.y);",
       "light_irradiance();")]),
    ("published: albedo twice in ambient light", "Listing.every*",
     [(LIT, "radiance += diffuse * indirect_radiance", "radiance += diffuse * diffuse * indirect_radiance")]),
    ("published: albedo twice in ambient light on glass", "Listing.every*",
     [(TRANSLUCENT, "level * level + indirect_radiance(n));",
       "level * level + albedo * indirect_radiance(n));")]),
    ("published: albedo twice in lamplight", "Listing.every*",
     [(LIT, "float(s.thin), diffuse);", "float(s.thin), diffuse * diffuse);")]),
    ("no holes in the map", "Pillars/SunShadow.*0", [(SHADOW, "!is_voxel && textureLod(gtexture, place, 0.0).a", "!is_voxel && 1.0")]),
    ("holes by mean alpha", "Pillars/SunShadow.*0",
     [(SHADOW, "!is_voxel && textureLod(gtexture, place, 0.0).a", "!is_voxel && textureLod(gtexture, place, 4.0).a")]),
    ("one volume does not shade", "Pillars/SunShadow.*1",
     [(VISIBILITY, "float(texelFetch(stenciltex0, pixel, 0).r == 0u)", "float(texelFetch(stenciltex0, pixel, 0).r <= 1u)")]),
    ("published: albedo twice in lamplight on glass", "Listing.every*",
     [(TRANSLUCENT, "lamps_radiance(player, n, 0.0, albedo);", "lamps_radiance(player, n, 0.0, albedo * albedo);")]),
]
