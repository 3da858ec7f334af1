#include <orris/world/saves/block_palette.h>

#include <fmt/core.h>

namespace orris {
namespace {

constexpr const char* kAirs[] = {"minecraft:cave_air", "minecraft:void_air"};

}  // namespace

std::optional<BlockState> stateOfTag(const NbtTag& tag, std::string& problem) {
  const NbtTag* name = tag.find("Name");
  if (!name || !name->string()) {
    problem = "an entry of its palette has no \"Name\"";
    return std::nullopt;
  }
  std::string text = *name->string();
  const NbtTag* properties = tag.find("Properties");
  if (properties && properties->compound() && !properties->compound()->empty()) {
    char separator = '[';
    for (const auto& [key, value] : *properties->compound()) {
      text += separator + key + '=' + (value.string() ? *value.string() : "");
      separator = ',';
    }
    text += ']';
  }
  std::optional<BlockState> state = parseBlockState(text);
  if (!state)
    problem = fmt::format("\"{}\" in its palette is not a block state", text.substr(0, 100));
  for (const char* air : kAirs) {
    if (state && state->name == air) state = BlockState{"minecraft:air", {}};
  }
  return state;
}

std::uint32_t StateList::indexOf(const std::string& text, const BlockState& state) {
  const auto [entry, added] = indices_.emplace(text, std::uint32_t(states_.size()));
  if (added) states_.push_back(state);
  return entry->second;
}

}  // namespace orris
