#include <orris/plan/frame/uniforms.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <glm/gtc/type_ptr.hpp>
#include <utility>
#include <vector>

#include <orris/pack/expressions/expression_functions.h>
#include <orris/plan/frame/clouds.h>
#include <orris/plan/frame/fog.h>
#include <orris/pack/shader_pack.h>
#include <orris/world/dimension_look.h>

namespace orris {
namespace {

template <class V>
Value packFloats(ValueType type, const V& v, int count) {
  Value value;
  value.type = type;
  std::memcpy(value.f.data(), glm::value_ptr(v), sizeof(float) * count);
  return value;
}

Value ivec4Value(const glm::ivec4& v) {
  Value value;
  value.type = ValueType::IVec3;
  for (int i = 0; i < 4; ++i) value.i[i] = v[i];
  return value;
}

glm::ivec3 floorOf(const glm::dvec3& p) { return glm::ivec3(glm::floor(p)); }
glm::vec3 fractOf(const glm::dvec3& p) { return glm::vec3(p - glm::floor(p)); }

// x and z are shifted by whole multiples of 30000 so that floats stay exact; both positions by the
// shift of the current one, so that their difference stays the true motion. Iris: CameraUniforms.
glm::vec3 shifted(const FrameState& s, const glm::dvec3& p) {
  glm::dvec3 shift(0);
  for (int axis : {0, 2})
    if (std::abs(s.cameraPosition[axis]) > 30000)
      shift[axis] = 30000 * std::trunc(s.cameraPosition[axis] / 30000);
  return glm::vec3(p - shift);
}

glm::vec3 lookVector(const FrameState& s) {
  return -glm::vec3(glm::transpose(s.gbufferModelView)[2]);
}

bool isNether(const FrameState& s) { return s.environment.dimension == "minecraft:the_nether"; }
bool isEnd(const FrameState& s) { return s.environment.dimension == "minecraft:the_end"; }

// Every biome of these dimensions has their category, named or not.
int categoryOf(const FrameState& s) {
  const std::string_view named = s.environment.biome;
  const std::string_view biome = isNether(s) ? "nether_wastes" : isEnd(s) ? "the_end" : named;
  return biomeCategory(biome);
}

// GL_LINEAR and GL_EXP2, as uniform fogMode gives them.
constexpr int kLinearFog = 9729, kExp2Fog = 2049;

glm::vec3 statedVector(const FrameState& s, std::string_view name) {
  const std::array<float, 3> value = valueIn(s.environment.stated, *findStated(name));
  return {value[0], value[1], value[2]};
}

Value statedValue(const FrameState& s, const StatedUniform& uniform) {
  const glm::vec3 value = statedVector(s, uniform.name);
  switch (uniform.type) {
    case StatedType::Bool:
      return Value::ofBool(value.x != 0);
    case StatedType::Int:
      return Value::ofInt(int(value.x));
    case StatedType::Float:
      return valueOf(value.x);
    case StatedType::IVec3:
      return valueOf(glm::ivec3(value));
    case StatedType::Vec3:
      break;
  }
  return valueOf(value);
}

constexpr ValueType typeOf(StatedType type) {
  constexpr ValueType kTypes[] = {ValueType::Bool, ValueType::Int, ValueType::Float, ValueType::IVec3,
                                  ValueType::Vec3};
  return kTypes[std::size_t(type)];
}

/// Seconds since the year began, and until it ends.
glm::ivec2 yearTimeOf(const FrameState& s) {
  using std::chrono::January, std::chrono::sys_days;
  const glm::ivec3 date(statedVector(s, "currentDate")), time(statedVector(s, "currentTime"));
  const std::chrono::year year(date.x);
  const sys_days begin = year / January / 1, end = (year + std::chrono::years(1)) / January / 1;
  const auto stated = year / std::chrono::month(unsigned(date.y)) / std::chrono::day(unsigned(date.z));
  const sys_days day = stated.ok() ? sys_days(stated) : begin;
  const auto seconds = [](auto days) { return int(std::chrono::seconds(days).count()); };
  const int since = seconds(day - begin) + (time.x * 60 + time.y) * 60 + time.z;
  return {since, seconds(end - begin) - since};
}

using S = const FrameState&;
using D = const DrawState&;
#define FRAME(name, type, expr)                         \
  {                                                     \
    name, ValueType::type, false, [](S s, D) -> Value { \
      (void)s;                                          \
      return expr;                                      \
    }                                                   \
  }
#define DRAW(name, type, expr)                           \
  {                                                      \
    name, ValueType::type, true, [](S s, D d) -> Value { \
      (void)s;                                           \
      (void)d;                                           \
      return expr;                                       \
    }                                                    \
  }

template <std::size_t... kIndex>
void addVolumeLights(std::vector<UniformRow>& rows, std::index_sequence<kIndex...>) {
  static constexpr std::string_view kNames[] = {
      "shadowVolumeLight0", "shadowVolumeLight1", "shadowVolumeLight2", "shadowVolumeLight3",
      "shadowVolumeLight4", "shadowVolumeLight5", "shadowVolumeLight6", "shadowVolumeLight7"};
  (rows.push_back({kNames[kIndex], ValueType::Vec4, false,
                   [](S s, D) { return valueOf(s.volumeLights[kIndex]); }}),
   ...);
}

template <std::size_t... kIndex>
void addStated(std::vector<UniformRow>& rows, std::index_sequence<kIndex...>) {
  (rows.push_back({kStatedUniforms[kIndex].name, typeOf(kStatedUniforms[kIndex].type), false,
                   [](S s, D) { return statedValue(s, kStatedUniforms[kIndex]); }}),
   ...);
}

// clang-format off
std::vector<UniformRow> makeTable() {
  std::vector<UniformRow> rows = {
    // Matrices
    FRAME("gbufferModelView", Mat4, valueOf(s.gbufferModelView)),
    FRAME("gbufferModelViewInverse", Mat4, valueOf(s.gbufferModelViewInverse)),
    FRAME("gbufferProjection", Mat4, valueOf(s.gbufferProjection)),
    FRAME("gbufferProjectionInverse", Mat4, valueOf(s.gbufferProjectionInverse)),
    FRAME("gbufferPreviousModelView", Mat4, valueOf(s.gbufferPreviousModelView)),
    FRAME("gbufferPreviousProjection", Mat4, valueOf(s.gbufferPreviousProjection)),
    FRAME("shadowModelView", Mat4, valueOf(s.shadowModelView)),
    FRAME("shadowModelViewInverse", Mat4, valueOf(s.shadowModelViewInverse)),
    FRAME("shadowProjection", Mat4, valueOf(s.shadowProjection)),
    FRAME("shadowProjectionInverse", Mat4, valueOf(s.shadowProjectionInverse)),
    FRAME("dhProjection", Mat4, valueOf(s.gbufferProjection)),
    FRAME("dhProjectionInverse", Mat4, valueOf(s.gbufferProjectionInverse)),
    FRAME("dhPreviousProjection", Mat4, valueOf(s.gbufferPreviousProjection)),
    FRAME("dhModelView", Mat4, valueOf(s.gbufferModelView)),
    FRAME("dhModelViewInverse", Mat4, valueOf(s.gbufferModelViewInverse)),
    DRAW("modelViewMatrix", Mat4, valueOf(d.modelView)),
    DRAW("modelViewMatrixInverse", Mat4, valueOf(glm::inverse(d.modelView))),
    DRAW("projectionMatrix", Mat4, valueOf(d.projection)),
    // The fullscreen projection has a zero row and no inverse; its useful part has one.
    DRAW("projectionMatrixInverse", Mat4, valueOf(d.fullscreen ? glm::mat4(1) : glm::inverse(d.projection))),
    DRAW("normalMatrix", Mat3, valueOf(glm::transpose(glm::inverse(glm::mat3(d.modelView))))),
    DRAW("textureMatrix", Mat4, valueOf(d.textureMatrix)),
    // Camera
    FRAME("cameraPosition", Vec3, valueOf(shifted(s, s.cameraPosition))),
    FRAME("previousCameraPosition", Vec3, valueOf(shifted(s, s.previousCameraPosition))),
    FRAME("cameraPositionInt", IVec3, valueOf(floorOf(s.cameraPosition))),
    FRAME("cameraPositionFract", Vec3, valueOf(fractOf(s.cameraPosition))),
    FRAME("previousCameraPositionInt", IVec3, valueOf(floorOf(s.previousCameraPosition))),
    FRAME("previousCameraPositionFract", Vec3, valueOf(fractOf(s.previousCameraPosition))),
    FRAME("eyeAltitude", Float, valueOf(static_cast<float>(s.cameraPosition.y))),
    FRAME("eyePosition", Vec3, valueOf(glm::vec3(s.cameraPosition - glm::dvec3(statedVector(s, "relativeEyePosition"))))),
    FRAME("playerLookVector", Vec3, valueOf(lookVector(s))),
    FRAME("playerBodyVector", Vec3, valueOf(lookVector(s))),
    FRAME("upPosition", Vec3, valueOf(s.upPosition)),
    FRAME("eyeBrightness", IVec2, valueOf(s.eyeBrightness)),
    FRAME("eyeBrightnessSmooth", IVec2, valueOf(glm::ivec2(s.eyeBrightnessSmooth))),
    FRAME("centerDepthSmooth", Float, valueOf(s.centerDepthSmooth)),
    // Screen and time
    FRAME("viewWidth", Float, valueOf(static_cast<float>(s.width))),
    FRAME("viewHeight", Float, valueOf(static_cast<float>(s.height))),
    FRAME("aspectRatio", Float, valueOf(static_cast<float>(s.width) / static_cast<float>(s.height))),
    FRAME("screenBrightness", Float, valueOf(s.environment.player.brightness)),
    FRAME("frameCounter", Int, Value::ofInt(s.frameCounter)),
    FRAME("frameTime", Float, valueOf(s.frameTime)),
    FRAME("frameTimeCounter", Float, valueOf(s.frameTimeCounter)),
    FRAME("currentYearTime", IVec2, valueOf(yearTimeOf(s))),
    // World
    FRAME("sunPosition", Vec3, valueOf(s.sunPosition)),
    FRAME("moonPosition", Vec3, valueOf(s.moonPosition)),
    FRAME("shadowLightPosition", Vec3, valueOf(s.shadowLightPosition)),
    FRAME("sunAngle", Float, valueOf(s.sunAngle)),
    FRAME("shadowAngle", Float, valueOf(s.shadowAngle)),
    FRAME("moonPhase", Int, Value::ofInt(s.environment.day % 8)),
    FRAME("worldTime", Int, Value::ofInt(s.environment.time)),
    FRAME("worldDay", Int, Value::ofInt(s.environment.day)),
    FRAME("rainStrength", Float, valueOf(s.environment.rain)),
    FRAME("wetness", Float, valueOf(s.wetness)),
    FRAME("thunderStrength", Float, valueOf(s.environment.thunder)),
    FRAME("lightningBoltPosition", Vec4, valueOf(s.lightningBolt)),
    FRAME("endFlashPosition", Vec3, valueOf(s.endFlashPosition)),
    FRAME("endFlashIntensity", Float, valueOf(s.endFlashIntensity)),
    FRAME("previousEndFlashIntensity", Float, valueOf(s.previousEndFlashIntensity)),
    // Biome and dimension
    FRAME("biome", Int, Value::ofInt(biomeId(s.environment.biome))),
    FRAME("biome_category", Int, Value::ofInt(categoryOf(s))),
    FRAME("biome_precipitation", Int, Value::ofInt(s.environment.temperature < 0.15f ? 2 : s.environment.rainfall > 0 ? 1 : 0)),
    FRAME("rainfall", Float, valueOf(s.environment.rainfall)),
    FRAME("temperature", Float, valueOf(s.environment.temperature)),
    FRAME("ambientLight", Float, valueOf(ambientLightOf(s.environment.dimension))),
    FRAME("bedrockLevel", Int, Value::ofInt(isNether(s) || isEnd(s) ? 0 : -64)),
    FRAME("cloudHeight", Float, valueOf(192.0f)),
    FRAME("hasCeiling", Bool, Value::ofBool(isNether(s))),
    FRAME("hasSkylight", Bool, Value::ofBool(hasSkylight(s.environment.dimension))),
    FRAME("heightLimit", Int, Value::ofInt(384)),
    FRAME("logicalHeightLimit", Int, Value::ofInt(384)),
    FRAME("seaLevel", Int, Value::ofInt(isNether(s) ? 32 : isEnd(s) ? 0 : 63)),
    // Rendering
    FRAME("near", Float, valueOf(0.05f)),
    FRAME("far", Float, valueOf(static_cast<float>(s.environment.renderDistance))),
    FRAME("skyColor", Vec3, valueOf(s.environment.skyColor)),
    DRAW("fogColor", Vec3, valueOf(s.environment.fogColor)),
    DRAW("fogStart", Float, valueOf(fogRangeOf(s, d.renderStage).start)),
    DRAW("fogEnd", Float, valueOf(fogRangeOf(s, d.renderStage).end)),
    DRAW("fogDensity", Float, valueOf(fogDensityOf(s))),
    DRAW("fogMode", Int, Value::ofInt(d.fullscreen ? 0 : fogDensityOf(s) > 0 ? kExp2Fog : kLinearFog)),
    DRAW("fogShape", Int, Value::ofInt(d.fullscreen ? -1 : fogShapeOf(s))),
    DRAW("alphaTestRef", Float, valueOf(d.alphaTestRef)),
    DRAW("chunkOffset", Vec3, valueOf(d.chunkOffset)),
    DRAW("entityColor", Vec4, valueOf(d.entityColor)),
    DRAW("blendFunc", IVec3, ivec4Value(d.blendFunc)),
    DRAW("atlasSize", IVec2, valueOf(d.atlasSize)),
    DRAW("gtextureSize", IVec2, valueOf(d.gtextureSize)),
    DRAW("gtextureId", Int, Value::ofInt(d.gtextureId)),
    DRAW("textureReloadCount", Int, Value::ofInt(0)),  // the atlas is made once
    DRAW("renderStage", Int, Value::ofInt(d.renderStage)),
    // Player
    FRAME("isEyeInWater", Int, Value::ofInt(s.isEyeInWater)),
    FRAME("feetInWater", Bool, Value::ofBool(s.feetInWater)),
    FRAME("blindness", Float, valueOf(s.environment.player.blindness)),
    FRAME("nightVision", Float, valueOf(s.environment.player.nightVision)),
    FRAME("darknessFactor", Float, valueOf(s.environment.player.darkness)),
    FRAME("darknessLightFactor", Float, valueOf(s.environment.player.darknessLight)),
    FRAME("hideGUI", Bool, Value::ofBool(s.environment.player.hideGui)),
    FRAME("maxPlayerArmor", Float, valueOf(50.0f)),
    FRAME("maxPlayerHunger", Float, valueOf(20.0f)),
    FRAME("is_on_ground", Bool, Value::ofBool(s.environment.player.onGround)),
    FRAME("is_alive", Bool, Value::ofBool(true)),
    FRAME("is_sneaking", Bool, Value::ofBool(s.environment.player.sneaking)),
    FRAME("is_sprinting", Bool, Value::ofBool(s.environment.player.sprinting)),
    FRAME("is_hurt", Bool, Value::ofBool(s.environment.player.hurt)),
    FRAME("is_invisible", Bool, Value::ofBool(s.environment.player.invisible)),
    FRAME("is_burning", Bool, Value::ofBool(s.environment.player.burning)),
    // Ids
    FRAME("heldItemId", Int, Value::ofInt(s.heldItemId)),
    FRAME("heldItemId2", Int, Value::ofInt(s.heldItemId2)),
    FRAME("heldBlockLightValue", Int, Value::ofInt(s.environment.player.heldLight)),
    FRAME("heldBlockLightValue2", Int, Value::ofInt(s.environment.player.heldLight2)),
    DRAW("entityId", Int, Value::ofInt(d.entityId)),
    DRAW("blockEntityId", Int, Value::ofInt(d.blockEntityId)),
    DRAW("currentRenderedItemId", Int, Value::ofInt(d.itemId)),
    FRAME("currentSelectedBlockId", Int, Value::ofInt(s.selectedBlockId)),
    FRAME("currentSelectedBlockPos", Vec3, valueOf(s.selectedBlockPos)),
    FRAME("pi", Float, valueOf(3.14159265f)),
    FRAME("cloudTime", Float, valueOf(cloudTimeOf(s))),
    FRAME("dhNearPlane", Float, valueOf(0.05f)),
    FRAME("dhFarPlane", Float, valueOf(static_cast<float>(s.environment.renderDistance) * 4)),
    FRAME("dhRenderDistance", Int, Value::ofInt(s.environment.renderDistance)),
    FRAME("terrainTextureSize", IVec2, valueOf(glm::ivec2(0))),
    FRAME("terrainIconSize", Int, Value::ofInt(0)),
    // OptiFine only
    FRAME("colorModulator", Vec4, valueOf(glm::vec4(1))),
    FRAME("bossBattle", Int, Value::ofInt(0)),
    FRAME("instanceId", Int, Value::ofInt(0)),
    FRAME("spriteBounds", Vec4, valueOf(glm::vec4(0))),
    FRAME("modelOffset", Vec3, valueOf(glm::vec3(0))),
    // Vivecraft
    FRAME("vivecraftRenderpass", Int, Value::ofInt(0)),
    FRAME("vivecraftRelativeMainHandPos", Vec3, valueOf(glm::vec3(0))),
    FRAME("vivecraftRelativeOffHandPos", Vec3, valueOf(glm::vec3(0))),
    FRAME("vivecraftRelativeMainHandRot", Mat4, valueOf(glm::mat4(1))),
    FRAME("vivecraftRelativeOffHandRot", Mat4, valueOf(glm::mat4(1))),
  };
  addVolumeLights(rows, std::make_index_sequence<kMostVolumeLights>());
  addStated(rows, std::make_index_sequence<kStatedUniforms.size()>());
  for (const char* name : {"is_child", "is_glowing", "is_in_lava", "is_in_water",
                           "is_ridden", "is_riding", "is_wet", "vivecraftIsVR"})
    rows.push_back(FRAME(name, Bool, Value::ofBool(false)));
  std::sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return rows;
}
// clang-format on

#undef FRAME
#undef DRAW

}  // namespace

Value valueOf(float v) { return Value::ofFloat(v); }
Value valueOf(const glm::vec2& v) { return packFloats(ValueType::Vec2, v, 2); }
Value valueOf(const glm::vec3& v) { return packFloats(ValueType::Vec3, v, 3); }
Value valueOf(const glm::vec4& v) { return packFloats(ValueType::Vec4, v, 4); }
Value valueOf(const glm::mat3& m) { return packFloats(ValueType::Mat3, m, 9); }
Value valueOf(const glm::mat4& m) { return packFloats(ValueType::Mat4, m, 16); }

Value valueOf(const glm::ivec2& v) {
  Value value;
  value.type = ValueType::IVec2;
  value.i = {v.x, v.y, 0, 0};
  return value;
}

Value valueOf(const glm::ivec3& v) {
  Value value;
  value.type = ValueType::IVec3;
  value.i = {v.x, v.y, v.z, 0};
  return value;
}

std::span<const UniformRow> uniformTable() {
  static const std::vector<UniformRow> table = makeTable();
  return table;
}

std::optional<ValueType> expressionInput(const std::string& name) {
  const UniformRow* row = findUniform(name);
  if (row == nullptr || row->perDraw) return std::nullopt;
  return row->type;
}

const UniformRow* findUniform(std::string_view name) {
  const auto table = uniformTable();
  const auto it =
      std::lower_bound(table.begin(), table.end(), name,
                       [](const UniformRow& r, std::string_view n) { return r.name < n; });
  return it != table.end() && it->name == name ? &*it : nullptr;
}

std::map<std::string, std::string> uniformTypes() {
  // Voxy's own. Its matrices have three forms each.
  std::map<std::string, std::string> types{{"vxRenderDistance", "int"}, {"blendFunc", "ivec4"}};
  for (const char* matrix : {"vxProj", "vxModelView", "vxViewProj"}) {
    for (const char* form : {"", "Inv", "Prev"}) types[std::string(matrix) + form] = "mat4";
  }
  for (const UniformRow& row : uniformTable())
    types.emplace(row.name, row.type == ValueType::Bool ? "int" : typeName(row.type));
  return types;
}

}  // namespace orris
