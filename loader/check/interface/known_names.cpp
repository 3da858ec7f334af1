#include <orris/check/interface/known_names.h>

#include <algorithm>
#include <array>
#include <map>

#include <orris/plan/frame/uniforms.h>
#include <orris/plan/scene/gpu_vertex.h>

namespace orris {
namespace {

using NameTable = std::map<std::string_view, KnownName>;

// What this host does not set: of OptiFine only, of the packs that Iris once knew by name, of
// Vivecraft. Their values stay 0, as they do in Iris.
constexpr KnownName kOtherUniforms[] = {
    {"bossBattle", "int"},       {"instanceId", "int"},        {"spriteBounds", "vec4"},
    {"modelOffset", "vec3"},     {"timeAngle", "float"},       {"timeBrightness", "float"},
    {"moonBrightness", "float"}, {"shadowFade", "float"},      {"rainStrengthS", "float"},
    {"blindFactor", "float"},    {"isEyeInCave", "float"},     {"velocity", "float"},
    {"starter", "float"},        {"frameTimeSmooth", "float"}, {"eyeBrightnessM", "float"},
    {"inSwamp", "float"},        {"BiomeTemp", "float"},       {"day", "float"},
    {"night", "float"},          {"dawnDusk", "float"},        {"shdFade", "float"},
    {"blendFunc", "ivec4"},
};
constexpr std::string_view kSamplers[] = {"gtexture", "texture",  "tex",     "lightmap",
                                          "normals",  "specular", "noisetex"};
constexpr std::string_view kOtherAttributes[] = {"at_velocity", "dhMaterialId"};
// Colorwheel, Distant Horizons, Iris itself, Vivecraft, Voxy.
constexpr std::string_view kModPrefixes[] = {"clrwl_", "dh", "iris_", "vivecraft", "vx"};

// Numbered names up to the last one that any version of Iris has.
struct Numbered {
  NameKind kind;
  std::string_view prefix;
  int count;
};
constexpr Numbered kNumbered[] = {
    {NameKind::Sampler, "colortex", 32}, {NameKind::Sampler, "shadowcolor", 8},
    {NameKind::Sampler, "depthtex", 3},  {NameKind::Sampler, "shadowtex", 2},
    {NameKind::Sampler, "stenciltex", 2},
    {NameKind::Image, "colorimg", 32},   {NameKind::Image, "shadowcolorimg", 8},
};
constexpr std::string_view kBufferAliases[] = {
    "gcolor",      "gdepth", "gnormal",     "composite",    "gdepthtex",
    "watershadow", "shadow", "shadowcolor", "shadowtex0HW", "shadowtex1HW",
    "gaux1",       "gaux2",  "gaux3",       "gaux4"};

NameTable makeTable(NameKind kind) {
  NameTable table;
  const auto add = [&](std::string_view name, std::string_view type) {
    table[name] = {name, type};
  };
  switch (kind) {
    case NameKind::Uniform:
      for (const UniformRow& row : uniformTable()) add(row.name, uniformTypeName(row.type));
      for (const KnownName& other : kOtherUniforms) add(other.name, other.type);
      break;
    case NameKind::Sampler:
      for (const std::string_view name : kSamplers) add(name, "");
      for (const std::string_view name : kBufferAliases) add(name, "");
      break;
    case NameKind::Image:
      break;
    case NameKind::Attribute:
      for (const std::string_view name : attributeNames()) add(name, "");
      for (const std::string_view name : kOtherAttributes) add(name, "");
      break;
  }
  return table;
}

const NameTable& tableOf(NameKind kind) {
  static const std::array<NameTable, 4> kTables = {
      makeTable(NameKind::Uniform), makeTable(NameKind::Sampler), makeTable(NameKind::Image),
      makeTable(NameKind::Attribute)};
  return kTables[static_cast<std::size_t>(kind)];
}

std::vector<std::string> namesOf(NameKind kind) {
  std::vector<std::string> names;
  for (const auto& [name, known] : tableOf(kind)) names.emplace_back(name);
  for (const Numbered& numbered : kNumbered) {
    if (numbered.kind != kind) continue;
    for (int i = 0; i < numbered.count; ++i) {
      names.push_back(std::string(numbered.prefix) + std::to_string(i));
    }
  }
  return names;
}

bool isNumbered(NameKind kind, std::string_view name) {
  return std::any_of(std::begin(kNumbered), std::end(kNumbered), [&](const Numbered& numbered) {
    if (numbered.kind != kind || !name.starts_with(numbered.prefix)) return false;
    const std::string_view digits = name.substr(numbered.prefix.size());
    if (digits.empty() || digits.size() > 2 || (digits.size() == 2 && digits[0] == '0'))
      return false;
    int value = 0;
    for (const char c : digits) {
      if (c < '0' || c > '9') return false;
      value = value * 10 + (c - '0');
    }
    return value < numbered.count;
  });
}

}  // namespace

std::string_view uniformTypeName(ValueType type) {
  constexpr std::array<std::string_view, 10> kNames = {"bool", "int",   "float", "vec2", "vec3",
                                                       "vec4", "ivec2", "ivec3", "mat3", "mat4"};
  return kNames[static_cast<std::size_t>(type)];
}

const char* nameKindWord(NameKind kind) {
  constexpr const char* kWords[] = {"uniform", "sampler", "image", "attribute"};
  return kWords[static_cast<std::size_t>(kind)];
}

const KnownName* findKnownName(NameKind kind, std::string_view name) {
  static constexpr KnownName kAnyType;
  const NameTable& table = tableOf(kind);
  const auto found = table.find(name);
  if (found != table.end()) return &found->second;
  const bool ofMod = std::any_of(std::begin(kModPrefixes), std::end(kModPrefixes),
                                 [&](std::string_view prefix) { return name.starts_with(prefix); });
  return ofMod || isNumbered(kind, name) ? &kAnyType : nullptr;
}

const std::vector<std::string>& knownNames(NameKind kind) {
  static const std::array<std::vector<std::string>, 4> kNames = {
      namesOf(NameKind::Uniform), namesOf(NameKind::Sampler), namesOf(NameKind::Image),
      namesOf(NameKind::Attribute)};
  return kNames[static_cast<std::size_t>(kind)];
}

}  // namespace orris
