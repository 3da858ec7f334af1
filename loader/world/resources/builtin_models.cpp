#include <orris/world/resources/builtin_models.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace orris {
namespace {

constexpr std::array<std::string_view, 6> kSides = {"down", "up", "north", "south", "west", "east"};

// The game's poses of these.
constexpr const char* kGenerated = R"({"parent": "builtin/generated", "display": {
  "firstperson_righthand": {"rotation": [0, -90, 25], "translation": [1.13, 3.2, 1.13], "scale": [0.68, 0.68, 0.68]},
  "thirdperson_righthand": {"translation": [0, 3, 1], "scale": [0.55, 0.55, 0.55]},
  "ground": {"translation": [0, 2, 0], "scale": [0.5, 0.5, 0.5]},
  "fixed": {"rotation": [0, 180, 0]}}})";
constexpr const char* kHandheld = R"({"parent": "item/generated", "display": {
  "firstperson_righthand": {"rotation": [0, -90, 25], "translation": [1.13, 3.2, 1.13], "scale": [0.68, 0.68, 0.68]},
  "firstperson_lefthand": {"rotation": [0, 90, -25], "translation": [1.13, 3.2, 1.13], "scale": [0.68, 0.68, 0.68]},
  "thirdperson_righthand": {"rotation": [0, -90, 55], "translation": [0, 4, 0.5], "scale": [0.85, 0.85, 0.85]},
  "thirdperson_lefthand": {"rotation": [0, 90, -55], "translation": [0, 4, 0.5], "scale": [0.85, 0.85, 0.85]}}})";
constexpr const char* kBlock = R"({"display": {
  "firstperson_righthand": {"rotation": [0, 45, 0], "scale": [0.4, 0.4, 0.4]},
  "firstperson_lefthand": {"rotation": [0, 225, 0], "scale": [0.4, 0.4, 0.4]},
  "thirdperson_righthand": {"rotation": [75, 45, 0], "translation": [0, 2.5, 0], "scale": [0.375, 0.375, 0.375]},
  "ground": {"translation": [0, 3, 0], "scale": [0.25, 0.25, 0.25]},
  "fixed": {"scale": [0.5, 0.5, 0.5]}}})";

/// A parent with other names for the six sides.
struct Renaming {
  std::string_view name, parent;
  std::array<std::string_view, 6> sides;  ///< in the order of kSides
};
constexpr Renaming kRenamings[] = {
    {"cube_all", "cube", {"all", "all", "all", "all", "all", "all"}},
    {"cube_top", "cube", {"side", "top", "side", "side", "side", "side"}},
    {"cube_column", "cube", {"end", "end", "side", "side", "side", "side"}},
    {"cube_bottom_top", "cube", {"bottom", "top", "side", "side", "side", "side"}},
    {"orientable", "cube", {"top", "top", "front", "side", "side", "side"}},
    {"slab", "half", {"bottom", "top", "side", "side", "side", "side"}},
    {"slab_top", "upper_half", {"bottom", "top", "side", "side", "side", "side"}},
};

/// A box whose faces on the block's sides are hidden by neighbours.
std::string boxModel(int low, int high, std::string_view texture, std::string_view more) {
  std::string faces;
  for (const std::string_view side : kSides) {
    const bool inside = (side == "down" && low > 0) || (side == "up" && high < 16);
    faces += fmt::format("{}\"{}\": {{\"texture\": \"#{}\"{}{}}}", faces.empty() ? "" : ", ", side,
                         texture.empty() ? side : texture,
                         inside ? "" : fmt::format(", \"cullface\": \"{}\"", side), more);
  }
  return fmt::format(
      "{{\"parent\": \"block/block\", \"elements\": [{{\"from\": [0, {}, 0], \"to\": [16, {}, 16], "
      "\"faces\": {{{}}}}}]}}",
      low, high, faces);
}

/// Two planes along the diagonals.
std::string crossModel(std::string_view more) {
  const auto plane = [&](std::string_view from, std::string_view to, std::string_view a,
                         std::string_view b) {
    return fmt::format(
        "{{\"from\": {0}, \"to\": {1}, \"rotation\": {{\"origin\": [8, 8, 8], \"axis\": \"y\", "
        "\"angle\": 45, "
        "\"rescale\": true}}, \"faces\": {{\"{2}\": {{\"texture\": \"#cross\", \"uv\": [0, 0, 16, "
        "16]{4}}}, "
        "\"{3}\": {{\"texture\": \"#cross\", \"uv\": [0, 0, 16, 16]{4}}}}}}}",
        from, to, a, b, more);
  };
  return fmt::format("{{\"ambientocclusion\": false, \"elements\": [{}, {}]}}",
                     plane("[0.8, 0, 8]", "[15.2, 16, 8]", "north", "south"),
                     plane("[8, 0, 0.8]", "[8, 16, 15.2]", "west", "east"));
}

std::string renamedModel(const Renaming& row) {
  std::string textures;
  for (std::size_t i = 0; i < kSides.size(); ++i)
    textures += fmt::format("{}\"{}\": \"#{}\"", i == 0 ? "" : ", ", kSides[i], row.sides[i]);
  return fmt::format("{{\"parent\": \"block/orris_{}\", \"textures\": {{{}}}}}", row.parent,
                     textures);
}

}  // namespace

std::string builtinModel(std::string_view name) {
  constexpr std::string_view kBlocks = "minecraft:block/", kTinted = ", \"tintindex\": 0";
  if (name == "minecraft:item/generated") return kGenerated;
  if (name == "minecraft:item/handheld") return kHandheld;
  if (!name.starts_with(kBlocks)) return "";
  name.remove_prefix(kBlocks.size());
  const auto row = std::find_if(std::begin(kRenamings), std::end(kRenamings),
                                [&](const Renaming& candidate) { return candidate.name == name; });
  if (row != std::end(kRenamings)) return renamedModel(*row);
  if (name == "block") return kBlock;
  if (name == "cube" || name == "orris_cube") return boxModel(0, 16, "", "");
  if (name == "orris_half") return boxModel(0, 8, "", "");
  if (name == "orris_upper_half") return boxModel(8, 16, "", "");
  if (name == "leaves") return boxModel(0, 16, "all", kTinted);
  if (name == "cross") return crossModel("");
  if (name == "tinted_cross") return crossModel(kTinted);
  return "";
}

}  // namespace orris
