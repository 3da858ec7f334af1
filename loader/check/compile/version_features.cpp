#include <orris/check/compile/version_features.h>

#include <algorithm>
#include <iterator>

namespace orris {
namespace {

constexpr std::string_view kGpuShader5 = "GL_ARB_gpu_shader5",
                           kPacking = "GL_ARB_shading_language_packing",
                           k420 = "GL_ARB_shading_language_420pack",
                           kImages = "GL_ARB_shader_image_load_store",
                           kStorage = "GL_ARB_shader_storage_buffer_object",
                           kDerivatives = "GL_ARB_derivative_control",
                           kDoubles = "GL_ARB_gpu_shader_fp64", kVote = "GL_ARB_shader_group_vote";

// The GLSL specifications, and for glslang's wording its source (Versions.cpp, ParseHelper.cpp).
constexpr VersionFeature kFeatures[] = {
    {"fma", 400, kGpuShader5},
    {"textureGather*", 400, "GL_ARB_texture_gather"},
    {"bitfield*", 400, kGpuShader5},
    {"bitCount", 400, kGpuShader5},
    {"findLSB", 400, kGpuShader5},
    {"findMSB", 400, kGpuShader5},
    {"uaddCarry", 400, kGpuShader5},
    {"usubBorrow", 400, kGpuShader5},
    {"umulExtended", 400, kGpuShader5},
    {"imulExtended", 400, kGpuShader5},
    {"ldexp", 400, kGpuShader5},
    {"frexp", 400, kGpuShader5},
    {"interpolateAt*", 400, kGpuShader5},
    {"variable indexing sampler array", 400, kGpuShader5},
    {"precise", 400, kGpuShader5},
    {"invocations", 400, kGpuShader5},
    {"double*", 400, kDoubles},
    {"dvec*", 400, kDoubles},
    {"dmat*", 400, kDoubles},
    {"packDouble2x32", 400, kDoubles},
    {"samplerCubeArray*", 400, "GL_ARB_texture_cube_map_array"},
    {"textureQueryLod", 400, "GL_ARB_texture_query_lod"},
    {"tessellation shaders", 400, "GL_ARB_tessellation_shader"},
    {"location qualifier on uniform*", 430, "GL_ARB_explicit_uniform_location"},
    {"location qualifier on *", 410, "GL_ARB_separate_shader_objects"},
    {"pack*", 420, kPacking},
    {"unpack*", 420, kPacking},
    {"binding", 420, k420},
    {"{ } style initializers", 420, k420},
    {"scalar swizzle", 420, k420},
    {".length() on vectors and matrices", 420, k420},
    {"non-constant initializer", 420, k420},
    {"image load store", 420, kImages},
    {"imageSize", 430, "GL_ARB_shader_image_size"},
    {"imageSamples", 450, ""},
    {"image*", 420, kImages},
    {"iimage*", 420, kImages},
    {"uimage*", 420, kImages},
    {"early_fragment_tests", 420, kImages},
    {"memoryBarrier", 420, kImages},
    {"atomicCounter*", 420, "GL_ARB_shader_atomic_counters"},
    {"std430", 430, kStorage},
    {"atomic*", 430, kStorage},
    {"arrays of arrays", 430, "GL_ARB_arrays_of_arrays"},
    {"textureQueryLevels", 430, "GL_ARB_texture_query_levels"},
    {"shared", 430, "GL_ARB_compute_shader"},
    {"compute shaders", 430, "GL_ARB_compute_shader"},
    {"gl_WorkGroupSize", 430, "GL_ARB_compute_shader"},
    {"offset", 440, "GL_ARB_enhanced_layouts"},
    {"align", 440, "GL_ARB_enhanced_layouts"},
    {"component", 440, "GL_ARB_enhanced_layouts"},
    {"dFdxFine", 450, kDerivatives},
    {"dFdyFine", 450, kDerivatives},
    {"dFdxCoarse", 450, kDerivatives},
    {"dFdyCoarse", 450, kDerivatives},
    {"fwidthFine", 450, kDerivatives},
    {"fwidthCoarse", 450, kDerivatives},
    {"textureSamples", 450, ""},
    {"mix", 450, "GL_EXT_shader_integer_mix"},
    {"anyInvocation", 460, kVote},
    {"allInvocations*", 460, kVote},
    {"subgroup*", 0, "GL_KHR_shader_subgroup_arithmetic or another of its family"},
};

constexpr VersionFeature kKeywords[] = {
    {"buffer", 430, kStorage},
    {"atomic_uint", 420, "GL_ARB_shader_atomic_counters"},
    {"subroutine", 400, "GL_ARB_shader_subroutine"},
    {"sample", 400, kGpuShader5},
    {"patch", 400, "GL_ARB_tessellation_shader"},
};

constexpr RemovedName kRemoved[] = {
    {"gl_ModelViewMatrixInverse", "uniform mat4 gbufferModelViewInverse"},
    {"gl_ProjectionMatrixInverse", "uniform mat4 gbufferProjectionInverse"},
    {"gl_ModelViewProjectionMatrixInverse",
     "gbufferModelViewInverse * gbufferProjectionInverse, both uniform mat4"},
    {"gl_ModelViewProjectionMatrix", "projectionMatrix * modelViewMatrix, both uniform mat4"},
    {"gl_ModelViewMatrixTranspose", "transpose(gl_ModelViewMatrix)"},
    {"gl_ProjectionMatrixTranspose", "transpose(gl_ProjectionMatrix)"},
    {"gl_ModelViewProjectionMatrixTranspose", "transpose(gl_ModelViewProjectionMatrix)"},
    {"gl_ModelViewMatrixInverseTranspose", "transpose(gbufferModelViewInverse)"},
    {"gl_ProjectionMatrixInverseTranspose", "transpose(gbufferProjectionInverse)"},
    {"gl_ModelViewProjectionMatrixInverseTranspose", "transpose() of the inverse uniforms"},
    {"gl_ModelViewMatrix", "uniform mat4 modelViewMatrix or gbufferModelView"},
    {"gl_ProjectionMatrix", "uniform mat4 projectionMatrix or gbufferProjection"},
    {"gl_NormalMatrix", "uniform mat3 normalMatrix"},
    {"gl_NormalScale", "normalize()"},
    {"gl_TextureMatrixInverse*", "inverse(gl_TextureMatrix[0]), in gbuffers"},
    {"gl_TextureMatrixTranspose", "transpose(gl_TextureMatrix[0]), in gbuffers"},
    {"gl_TextureMatrix",
     "an index that is a literal and known: 0 or 1 in gbuffers and shadow, 0 to "
     "7 in fullscreen programs"},
    {"gl_TexCoord",
     "an out variable of your own in the vertex stage, and an in variable of the same "
     "name in the fragment stage"},
    {"gl_MultiTexCoord*", "in vec2 vaUV0 for textures and in ivec2 vaUV2 for the light map"},
    {"gl_Vertex", "in vec3 vaPosition"},
    {"gl_Normal", "in vec3 vaNormal"},
    {"gl_Color",
     "in vec4 vaColor in the vertex stage, and an out variable of your own for what "
     "follows it"},
    {"gl_SecondaryColor", "an out variable of your own"},
    {"gl_FrontColor", "an out variable of your own"},
    {"gl_FrontSecondaryColor", "an out variable of your own"},
    {"gl_BackColor", "an out variable of your own"},
    {"gl_BackSecondaryColor", "an out variable of your own"},
    {"gl_FogCoord", "length() of the position in view space"},
    {"gl_FogFragCoord", "an out variable of your own"},
    {"gl_Fog", "uniform vec3 fogColor, uniform float fogStart, fogEnd and fogDensity"},
    {"gl_ClipVertex", "gl_ClipDistance"},
    {"gl_ClipPlane", "gl_ClipDistance"},
    {"gl_LightSource", "uniform vec3 sunPosition, moonPosition or shadowLightPosition"},
    {"gl_LightModel", "uniforms of your own in shaders.properties"},
    {"gl_Front*Product", "uniforms of your own in shaders.properties"},
    {"gl_FrontMaterial", "the texture in uniform sampler2D specular"},
    {"gl_BackMaterial", "the texture in uniform sampler2D specular"},
    {"gl_FrontLight*", "uniforms of your own in shaders.properties"},
    {"gl_BackLight*", "uniforms of your own in shaders.properties"},
    {"gl_Point", "gl_PointSize in the vertex stage"},
    {"gl_TextureEnvColor", "uniforms of your own in shaders.properties"},
    {"gl_EyePlane*", "uniforms of your own in shaders.properties"},
    {"gl_ObjectPlane*", "uniforms of your own in shaders.properties"},
    {"gl_MaxLights", "a constant of your own"},
    {"gl_MaxClipPlanes", "gl_MaxClipDistances"},
    {"gl_MaxTexture*", "a constant of your own"},
    {"gl_FragColor", "layout(location = 0) out vec4 of your own"},
    {"gl_FragData", "layout(location = N) out vec4 of your own; an index that is a literal"},
    {"ftransform", "projectionMatrix * modelViewMatrix * vec4(vaPosition, 1.0)"},
    {"texture1D*", "the function without 1D: texture(), textureLod() and so on"},
    {"texture2D*", "the function without 2D: texture(), textureLod() and so on"},
    {"texture3D*", "the function without 3D: texture(), textureLod() and so on"},
    {"textureCube*", "the function without Cube: texture(), textureLod() and so on"},
    {"shadow1D*", "texture(), textureLod() and so on, which return a float"},
    {"shadow2D*", "texture(), textureLod() and so on, which return a float"},
    {"texelFetch1D", "texelFetch()"},
    {"texelFetch2D*", "texelFetch()"},
    {"texelFetch3D", "texelFetch()"},
    {"varying", "out in the vertex stage, in in the fragment stage"},
    {"attribute", "in"},
};

/// One '*' stands for any text.
bool matchesPattern(std::string_view pattern, std::string_view text) {
  const std::size_t star = pattern.find('*');
  if (star == std::string_view::npos) return pattern == text;
  const std::string_view rest = pattern.substr(star + 1);
  if (!text.starts_with(pattern.substr(0, star))) return false;
  text.remove_prefix(star);
  const std::size_t next = rest.find('*');
  if (next == std::string_view::npos) return text.ends_with(rest);
  return text.find(rest.substr(0, next)) != std::string_view::npos;
}

}  // namespace

const VersionFeature* findVersionFeature(std::string_view quoted) {
  const auto found = std::find_if(
      std::begin(kFeatures), std::end(kFeatures),
      [quoted](const VersionFeature& feature) { return matchesPattern(feature.quoted, quoted); });
  return found == std::end(kFeatures) ? nullptr : &*found;
}

std::span<const VersionFeature> newKeywords() { return kKeywords; }

const RemovedName* findRemovedName(std::string_view name) {
  const auto found = std::find_if(
      std::begin(kRemoved), std::end(kRemoved),
      [name](const RemovedName& removed) { return matchesPattern(removed.name, name); });
  return found == std::end(kRemoved) ? nullptr : &*found;
}

}  // namespace orris
