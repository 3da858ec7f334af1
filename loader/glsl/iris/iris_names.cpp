#include <orris/glsl/iris/iris_names.h>

#include <algorithm>
#include <array>
#include <span>

namespace orris {
namespace {

// Sets of patches, stages and kinds of GLSL that a row is for.
constexpr unsigned bit(IrisPatch patch) { return 1u << static_cast<unsigned>(patch); }
constexpr unsigned bit(Stage stage) { return 1u << static_cast<unsigned>(stage); }

constexpr unsigned kFull = bit(IrisPatch::Fullscreen), kComp = bit(IrisPatch::Compute),
                   kVan = bit(IrisPatch::Vanilla), kTer = bit(IrisPatch::Terrain),
                   kDh = bit(IrisPatch::DistantHorizons), kWorld = kVan | kTer | kDh;
constexpr unsigned kV = bit(Stage::Vertex), kF = bit(Stage::Fragment), kAll = ~0u,
                   kBetween = kAll & ~kV & ~kF;
constexpr unsigned kOld = 1, kCore = 2, kBoth = 3;

struct Row {
  unsigned patches, kinds, stages;
  IrisName name;
};

constexpr std::string_view kFog =
    "struct iris_FogParameters { vec4 color; float density; float start; float end; float scale; "
    "}; "
    "iris_FogParameters irisInt_Fog;";
constexpr std::string_view kPosition = "in vec3 iris_Position;", kColor = "in vec4 iris_Color;",
                           kUv0 = "in vec2 iris_UV0;", kUv2 = "in ivec2 iris_UV2;",
                           kFloatUv2 = "in vec2 iris_UV2;",
                           kFtransform = "vec4 iris_ftransform() { return vec4(0.0); }",
                           kModelView = "uniform mat4 iris_ModelView;",
                           kProjection = "uniform mat4 iris_Projection;",
                           kNormalMat = "uniform mat3 iris_NormalMat;",
                           kModelViewInverse = "uniform mat4 iris_ModelViewInverse;",
                           kProjectionInverse = "uniform mat4 iris_ProjectionInverse;",
                           kModulator = "uniform vec4 iris_ColorModulator;",
                           kTexture0 = "uniform vec2 iris_TexCoord;",
                           kLight = "uniform vec2 iris_LightCoord;";

// A replacement in parentheses is no variable: the author cannot assign to it, as in Iris.
constexpr Row kRows[] = {
    // CommonTransformer, which core fullscreen and terrain programs do not pass through.
    {kFull | kTer | kDh,
     kOld,
     kV,
     {"gl_FogFragCoord", "iris_FogFragCoord", "out float iris_FogFragCoord;"}},
    {kFull | kTer | kDh,
     kOld,
     kF,
     {"gl_FogFragCoord", "iris_FogFragCoord", "in float iris_FogFragCoord;"}},
    {kVan, kBoth, kV, {"gl_FogFragCoord", "iris_FogFragCoord", "out float iris_FogFragCoord;"}},
    {kVan, kBoth, kF, {"gl_FogFragCoord", "iris_FogFragCoord", "in float iris_FogFragCoord;"}},
    // Declared by the repair of interfaces where the fragment stage reads it.
    {kFull | kTer | kDh, kOld, kBetween, {"gl_FogFragCoord", "iris_FogFragCoord", ""}},
    {kVan, kBoth, kBetween, {"gl_FogFragCoord", "iris_FogFragCoord", ""}},
    {kFull | kTer | kDh, kOld, kV, {"gl_FrontColor", "iris_FrontColor", "vec4 iris_FrontColor;"}},
    {kVan, kBoth, kV, {"gl_FrontColor", "iris_FrontColor", "vec4 iris_FrontColor;"}},
    {kFull | kTer | kDh, kOld, kF, {"gl_TexCoord", "irs_texCoords", "in vec4 irs_texCoords[3];"}},
    {kVan, kBoth, kF, {"gl_TexCoord", "irs_texCoords", "in vec4 irs_texCoords[3];"}},
    {kFull | kTer | kDh, kOld, kF, {"gl_Color", "irs_Color", "in vec4 irs_Color;"}},
    {kVan, kBoth, kF, {"gl_Color", "irs_Color", "in vec4 irs_Color;"}},
    {kFull | kTer | kDh, kOld, kAll, {"gl_Fog", "irisInt_Fog", kFog}},
    {kVan | kComp, kBoth, kAll, {"gl_Fog", "irisInt_Fog", kFog}},

    // Matrices.
    {kFull, kOld, kAll, {"gl_ModelViewMatrix", "mat4(1.0)", ""}},
    {kFull, kOld, kAll, {"gl_ProjectionMatrix", "mat4(2.0)", ""}},
    {kFull, kOld, kAll, {"gl_ModelViewProjectionMatrix", "mat4(2.0)", ""}},
    {kFull, kOld, kAll, {"gl_NormalMatrix", "mat3(1.0)", ""}},
    {kWorld, kOld, kAll, {"gl_ModelViewMatrix", "iris_ModelView", kModelView}},
    {kWorld, kOld, kAll, {"gl_ProjectionMatrix", "iris_Projection", kProjection}},
    {kWorld, kOld, kAll, {"gl_ModelViewProjectionMatrix", "(iris_Projection)", kProjection}},
    {kWorld, kOld, kAll, {"gl_NormalMatrix", "iris_NormalMat", kNormalMat}},
    {kWorld, kOld, kAll, {"gl_ModelViewMatrixInverse", "iris_ModelViewInverse", kModelViewInverse}},
    {kWorld,
     kOld,
     kAll,
     {"gl_ProjectionMatrixInverse", "iris_ProjectionInverse", kProjectionInverse}},
    {kVan, kCore, kAll, {"gl_ModelViewMatrix", "iris_ModelView", kModelView}},
    {kVan, kCore, kAll, {"gl_ProjectionMatrix", "iris_Projection", kProjection}},
    {kVan, kCore, kAll, {"gl_NormalMatrix", "iris_NormalMat", kNormalMat}},
    {kVan | kTer, kCore, kAll, {"modelViewMatrix", "", "uniform mat4 modelViewMatrix;"}},
    {kVan | kTer, kCore, kAll, {"projectionMatrix", "", "uniform mat4 projectionMatrix;"}},
    {kVan, kCore, kAll, {"normalMatrix", "", "uniform mat3 normalMatrix;"}},
    {kVan, kCore, kAll, {"textureMatrix", "", "uniform mat4 textureMatrix;"}},
    {kVan, kCore, kAll, {"chunkOffset", "", "uniform vec3 chunkOffset;"}},
    {kTer, kCore, kV, {"textureMatrix", "", "uniform mat4 textureMatrix;"}},
    {kFull, kCore, kV, {"modelViewMatrix", "", "uniform mat4 modelViewMatrix;"}},
    {kFull, kCore, kV, {"modelViewMatrixInverse", "", "uniform mat4 modelViewMatrixInverse;"}},
    {kFull, kCore, kV, {"projectionMatrix", "", "uniform mat4 projectionMatrix;"}},
    {kFull, kCore, kV, {"projectionMatrixInverse", "", "uniform mat4 projectionMatrixInverse;"}},
    {kFull, kCore, kV, {"textureMatrix", "", "uniform mat4 textureMatrix;"}},

    // Attributes.
    {kFull, kOld, kV, {"gl_Vertex", "vec4(Position, 1.0)", "in vec3 Position;"}},
    {kWorld, kOld, kV, {"gl_Vertex", "vec4(iris_Position, 1.0)", kPosition}},
    {kVan, kCore, kV, {"gl_Vertex", "vec4(iris_Position, 1.0)", kPosition}},
    {kVan | kTer, kCore, kV, {"vaPosition", "", "in vec3 vaPosition;"}},
    {kFull | kWorld, kOld, kV, {"ftransform", "iris_ftransform", kFtransform}},
    {kFull, kOld, kV | kBetween, {"gl_Color", "vec4(1.0)", ""}},
    {kVan, kOld, kV, {"gl_Color", "(iris_Color)", kColor}},
    {kVan, kOld, kBetween, {"gl_Color", "iris_ColorModulator", kModulator}},
    {kVan, kCore, kV, {"gl_Color", "(iris_Color)", kColor}},
    {kTer | kDh, kOld, kV, {"gl_Color", "iris_VertexColor", "vec4 iris_VertexColor;"}},
    {kVan | kTer, kCore, kV, {"vaColor", "", "in vec4 vaColor;"}},
    {kFull, kOld, kV, {"gl_Normal", "vec3(0.0, 0.0, 1.0)", ""}},
    {kVan, kBoth, kV, {"gl_Normal", "iris_Normal", "in vec3 iris_Normal;"}},
    {kTer | kDh, kOld, kV, {"gl_Normal", "iris_VertexNormal", "vec3 iris_VertexNormal;"}},
    {kVan | kTer, kCore, kV, {"vaNormal", "", "in vec3 vaNormal;"}},
    {kTer, kBoth, kV, {"at_tangent", "iris_Tangent", "vec4 iris_Tangent;"}},
    {kFull, kOld, kV, {"gl_MultiTexCoord0", "vec4(UV0, 0.0, 1.0)", "in vec2 UV0;"}},
    {kFull, kOld, kV, {"gl_MultiTexCoord1", "vec4(0.0, 0.0, 0.0, 1.0)", ""}},
    {kFull, kOld, kV, {"gl_MultiTexCoord2", "vec4(0.0, 0.0, 0.0, 1.0)", ""}},
    {kFull, kOld, kV, {"gl_MultiTexCoord3", "vec4(0.0, 0.0, 0.0, 1.0)", ""}},
    {kVan, kOld, kV, {"gl_MultiTexCoord0", "vec4(iris_UV0, 0.0, 1.0)", kUv0}},
    {kVan, kOld, kV, {"gl_MultiTexCoord1", "vec4(iris_UV2, 0.0, 1.0)", kUv2}},
    {kVan, kOld, kV, {"gl_MultiTexCoord2", "vec4(iris_UV2, 0.0, 1.0)", kUv2}},
    {kVan, kCore, kV, {"gl_MultiTexCoord0", "vec4(iris_UV0, 0.0, 1.0)", kUv0}},
    {kVan, kCore, kV, {"gl_MultiTexCoord1", "vec4(iris_UV2, 0.0, 1.0)", kFloatUv2}},
    {kVan, kCore, kV, {"gl_MultiTexCoord2", "vec4(iris_UV2, 0.0, 1.0)", kFloatUv2}},
    {kTer | kDh, kOld, kV, {"gl_MultiTexCoord0", "vec4(iris_TexCoord, 0.0, 1.0)", kTexture0}},
    {kTer | kDh, kOld, kV, {"gl_MultiTexCoord1", "vec4(iris_LightCoord, 0.0, 1.0)", kLight}},
    {kTer | kDh, kOld, kV, {"gl_MultiTexCoord2", "vec4(iris_LightCoord, 0.0, 1.0)", kLight}},
    {kFull, kOld, kV, {"Position", "", "in vec3 Position;", true}},
    {kFull, kOld, kV, {"UV0", "", "in vec2 UV0;", true}},
    {kVan | kTer, kOld, kV, {"gl_MultiTexCoord3", "mc_midTexCoord", "in vec4 mc_midTexCoord;"}},
    {kFull | kWorld, kOld, kV, {"gl_MultiTexCoord4", "vec4(0.0, 0.0, 0.0, 1.0)", ""}},
    {kFull | kWorld, kOld, kV, {"gl_MultiTexCoord5", "vec4(0.0, 0.0, 0.0, 1.0)", ""}},
    {kFull | kWorld, kOld, kV, {"gl_MultiTexCoord6", "vec4(0.0, 0.0, 0.0, 1.0)", ""}},
    {kFull | kWorld, kOld, kV, {"gl_MultiTexCoord7", "vec4(0.0, 0.0, 0.0, 1.0)", ""}},
    {kVan | kTer, kCore, kV, {"vaUV0", "", "in vec2 vaUV0;"}},
    {kVan, kCore, kV, {"vaUV1", "", "in vec2 vaUV1;"}},
    {kVan, kCore, kV, {"vaUV2", "", "in vec2 vaUV2;"}},
    {kTer, kCore, kV, {"vaUV1", "ivec2(0, 10)", ""}},
    {kTer, kCore, kV, {"vaUV2", "iris_LightAndData", "in uvec2 iris_LightAndData;"}},
    {kVan, kBoth, kAll, {"mc_chunkFade", "", "const float mc_chunkFade = -1.0;", true}},
    {kTer, kBoth, kV, {"mc_chunkFade", "", "float mc_chunkFade;", true}},
};

// What Iris brings along of Sodium's own shaders; members of the block are global names.
constexpr std::string_view kGlobals =
    "layout(std140) uniform u_Globals { mat4 u_ProjectionMatrix; mat4 u_ModelViewMatrix; "
    "vec4 u_FogColor; vec2 u_EnvironmentFog; vec2 u_RenderFog; vec2 u_TexelSize; "
    "vec2 u_TexCoordShrink; float u_FadePeriodInv; bool u_UseRGSS; };";
constexpr std::array<IrisName, 10> kTerrainNames{{
    {"u_Globals", "", kGlobals, true},
    {"u_ProjectionMatrix", "", kGlobals, true},
    {"u_ModelViewMatrix", "", kGlobals, true},
    {"u_FogColor", "", kGlobals, true},
    {"u_EnvironmentFog", "", kGlobals, true},
    {"u_RenderFog", "", kGlobals, true},
    {"u_TexelSize", "", kGlobals, true},
    {"u_TexCoordShrink", "", kGlobals, true},
    {"u_FadePeriodInv", "", kGlobals, true},
    {"u_UseRGSS", "", kGlobals, true},
}};
constexpr std::array<IrisName, 26> kTerrainVertexNames{{
    {"u_CurrentTime", "", "uniform int u_CurrentTime;", true},
    {"u_RegionID", "", "uniform uint u_RegionID;", true},
    {"u_SectionTimeInfo", "", "uniform isamplerBuffer u_SectionTimeInfo;", true},
    {"_vert_position", "", "vec3 _vert_position;", true},
    {"_vert_tex_diffuse_coord", "", "vec2 _vert_tex_diffuse_coord;", true},
    {"_vert_tex_diffuse_coord_bias", "", "vec2 _vert_tex_diffuse_coord_bias;", true},
    {"_vert_tex_light_coord", "", "vec2 _vert_tex_light_coord;", true},
    {"_vert_color", "", "vec4 _vert_color;", true},
    {"_draw_id", "", "uint _draw_id;", true},
    {"irs_Normal", "", "vec3 irs_Normal;", true},
    {"irs_Tangent", "", "vec4 irs_Tangent;", true},
    {"POSITION_BITS", "", "const uint POSITION_BITS = 20u;", true},
    {"POSITION_MAX_COORD", "", "const uint POSITION_MAX_COORD = 1048576u;", true},
    {"POSITION_MAX_VALUE", "", "const uint POSITION_MAX_VALUE = 1048575u;", true},
    {"TANGENT_W_BIT", "", "const uint TANGENT_W_BIT = 16u;", true},
    {"TEXTURE_BITS", "", "const uint TEXTURE_BITS = 15u;", true},
    {"TEXTURE_MAX_COORD", "", "const uint TEXTURE_MAX_COORD = 32768u;", true},
    {"TEXTURE_MAX_VALUE", "", "const uint TEXTURE_MAX_VALUE = 32767u;", true},
    {"VERTEX_SCALE", "", "const float VERTEX_SCALE = 0.0;", true},
    {"VERTEX_OFFSET", "", "const float VERTEX_OFFSET = -8.0;", true},
    {"MATERIAL_USE_MIP_OFFSET", "", "const uint MATERIAL_USE_MIP_OFFSET = 0u;", true},
    {"signNotZero", "", "vec2 signNotZero(vec2 v) { return v; }", true},
    {"decodeOct24", "", "vec3 decodeOct24(uint v) { return vec3(0.0); }", true},
    {"decode_diamond", "", "vec2 decode_diamond(float v) { return vec2(0.0); }", true},
    {"onb_from_normal", "", "void onb_from_normal(vec3 n, out vec3 t, out vec3 b) { }", true},
    {"decode_diamond_tangent_with_sign", "",
     "vec4 decode_diamond_tangent_with_sign(vec3 n, int q, bool s) { return vec4(0.0); }", true},
}};

// Vertex stages of Distant Horizons' programs: all of them, those of terrain, dh_generic. Clouds.
constexpr std::array<IrisName, 7> kDistantNames{{
    {"_vert_position", "", "vec3 _vert_position;", true},
    {"_vert_tex_light_coord", "", "vec2 _vert_tex_light_coord;", true},
    {"dhMaterialId", "", "int dhMaterialId;", true},
    {"_vert_color", "", "vec4 _vert_color;", true},
    {"_vert_normal", "", "vec3 _vert_normal;", true},
    {"irisNormals", "",
     "const vec3 irisNormals[6] = vec3[6](vec3(0), vec3(0), vec3(0), vec3(0), vec3(0), vec3(0));",
     true},
    {"getVertexPosition", "", "vec4 getVertexPosition() { return vec4(0.0); }", true},
}};
constexpr std::array<IrisName, 2> kDistantTerrainNames{{
    {"mircoOffset", "", "uniform float mircoOffset;", true},
    {"modelOffset", "", "uniform vec3 modelOffset;", true},
}};
constexpr std::array<IrisName, 6> kDistantGenericNames{{
    {"uOffsetChunk", "", "uniform ivec3 uOffsetChunk;", true},
    {"uOffsetSubChunk", "", "uniform vec3 uOffsetSubChunk;", true},
    {"uCameraPosChunk", "", "uniform ivec3 uCameraPosChunk;", true},
    {"uCameraPosSubChunk", "", "uniform vec3 uCameraPosSubChunk;", true},
    {"uSkyLight", "", "uniform int uSkyLight;", true},
    {"uBlockLight", "", "uniform int uBlockLight;", true},
}};
constexpr std::array<IrisName, 6> kCloudNames{{
    {"FLAG_MASK_DIR", "", "const int FLAG_MASK_DIR = 7;", true},
    {"FLAG_INSIDE_FACE", "", "const int FLAG_INSIDE_FACE = 16;", true},
    {"FLAG_USE_TOP_COLOR", "", "const int FLAG_USE_TOP_COLOR = 32;", true},
    {"FLAG_EXTRA_Z", "", "const int FLAG_EXTRA_Z = 64;", true},
    {"FLAG_EXTRA_X", "", "const int FLAG_EXTRA_X = 128;", true},
    {"CloudFaces", "", "uniform isamplerBuffer CloudFaces;", true},
}};

/// The lists of names that a stage has beside the rows.
std::vector<std::span<const IrisName>> ownNames(const IrisProgram& program, Stage stage,
                                                bool core) {
  std::vector<std::span<const IrisName>> lists;
  const bool vertex = stage == Stage::Vertex;
  if (program.patch == IrisPatch::Terrain) {
    lists.emplace_back(kTerrainNames);
    if (vertex) lists.emplace_back(kTerrainVertexNames);
  }
  if (program.patch == IrisPatch::DistantHorizons && vertex) {
    lists.emplace_back(kDistantNames);
    lists.push_back(program.generic ? std::span<const IrisName>(kDistantGenericNames)
                                    : std::span<const IrisName>(kDistantTerrainNames));
  }
  if (program.clouds && vertex && !core) lists.emplace_back(kCloudNames);
  return lists;
}

// What EntityPatcher makes known in programs whose vertices name an entity.
constexpr std::array<IrisName, 4> kEntityNames{{
    {"entityColor", "", "uniform vec4 entityColor;"},
    {"entityId", "", "uniform int entityId;"},
    {"blockEntityId", "", "uniform int blockEntityId;"},
    {"currentRenderedItemId", "", "uniform int currentRenderedItemId;"},
}};

}  // namespace

std::vector<IrisName> irisNames(const IrisProgram& program, Stage stage, bool core) {
  std::vector<IrisName> names;
  const unsigned kind = core ? kCore : kOld;
  for (const Row& row : kRows) {
    if ((row.patches & bit(program.patch)) && (row.kinds & kind) && (row.stages & bit(stage))) {
      names.push_back(row.name);
    }
  }
  for (const auto list : ownNames(program, stage, core))
    names.insert(names.end(), list.begin(), list.end());
  if (program.entities) names.insert(names.end(), kEntityNames.begin(), kEntityNames.end());
  return names;
}

bool isIrisFunction(const IrisProgram& program, Stage stage, std::string_view name) {
  const auto isFunction = [name](const IrisName& known) {
    return known.name == name && known.declaration.ends_with('}');
  };
  return std::ranges::any_of(ownNames(program, stage, false), [&](std::span<const IrisName> list) {
    return std::ranges::any_of(list, isFunction);
  });
}

bool isTakenByIris(std::string_view name) {
  const auto is = [name](const IrisName& known) { return known.taken && known.name == name; };
  const std::span<const IrisName> lists[] = {kTerrainNames,        kTerrainVertexNames,
                                             kDistantNames,        kDistantTerrainNames,
                                             kDistantGenericNames, kCloudNames};
  return std::ranges::any_of(lists, [&](auto list) { return std::ranges::any_of(list, is); }) ||
         std::ranges::any_of(kRows, [&](const Row& row) { return is(row.name); });
}

std::optional<int> lastTextureMatrix(const IrisProgram& program, bool core) {
  switch (program.patch) {
    case IrisPatch::Fullscreen:
      return core ? std::nullopt : std::optional(7);
    case IrisPatch::Vanilla:
      return core ? 2 : 1;
    case IrisPatch::Terrain:
    case IrisPatch::DistantHorizons:
      return core ? std::nullopt : std::optional(1);
    default:
      return std::nullopt;
  }
}

}  // namespace orris
