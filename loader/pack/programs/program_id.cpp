#include <orris/pack/programs/program_id.h>

#include <algorithm>
#include <array>

#include <orris/core/files/pack_path.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

struct NumberedGroup {
  std::string_view prefix;
  ProgramGroup group;
};
constexpr std::array<NumberedGroup, 6> kNumbered{{{"setup", ProgramGroup::Setup},
                                                  {"begin", ProgramGroup::Begin},
                                                  {"shadowcomp", ProgramGroup::ShadowComp},
                                                  {"prepare", ProgramGroup::Prepare},
                                                  {"deferred", ProgramGroup::Deferred},
                                                  {"composite", ProgramGroup::Composite}}};

std::optional<Stage> stageOf(std::string_view extension) {
  for (const Stage stage : {Stage::Vertex, Stage::TessControl, Stage::TessEvaluation,
                            Stage::Geometry, Stage::Fragment, Stage::Compute}) {
    if (extension == stageExtension(stage)) return stage;
  }
  return std::nullopt;
}

/// "" is 0, "1" to "99" themselves; "0", "01" and "100" are no index.
std::optional<int> indexOf(std::string_view digits) {
  if (digits.empty()) return 0;
  const auto value = parseInteger(digits);
  if (!value || *value < 1 || *value > 99 || digits.front() < '1' || digits.front() > '9') {
    return std::nullopt;
  }
  return static_cast<int>(*value);
}

/// Sets program, group and index of `file`; false for an unknown name.
bool recognise(std::string_view name, ProgramFile& file) {
  file.program = name;
  for (const NumberedGroup& numbered : kNumbered) {
    if (!name.starts_with(numbered.prefix)) continue;
    if (const auto index = indexOf(name.substr(numbered.prefix.size()))) {
      file.group = numbered.group;
      file.index = *index;
      return true;
    }
  }
  if (name == "final") {
    file.group = ProgramGroup::Final;
    return true;
  }
  const auto& all = geometryPrograms();
  const auto found = std::find_if(all.begin(), all.end(), [&](auto& p) { return p.name == name; });
  if (found != all.end()) file.group = found->group;
  return found != all.end();
}

/// Compute shaders belong to fullscreen passes, setup and the shadow pass.
bool takesCompute(const ProgramFile& file) {
  return file.group != ProgramGroup::Gbuffers && file.group != ProgramGroup::ShadowVolume &&
         file.group < ProgramGroup::DistantHorizons &&
         (file.group != ProgramGroup::Shadow || file.program == "shadow");
}

}  // namespace

std::optional<ProgramFile> parseProgramFile(std::string_view path) {
  const size_t slash = path.rfind('/');
  std::string_view name = slash == std::string_view::npos ? path : path.substr(slash + 1);
  const size_t dot = name.find('.');
  const auto stage = dot == std::string_view::npos ? std::nullopt : stageOf(name.substr(dot + 1));
  if (!stage) return std::nullopt;
  name = name.substr(0, dot);

  ProgramFile file;
  file.folder = packPathParent(path);
  file.stage = *stage;
  if (*stage == Stage::Compute && name.size() > 2 && name[name.size() - 2] == '_' &&
      name.back() >= 'a' && name.back() <= 'z') {
    file.computeSuffix = name.back();
    name.remove_suffix(2);
  }
  if (!recognise(name, file)) return std::nullopt;
  const bool compute = *stage == Stage::Compute;
  // Iris: ProgramSet, which asks for no letters after the programs of setup.
  if (file.group == ProgramGroup::Setup && file.computeSuffix) return std::nullopt;
  if (compute ? !takesCompute(file) : file.group == ProgramGroup::Setup) return std::nullopt;
  return file;
}

bool isFullscreen(ProgramGroup group) {
  switch (group) {
    case ProgramGroup::Begin:
    case ProgramGroup::ShadowComp:
    case ProgramGroup::Prepare:
    case ProgramGroup::Deferred:
    case ProgramGroup::Composite:
    case ProgramGroup::Final:
      return true;
    default:
      return false;
  }
}

IrisProgram irisProgramOf(const ProgramFile& program) {
  // Those that Sodium draws, and those whose vertices have the format of entities.
  constexpr std::string_view kTerrain[] = {
      "gbuffers_terrain", "gbuffers_terrain_solid", "gbuffers_terrain_cutout", "gbuffers_water",
      "shadow",           "shadow_solid",           "shadow_cutout",           "shadow_water"};
  constexpr std::string_view kEntities[] = {"gbuffers_entities",
                                            "gbuffers_entities_translucent",
                                            "gbuffers_entities_glowing",
                                            "gbuffers_block",
                                            "gbuffers_block_translucent",
                                            "gbuffers_hand",
                                            "gbuffers_hand_water",
                                            "gbuffers_spidereyes",
                                            "gbuffers_item",
                                            "shadow_entities",
                                            "shadow_block"};
  const auto isOneOf = [&program](const auto& names) {
    return std::find(std::begin(names), std::end(names), program.program) != std::end(names);
  };
  if (isFullscreen(program.group)) return {.patch = IrisPatch::Fullscreen};
  if (program.group == ProgramGroup::DistantHorizons)
    return {.patch = IrisPatch::DistantHorizons, .generic = program.program == "dh_generic"};
  if (program.group != ProgramGroup::Gbuffers && program.group != ProgramGroup::Shadow) return {};
  if (isOneOf(kTerrain)) return {.patch = IrisPatch::Terrain};
  return {.patch = IrisPatch::Vanilla,
          .entities = isOneOf(kEntities),
          .lines = program.program == "gbuffers_line",
          .clouds = program.program == "gbuffers_clouds"};
}

