#include <orris/world/blocks/block_state.h>
#include <orris/world/saved_things/entity_figures.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace orris {
namespace {

constexpr std::size_t kLongestName = 128;
constexpr std::string_view kGameSpace = "minecraft:";

constexpr EntityFigure kFigures[] = {
    {"armor_stand", "armor_stand"},
    {"arrow", "arrow"},
    {"spectral_arrow", "arrow"},
    {"item", "item"},
    {"item_frame", "item_frame"},
    {"glow_item_frame", "item_frame"},
    {"slime", "slime"},
    {"magma_cube", "slime"},
    {"spider", "spider"},
    {"cave_spider", "spider", 0.7f},
    // On two legs.
    {"player", "player"},
    {"mannequin", "player"},
    {"zombie", "player"},
    {"zombie_villager", "player"},
    {"husk", "player", 1.06f},
    {"drowned", "player"},
    {"skeleton", "player"},
    {"stray", "player"},
    {"bogged", "player"},
    {"parched", "player"},
    {"wither_skeleton", "player", 1.2f},
    {"villager", "player"},
    {"wandering_trader", "player"},
    {"witch", "player"},
    {"pillager", "player"},
    {"vindicator", "player"},
    {"evoker", "player"},
    {"illusioner", "player"},
    {"piglin", "player"},
    {"piglin_brute", "player"},
    {"zombified_piglin", "player"},
    // On four legs.
    {"cow", "cow"},
    {"mooshroom", "cow"},
    {"pig", "cow", 0.65f},
    {"sheep", "cow", 0.93f},
    {"goat", "cow", 0.93f},
    {"horse", "cow", 1.15f},
    {"donkey", "cow", 1.07f},
    {"mule", "cow", 1.15f},
    {"skeleton_horse", "cow", 1.15f},
    {"zombie_horse", "cow", 1.15f},
    {"llama", "cow", 1.3f},
    {"trader_llama", "cow", 1.3f},
    {"polar_bear", "cow"},
    {"wolf", "cow", 0.6f},
    {"fox", "cow", 0.5f},
    {"cat", "cow", 0.5f},
    {"ocelot", "cow", 0.5f},
};

constexpr std::string_view kUnseen[] = {"marker", "interaction"};

/// Names that more than their letters changed of.
constexpr std::pair<std::string_view, std::string_view> kRenamed[] = {
    {"entity_horse", "horse"},          {"lava_slime", "magma_cube"},
    {"mushroom_cow", "mooshroom"},      {"ozelot", "ocelot"},
    {"pig_zombie", "zombified_piglin"}, {"zombie_pigman", "zombified_piglin"},
};

std::string_view inGame(std::string_view kind) {
  return kind.starts_with(kGameSpace) ? kind.substr(kGameSpace.size()) : std::string_view();
}

/// "MushroomCow" is "mushroom_cow".
std::string inLowerCase(const std::string& id) {
  std::string name;
  for (const char c : id) {
    const bool capital = std::isupper(static_cast<unsigned char>(c)) != 0;
    if (capital && !name.empty() && name.back() != ':') name += '_';
    name += char(std::tolower(static_cast<unsigned char>(c)));
  }
  return name;
}

}  // namespace

const EntityFigure* findFigure(std::string_view kind) {
  const auto* found = std::ranges::find(kFigures, inGame(kind), &EntityFigure::kind);
  return found == std::end(kFigures) ? nullptr : found;
}

bool isUnseenKind(std::string_view kind) {
  return std::ranges::find(kUnseen, inGame(kind)) != std::end(kUnseen);
}

std::string currentKind(const std::string& id) {
  if (id.size() > kLongestName) return "";
  const auto state = parseBlockState(inLowerCase(id));
  if (!state || !state->properties.empty()) return "";
  for (const auto& [before, now] : kRenamed) {
    if (inGame(state->name) == before) return std::string(kGameSpace) + std::string(now);
  }
  return state->name;
}

}  // namespace orris
