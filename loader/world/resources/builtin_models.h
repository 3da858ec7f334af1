// Parents that most models of resource packs build on and leave to the game.
#pragma once

#include <string>
#include <string_view>

namespace orris {

/// JSON of a model such as "minecraft:block/cube_all"; "" for one that Orris does not have.
std::string builtinModel(std::string_view name);

}  // namespace orris
