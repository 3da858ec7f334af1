// Properties of the game's block states and the values they take, for finding misspelt ones.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace orris {

struct StateProperty {
  std::string_view name;
  std::vector<std::string> values;  ///< empty: any
  bool closed = false;              ///< it has no value beside these in any version of the game
};

/// Sorted by name; those of versions before 1.13 among them, which packs still list.
const std::vector<StateProperty>& stateProperties();
const StateProperty* findStateProperty(std::string_view name);

}  // namespace orris
