// The macros that every pack can rely on. Contract: macros.csv. Iris: StandardMacros, IrisDefines.
#include <fmt/format.h>

#include <array>

#include "pack/shader_pack.h"
#include "pack/text.h"

namespace orris {
namespace {

struct PrefixMacro {
  std::string_view prefix, macro;
};

constexpr std::array<PrefixMacro, 6> kVendors{{{"ati", "MC_GL_VENDOR_ATI"},
                                               {"intel", "MC_GL_VENDOR_INTEL"},
                                               {"nvidia", "MC_GL_VENDOR_NVIDIA"},
                                               {"amd", "MC_GL_VENDOR_AMD"},
                                               {"x.org", "MC_GL_VENDOR_XORG"},
                                               {"mesa", "MC_GL_VENDOR_MESA"}}};
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
constexpr const char* kSystem = "MC_OS_OTHER";
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
constexpr std::array<std::string_view, 64> kBiomes{"the_void",
                                                   "plains",
                                                   "sunflower_plains",
                                                   "snowy_plains",
                                                   "ice_spikes",
                                                   "desert",
                                                   "swamp",
                                                   "mangrove_swamp",
                                                   "forest",
                                                   "flower_forest",
                                                   "birch_forest",
                                                   "dark_forest",
                                                   "old_growth_birch_forest",
                                                   "old_growth_pine_taiga",
                                                   "old_growth_spruce_taiga",
                                                   "taiga",
                                                   "snowy_taiga",
                                                   "savanna",
                                                   "savanna_plateau",
                                                   "windswept_hills",
                                                   "windswept_gravelly_hills",
                                                   "windswept_forest",
                                                   "windswept_savanna",
                                                   "jungle",
                                                   "sparse_jungle",
                                                   "bamboo_jungle",
                                                   "badlands",
                                                   "eroded_badlands",
                                                   "wooded_badlands",
                                                   "meadow",
                                                   "cherry_grove",
                                                   "grove",
                                                   "snowy_slopes",
                                                   "frozen_peaks",
                                                   "jagged_peaks",
                                                   "stony_peaks",
                                                   "river",
                                                   "frozen_river",
                                                   "beach",
                                                   "snowy_beach",
                                                   "stony_shore",
                                                   "warm_ocean",
                                                   "lukewarm_ocean",
                                                   "deep_lukewarm_ocean",
                                                   "ocean",
                                                   "deep_ocean",
                                                   "cold_ocean",
                                                   "deep_cold_ocean",
                                                   "frozen_ocean",
                                                   "deep_frozen_ocean",
                                                   "mushroom_fields",
                                                   "dripstone_caves",
                                                   "lush_caves",
                                                   "deep_dark",
                                                   "nether_wastes",
                                                   "warped_forest",
                                                   "crimson_forest",
                                                   "soul_sand_valley",
                                                   "basalt_deltas",
                                                   "the_end",
                                                   "end_highlands",
                                                   "end_midlands",
                                                   "small_end_islands",
                                                   "end_barrens"};

template <size_t Count>
std::string_view byPrefix(std::string_view name, const std::array<PrefixMacro, Count>& table,
                          std::string_view other) {
  const std::string lower = lowerCase(name);
  for (const PrefixMacro& entry : table) {
    if (lower.starts_with(entry.prefix)) return entry.macro;
  }
  return other;
}

template <size_t Count>
void addNumbered(const char* prefix, const std::array<std::string_view, Count>& names,
                 MacroDefinitions& macros) {
  for (size_t i = 0; i < Count; ++i) {
    macros.emplace_back(prefix + upperCase(names[i]), std::to_string(i));
  }
}

}  // namespace

MacroDefinitions standardMacros(const HostDescription& host) {
  MacroDefinitions macros{
      {"MC_VERSION", std::to_string(host.minecraftVersion)},
      {"IRIS_VERSION", std::to_string(host.irisVersion)},
      {"IS_IRIS", ""},
      {"MC_GL_VERSION", std::to_string(host.glVersion)},
      {"MC_GLSL_VERSION", std::to_string(host.glslVersion)},
      {host.system.empty() ? kSystem : host.system, ""},
      {std::string(byPrefix(host.glVendor, kVendors, "MC_GL_VENDOR_OTHER")), ""},
      {std::string(byPrefix(host.glRenderer, kRenderers, "MC_GL_RENDERER_OTHER")), ""},
      {"MC_NORMAL_MAP", ""},
      {"MC_SPECULAR_MAP", ""},
      {"MC_RENDER_QUALITY", "1.0"},
      {"MC_SHADOW_QUALITY", "1.0"},
      {"MC_HAND_DEPTH", "0.125"},
      {"MAX_COLOR_BUFFERS", std::to_string(kColorTargets)},
      {"IRIS_HAS_TRANSLUCENCY_SORTING", ""},
      {"IRIS_TAG_SUPPORT", "2"}};
  for (const std::string& extension : host.glExtensions) macros.emplace_back("MC_" + extension, "");
  if (host.labPbr) {
    macros.emplace_back("MC_TEXTURE_FORMAT_LAB_PBR", "");
    macros.emplace_back("MC_TEXTURE_FORMAT_LAB_PBR_1_3", "");
  }
  addNumbered("MC_RENDER_STAGE_", kRenderStages, macros);
  addNumbered("PPT_", kPrecipitations, macros);
  addNumbered("CAT_", kCategories, macros);
  addNumbered("DH_BLOCK_", kDistantBlocks, macros);
  addNumbered("BIOME_", kBiomes, macros);
  return macros;
}

int biomeId(std::string_view name) {
  constexpr std::string_view kNamespace = "minecraft:";
  if (name.starts_with(kNamespace)) name.remove_prefix(kNamespace.size());
  for (size_t i = 0; i < kBiomes.size(); ++i) {
    if (kBiomes[i] == name) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace orris
