// The macros that every pack can rely on. Contract: macros.csv. Iris: StandardMacros, IrisDefines.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include <orris/pack/files/text.h>
#include <orris/pack/shader_pack.h>

namespace orris {
namespace {

struct PrefixMacro {
  std::string_view prefix, macro;
};

constexpr std::string_view kMesaVendor = "MC_GL_VENDOR_MESA";
constexpr std::array<PrefixMacro, 6> kVendors{{{"ati", "MC_GL_VENDOR_ATI"},
                                               {"intel", "MC_GL_VENDOR_INTEL"},
                                               {"nvidia", "MC_GL_VENDOR_NVIDIA"},
                                               {"amd", "MC_GL_VENDOR_AMD"},
                                               {"x.org", "MC_GL_VENDOR_XORG"},
                                               {"mesa", kMesaVendor}}};
constexpr std::array<PrefixMacro, 11> kRenderers{{{"amd", "MC_GL_RENDERER_RADEON"},
                                                  {"ati", "MC_GL_RENDERER_RADEON"},
                                                  {"radeon", "MC_GL_RENDERER_RADEON"},
                                                  {"gallium", "MC_GL_RENDERER_GALLIUM"},
                                                  {"intel", "MC_GL_RENDERER_INTEL"},
                                                  {"geforce", "MC_GL_RENDERER_GEFORCE"},
                                                  {"nvidia", "MC_GL_RENDERER_GEFORCE"},
                                                  {"quadro", "MC_GL_RENDERER_QUADRO"},
                                                  {"nvs", "MC_GL_RENDERER_QUADRO"},
                                                  {"mesa", "MC_GL_RENDERER_MESA"},
                                                  {"apple", "MC_GL_RENDERER_APPLE"}}};

#if defined(_WIN32)
constexpr const char* kSystem = "MC_OS_WINDOWS";
#elif defined(__APPLE__)
constexpr const char* kSystem = "MC_OS_MAC";
#elif defined(__linux__)
constexpr const char* kSystem = "MC_OS_LINUX";
#else
constexpr const char* kSystem = "MC_OS_UNKNOWN";
#endif

// Values are the positions.
constexpr std::array<std::string_view, 24> kRenderStages{"NONE",
                                                         "SKY",
                                                         "SUNSET",
                                                         "CUSTOM_SKY",
                                                         "SUN",
                                                         "MOON",
                                                         "STARS",
                                                         "VOID",
                                                         "TERRAIN_SOLID",
                                                         "TERRAIN_CUTOUT_MIPPED",
                                                         "TERRAIN_CUTOUT",
                                                         "ENTITIES",
                                                         "BLOCK_ENTITIES",
                                                         "DESTROY",
                                                         "OUTLINE",
                                                         "DEBUG",
                                                         "HAND_SOLID",
                                                         "TERRAIN_TRANSLUCENT",
                                                         "TRIPWIRE",
                                                         "PARTICLES",
                                                         "CLOUDS",
                                                         "RAIN_SNOW",
                                                         "WORLD_BORDER",
                                                         "HAND_TRANSLUCENT"};
constexpr std::array<std::string_view, 19> kCategories{
    "NONE",  "TAIGA",    "EXTREME_HILLS", "JUNGLE",   "MESA",       "PLAINS", "SAVANNA",
    "ICY",   "THE_END",  "BEACH",         "FOREST",   "OCEAN",      "DESERT", "RIVER",
    "SWAMP", "MUSHROOM", "NETHER",        "MOUNTAIN", "UNDERGROUND"};
constexpr std::array<std::string_view, 3> kPrecipitations{"NONE", "RAIN", "SNOW"};
constexpr std::array<std::string_view, 16> kDistantBlocks{
    "UNKNOWN", "LEAVES", "STONE",      "WOOD",         "METAL", "DIRT",  "LAVA", "DEEPSLATE",
    "SNOW",    "SAND",   "TERRACOTTA", "NETHER_STONE", "WATER", "GRASS", "AIR",  "ILLUMINATED"};
// In the order of kCategories.
enum Category {
  kNone,
  kTaiga,
  kExtremeHills,
  kJungle,
  kMesa,
  kPlains,
  kSavanna,
  kIcy,
  kTheEnd,
  kBeach,
  kForest,
  kOcean,
  kDesert,
  kRiver,
  kSwamp,
  kMushroom,
  kNether,
  kMountain,
  kUnderground
};

struct Biome {
  std::string_view name;
  Category category;
  Version game{};  ///< the first one that has it
};
// The position is the number: new ones stand at the end.
constexpr std::array<Biome, 65> kBiomes{{{"the_void", kNone},
                                         {"plains", kPlains},
                                         {"sunflower_plains", kPlains},
                                         {"snowy_plains", kIcy},
                                         {"ice_spikes", kIcy},
                                         {"desert", kDesert},
                                         {"swamp", kSwamp},
                                         {"mangrove_swamp", kSwamp, {1, 19, 0}},
                                         {"forest", kForest},
                                         {"flower_forest", kForest},
                                         {"birch_forest", kForest},
                                         {"dark_forest", kForest},
                                         {"old_growth_birch_forest", kForest},
                                         {"old_growth_pine_taiga", kTaiga},
                                         {"old_growth_spruce_taiga", kTaiga},
                                         {"taiga", kTaiga},
                                         {"snowy_taiga", kTaiga},
                                         {"savanna", kSavanna},
                                         {"savanna_plateau", kSavanna},
                                         {"windswept_hills", kExtremeHills},
                                         {"windswept_gravelly_hills", kExtremeHills},
                                         {"windswept_forest", kExtremeHills},
                                         {"windswept_savanna", kSavanna},
                                         {"jungle", kJungle},
                                         {"sparse_jungle", kJungle},
                                         {"bamboo_jungle", kJungle},
                                         {"badlands", kMesa},
                                         {"eroded_badlands", kMesa},
                                         {"wooded_badlands", kMesa},
                                         {"meadow", kMountain, {1, 18, 0}},
                                         {"cherry_grove", kMountain, {1, 20, 0}},
                                         {"grove", kForest, {1, 18, 0}},
                                         {"snowy_slopes", kMountain, {1, 18, 0}},
                                         {"frozen_peaks", kMountain, {1, 18, 0}},
                                         {"jagged_peaks", kMountain, {1, 18, 0}},
                                         {"stony_peaks", kMountain, {1, 18, 0}},
                                         {"river", kRiver},
                                         {"frozen_river", kRiver},
                                         {"beach", kBeach},
                                         {"snowy_beach", kBeach},
                                         {"stony_shore", kBeach},
                                         {"warm_ocean", kOcean},
                                         {"lukewarm_ocean", kOcean},
                                         {"deep_lukewarm_ocean", kOcean},
                                         {"ocean", kOcean},
                                         {"deep_ocean", kOcean},
                                         {"cold_ocean", kOcean},
                                         {"deep_cold_ocean", kOcean},
                                         {"frozen_ocean", kOcean},
                                         {"deep_frozen_ocean", kOcean},
                                         {"mushroom_fields", kMushroom},
                                         {"dripstone_caves", kUnderground, {1, 18, 0}},
                                         {"lush_caves", kUnderground, {1, 18, 0}},
                                         {"deep_dark", kUnderground, {1, 19, 0}},
                                         {"nether_wastes", kNether},
                                         {"warped_forest", kNether},
                                         {"crimson_forest", kNether},
                                         {"soul_sand_valley", kNether},
                                         {"basalt_deltas", kNether},
                                         {"the_end", kTheEnd},
                                         {"end_highlands", kTheEnd},
                                         {"end_midlands", kTheEnd},
                                         {"small_end_islands", kTheEnd},
                                         {"end_barrens", kTheEnd},
                                         {"pale_garden", kForest, {1, 21, 4}}}};

template <size_t Count>
std::string_view byPrefix(std::string_view name, const std::array<PrefixMacro, Count>& table,
                          std::string_view other) {
  const std::string lower = lowerCase(name);
  for (const PrefixMacro& entry : table) {
    if (lower.starts_with(entry.prefix)) return entry.macro;
  }
  return other;
}

// Iris: StandardMacros, which has no macro for Mesa; OptiFine has.
std::string vendorMacro(const HostDescription& host) {
  constexpr std::string_view kOther = "MC_GL_VENDOR_OTHER";
  const std::string_view macro = byPrefix(host.glVendor, kVendors, kOther);
  return std::string(host.iris && macro == kMesaVendor ? kOther : macro);
}

template <size_t Count>
void addNumbered(const char* prefix, const std::array<std::string_view, Count>& names,
                 MacroDefinitions& macros) {
  for (size_t i = 0; i < Count; ++i) {
    macros.emplace_back(prefix + upperCase(names[i]), std::to_string(i));
  }
}

/// Those of Iris's own that the version has.
void addIrisMacros(const HostDescription& host, MacroDefinitions& macros) {
  const Version& iris = host.versions.iris;
  const MacroDefinitions own{{"IRIS_VERSION", std::to_string(versionNumber(iris))},
                             {"IS_IRIS", ""},
                             {"IRIS_REQUIRES_SEPARATE_ENTITY_DRAWS", ""},
                             {"MAX_COLOR_BUFFERS", std::to_string(colorBuffersOf(iris))},
                             {"MC_MIPMAP_LEVEL", "4"},  // the game's default
                             {"IRIS_HAS_TRANSLUCENCY_SORTING", ""},
                             {"IRIS_TAG_SUPPORT", "2"}};
  std::copy_if(own.begin(), own.end(), std::back_inserter(macros),
               [&](const auto& macro) { return offers(iris, Offer::Macro, macro.first); });
  addNumbered("DH_BLOCK_", kDistantBlocks, macros);
}

std::string_view rendererMacro(const HostDescription& host) {
  constexpr std::string_view kOther = "MC_GL_RENDERER_OTHER";
  const std::string_view macro = byPrefix(host.glRenderer, kRenderers, kOther);
  return offers(host.versions.iris, Offer::Macro, macro) ? macro : kOther;
}

}  // namespace

MacroDefinitions standardMacros(const HostDescription& host) {
  MacroDefinitions macros{{"MC_VERSION", std::to_string(versionNumber(host.versions.game))},
                          {"MC_GL_VERSION", std::to_string(host.glVersion)},
                          {"MC_GLSL_VERSION", std::to_string(host.glslVersion)},
                          {host.system.empty() ? kSystem : host.system, ""},
                          {vendorMacro(host), ""},
                          {std::string(rendererMacro(host)), ""},
                          {"MC_NORMAL_MAP", ""},
                          {"MC_SPECULAR_MAP", ""},
                          {"MC_RENDER_QUALITY", "1.0"},
                          {"MC_SHADOW_QUALITY", "1.0"},
                          {"MC_HAND_DEPTH", "0.125"}};
  if (host.iris) addIrisMacros(host, macros);
  for (const std::string& extension : host.glExtensions) macros.emplace_back("MC_" + extension, "");
  if (host.labPbr) {
    macros.emplace_back("MC_TEXTURE_FORMAT_LAB_PBR", "");
    macros.emplace_back("MC_TEXTURE_FORMAT_LAB_PBR_1_3", "");
  }
  addNumbered("MC_RENDER_STAGE_", kRenderStages, macros);
  addNumbered("PPT_", kPrecipitations, macros);
  addNumbered("CAT_", kCategories, macros);
  for (const Biome& biome : kBiomes) {
    if (host.versions.game < biome.game) continue;
    macros.emplace_back("BIOME_" + upperCase(biome.name), std::to_string(biomeId(biome.name)));
  }
  return macros;
}

int biomeId(std::string_view name) {
  constexpr std::string_view kNamespace = "minecraft:";
  if (name.starts_with(kNamespace)) name.remove_prefix(kNamespace.size());
  for (size_t i = 0; i < kBiomes.size(); ++i) {
    if (kBiomes[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

int biomeCategory(std::string_view name) {
  const int id = biomeId(name);
  return id < 0 ? kNone : kBiomes[static_cast<size_t>(id)].category;
}

}  // namespace orris