std::string_view fallbackOf(std::string_view program) {
  for (const GeometryProgram& known : geometryPrograms()) {
    if (known.name == program) return known.fallback;
  }
  return "";
}

// Iris: ProgramId (order of declaration is the scan order of directives).
const std::vector<GeometryProgram>& geometryPrograms() {
  using enum ProgramGroup;
  static const std::vector<GeometryProgram> kPrograms{
      {"shadow", "", Shadow},
      {"shadow_solid", "shadow", Shadow},
      {"shadow_cutout", "shadow", Shadow},
      {"shadow_water", "shadow", Shadow},
      {"shadow_entities", "shadow", Shadow},
      {"shadow_lightning", "shadow_entities", Shadow},
      {"shadow_block", "shadow", Shadow},
      {"gbuffers_basic", "", Gbuffers},
      {"gbuffers_line", "gbuffers_basic", Gbuffers},
      {"gbuffers_textured", "gbuffers_basic", Gbuffers},
      {"gbuffers_textured_lit", "gbuffers_textured", Gbuffers},
      {"gbuffers_skybasic", "gbuffers_basic", Gbuffers},
      {"gbuffers_skytextured", "gbuffers_textured", Gbuffers},
      {"gbuffers_clouds", "gbuffers_textured", Gbuffers},
      {"gbuffers_terrain", "gbuffers_textured_lit", Gbuffers},
      {"gbuffers_terrain_solid", "gbuffers_terrain", Gbuffers},
      {"gbuffers_terrain_cutout", "gbuffers_terrain", Gbuffers},
      {"gbuffers_damagedblock", "gbuffers_terrain", Gbuffers},
      {"gbuffers_block", "gbuffers_terrain", Gbuffers},
      {"gbuffers_block_translucent", "gbuffers_block", Gbuffers},
      {"gbuffers_beaconbeam", "gbuffers_textured", Gbuffers},
      {"gbuffers_item", "gbuffers_textured_lit", Gbuffers},
      {"gbuffers_entities", "gbuffers_textured_lit", Gbuffers},
      {"gbuffers_entities_translucent", "gbuffers_entities", Gbuffers},
      {"gbuffers_lightning", "gbuffers_entities", Gbuffers},
      {"gbuffers_particles", "gbuffers_textured_lit", Gbuffers},
      {"gbuffers_particles_translucent", "gbuffers_particles", Gbuffers},
      {"gbuffers_entities_glowing", "gbuffers_entities", Gbuffers},
      {"gbuffers_armor_glint", "gbuffers_textured", Gbuffers},
      {"gbuffers_spidereyes", "gbuffers_textured", Gbuffers},
      {"gbuffers_hand", "gbuffers_textured_lit", Gbuffers},
      {"gbuffers_weather", "gbuffers_textured_lit", Gbuffers},
      {"gbuffers_water", "gbuffers_terrain", Gbuffers},
      {"gbuffers_hand_water", "gbuffers_hand", Gbuffers},
      {"shadowvolume", "", ShadowVolume},
      {"dh_terrain", "", DistantHorizons},
      {"dh_water", "dh_terrain", DistantHorizons},
      {"dh_generic", "dh_terrain", DistantHorizons},
      {"dh_shadow", "", DistantHorizons},
      {"clrwl_gbuffers", "", Colorwheel},
      {"clrwl_gbuffers_additive", "clrwl_gbuffers", Colorwheel},
      {"clrwl_gbuffers_lightning", "clrwl_gbuffers", Colorwheel},
      {"clrwl_gbuffers_glint", "clrwl_gbuffers", Colorwheel},
      {"clrwl_gbuffers_translucent", "clrwl_gbuffers", Colorwheel},
      {"clrwl_gbuffers_damagedblock", "clrwl_gbuffers", Colorwheel},
      {"clrwl_shadow", "", Colorwheel},
      {"clrwl_shadow_additive", "clrwl_shadow", Colorwheel},
      {"clrwl_shadow_lightning", "clrwl_shadow", Colorwheel},
      {"clrwl_shadow_glint", "clrwl_shadow", Colorwheel},
      {"clrwl_shadow_translucent", "clrwl_shadow", Colorwheel},
  };
  return kPrograms;
}

std::string textureStageOf(ProgramGroup group) {
  switch (group) {
    case ProgramGroup::Setup:
      return "setup";
    case ProgramGroup::Begin:
      return "begin";
    case ProgramGroup::ShadowComp:
      return "shadowcomp";
    case ProgramGroup::Prepare:
      return "prepare";
    case ProgramGroup::Deferred:
      return "deferred";
    case ProgramGroup::Composite:
    case ProgramGroup::Final:
      return "composite";
    default:
      return "gbuffers";
  }
}

}  // namespace orris
