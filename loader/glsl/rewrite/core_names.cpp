#include <orris/glsl/rewrite/core_names.h>

#include <algorithm>

namespace orris {
namespace {

enum class CoreStages { Vertex, Fragment, All };

struct CoreRow {
  CoreStages stages;
  CoreName name;
};

constexpr std::string_view kNoVector = "vec4(0.0, 0.0, 0.0, 1.0)";
constexpr std::string_view kInPosition = "in vec4 iris_Position;";
constexpr std::string_view kInUv2 = "in vec4 iris_UV2;";
constexpr std::string_view kUniformView = "uniform mat4 iris_ModelView;",
                           kUniformProjection = "uniform mat4 iris_Projection;",
                           kUniformViewProjection = "uniform mat4 iris_ModelViewProjection;",
                           kUniformViewInverse = "uniform mat4 iris_ModelViewInverse;",
                           kUniformProjectionInverse = "uniform mat4 iris_ProjectionInverse;",
                           kUniformViewProjectionInverse =
                               "uniform mat4 iris_ModelViewProjectionInverse;",
                           kUniformLightMatrix = "uniform mat4 iris_LightTextureMatrix;";
constexpr std::string_view kTransform =
    "vec4 iris_ftransform() { return iris_ModelViewProjection * iris_Position; }";
constexpr std::string_view kTextureMatrices =
    "mat4 iris_TextureMatrix[8] = mat4[8](mat4(1.0), iris_LightTextureMatrix, "
    "iris_LightTextureMatrix, mat4(1.0), mat4(1.0), mat4(1.0), mat4(1.0), mat4(1.0));";
constexpr std::string_view kFogUniforms =
    "uniform vec4 iris_FogColor; uniform float iris_FogDensity; uniform float iris_FogStart; "
    "uniform float iris_FogEnd;";
constexpr std::string_view kFogStruct =
    "struct iris_FogParameters { vec4 color; float density, start, end, scale; }; "
    "iris_FogParameters iris_Fog = iris_FogParameters(iris_FogColor, iris_FogDensity, "
    "iris_FogStart, iris_FogEnd, 1.0 / (iris_FogEnd - iris_FogStart));";
constexpr std::string_view kFragData = "layout(location = 0) out vec4 iris_FragData[8];";

struct Varying {
  std::string_view input, output;
};
constexpr Varying kVaryings[] = {
    {"in vec4 iris_FrontColor;", "out vec4 iris_FrontColor;"},
    {"in vec4 iris_FrontSecondaryColor;", "out vec4 iris_FrontSecondaryColor;"},
    {"in vec4 iris_TexCoords[8];", "out vec4 iris_TexCoords[8];"},
    {"in float iris_FogFragCoord;", "out float iris_FogFragCoord;"},
};
constexpr Varying kColorVarying = kVaryings[0], kSecondVarying = kVaryings[1],
                  kCoordVarying = kVaryings[2], kFogVarying = kVaryings[3];

constexpr CoreRow kCoreRows[] = {
    // Attributes. Of those that the host does not set, a compatibility context has constants.
    {CoreStages::Vertex, {"gl_Vertex", "iris_Position", {kInPosition}}},
    {CoreStages::Vertex, {"gl_Normal", "iris_Normal", {"in vec3 iris_Normal;"}}},
    {CoreStages::Vertex, {"gl_Color", "iris_Color", {"in vec4 iris_Color;"}}},
    {CoreStages::Vertex, {"gl_SecondaryColor", kNoVector}},
    {CoreStages::Vertex, {"gl_FogCoord", "0.0"}},
    {CoreStages::Vertex, {"gl_MultiTexCoord0", "iris_UV0", {"in vec4 iris_UV0;"}}},
    {CoreStages::Vertex, {"gl_MultiTexCoord1", "iris_UV2", {kInUv2}}},
    {CoreStages::Vertex, {"gl_MultiTexCoord2", "iris_UV2", {kInUv2}}},
    {CoreStages::Vertex, {"gl_MultiTexCoord3", "iris_MidTexCoord", {"in vec4 iris_MidTexCoord;"}}},
    {CoreStages::Vertex, {"gl_MultiTexCoord4", kNoVector}},
    {CoreStages::Vertex, {"gl_MultiTexCoord5", kNoVector}},
    {CoreStages::Vertex, {"gl_MultiTexCoord6", kNoVector}},
    {CoreStages::Vertex, {"gl_MultiTexCoord7", kNoVector}},
    {CoreStages::Vertex,
     {"ftransform", "iris_ftransform", {kInPosition, kUniformViewProjection, kTransform}}},
    // Between vertex and fragment.
    {CoreStages::Vertex, {"gl_FrontColor", "iris_FrontColor", {kColorVarying.output}}},
    {CoreStages::Vertex,
     {"gl_FrontSecondaryColor", "iris_FrontSecondaryColor", {kSecondVarying.output}}},
    {CoreStages::Vertex, {"gl_BackColor", "iris_BackColor", {"vec4 iris_BackColor;"}}},
    {CoreStages::Vertex,
     {"gl_BackSecondaryColor", "iris_BackSecondaryColor", {"vec4 iris_BackSecondaryColor;"}}},
    {CoreStages::Vertex, {"gl_TexCoord", "iris_TexCoords", {kCoordVarying.output}}},
    {CoreStages::Vertex, {"gl_FogFragCoord", "iris_FogFragCoord", {kFogVarying.output}}},
    {CoreStages::Vertex, {"gl_ClipVertex", "iris_ClipVertex", {"vec4 iris_ClipVertex;"}}},
    {CoreStages::Fragment, {"gl_Color", "iris_FrontColor", {kColorVarying.input}}},
    {CoreStages::Fragment,
     {"gl_SecondaryColor", "iris_FrontSecondaryColor", {kSecondVarying.input}}},
    {CoreStages::Fragment, {"gl_TexCoord", "iris_TexCoords", {kCoordVarying.input}}},
    {CoreStages::Fragment, {"gl_FogFragCoord", "iris_FogFragCoord", {kFogVarying.input}}},
    {CoreStages::Fragment, {"gl_FragData", "iris_FragData", {kFragData}}},
    {CoreStages::Fragment,
     {"gl_FragColor", "iris_FragColor", {kFragData, "vec4 iris_FragColor;"}}},
    // Uniforms.
    {CoreStages::All, {"gl_ModelViewMatrix", "iris_ModelView", {kUniformView}}},
    {CoreStages::All, {"gl_ProjectionMatrix", "iris_Projection", {kUniformProjection}}},
    {CoreStages::All,
     {"gl_ModelViewProjectionMatrix", "iris_ModelViewProjection", {kUniformViewProjection}}},
    {CoreStages::All,
     {"gl_NormalMatrix", "iris_NormalMat", {"uniform mat3 iris_NormalMat;"}}},
    {CoreStages::All, {"gl_NormalScale", "1.0"}},
    {CoreStages::All, {"gl_ModelViewMatrixInverse", "iris_ModelViewInverse", {kUniformViewInverse}}},
    {CoreStages::All,
     {"gl_ProjectionMatrixInverse", "iris_ProjectionInverse", {kUniformProjectionInverse}}},
    {CoreStages::All,
     {"gl_ModelViewProjectionMatrixInverse",
      "iris_ModelViewProjectionInverse",
      {kUniformViewProjectionInverse}}},
    {CoreStages::All, {"gl_ModelViewMatrixTranspose", "transpose(iris_ModelView)", {kUniformView}}},
    {CoreStages::All,
     {"gl_ProjectionMatrixTranspose", "transpose(iris_Projection)", {kUniformProjection}}},
    {CoreStages::All,
     {"gl_ModelViewProjectionMatrixTranspose",
      "transpose(iris_ModelViewProjection)",
      {kUniformViewProjection}}},
    {CoreStages::All,
     {"gl_ModelViewMatrixInverseTranspose",
      "transpose(iris_ModelViewInverse)",
      {kUniformViewInverse}}},
    {CoreStages::All,
     {"gl_ProjectionMatrixInverseTranspose",
      "transpose(iris_ProjectionInverse)",
      {kUniformProjectionInverse}}},
    {CoreStages::All,
     {"gl_ModelViewProjectionMatrixInverseTranspose",
      "transpose(iris_ModelViewProjectionInverse)",
      {kUniformViewProjectionInverse}}},
    {CoreStages::All,
     {"gl_TextureMatrix", "iris_TextureMatrix", {kUniformLightMatrix, kTextureMatrices}}},
    {CoreStages::All, {"gl_Fog", "iris_Fog", {kFogUniforms, kFogStruct}}},
    {CoreStages::All, {"gl_MaxTextureCoords", "8"}},
    {CoreStages::All, {"gl_MaxTextureUnits", "8"}},
};

bool holds(CoreStages stages, Stage stage) {
  return stages == CoreStages::All || (stages == CoreStages::Vertex && stage == Stage::Vertex) ||
         (stages == CoreStages::Fragment && stage == Stage::Fragment);
}

}  // namespace

const CoreName* findCoreName(Stage stage, std::string_view name) {
  if (!name.starts_with("gl_") && name != "ftransform") return nullptr;
  const auto* found = std::find_if(
      std::begin(kCoreRows), std::end(kCoreRows),
      [&](const CoreRow& row) { return row.name.name == name && holds(row.stages, stage); });
  return found == std::end(kCoreRows) ? nullptr : &found->name;
}

std::string_view outputForInput(std::string_view declaration) {
  const auto* found =
      std::find_if(std::begin(kVaryings), std::end(kVaryings),
                   [&](const Varying& varying) { return varying.input == declaration; });
  return found == std::end(kVaryings) ? std::string_view() : found->output;
}

}  // namespace orris
