// Block states as tags, {Name, Properties}, and the palette that they make.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include <orris/world/blocks/block_state.h>
#include <orris/world/files/nbt.h>

namespace orris {

/// The state that a compound of a palette names; all kinds of air are air. nullopt and why not.
std::optional<BlockState> stateOfTag(const NbtTag& tag, std::string& problem);

/// States, each once; the first is air.
class StateList {
 public:
  StateList() { indexOf("minecraft:air", {"minecraft:air", {}}); }
  std::uint32_t indexOf(const BlockState& state) { return indexOf(state.toString(), state); }
  const std::vector<BlockState>& states() const { return states_; }
  std::vector<BlockState> take() { return std::move(states_); }

 private:
  std::uint32_t indexOf(const std::string& text, const BlockState& state);
  std::vector<BlockState> states_;
  std::unordered_map<std::string, std::uint32_t> indices_;
};

}  // namespace orris
