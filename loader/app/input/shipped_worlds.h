// The worlds that come with Orris, by name.
#pragma once

#include <string>
#include <vector>

namespace orris {

/// Names of the worlds beside the installed command (share/orris/worlds) and in the source tree, sorted.
std::vector<std::string> shippedWorldNames();

/// What `request` names: itself where it exists, is no plain name or is a random room, else the folder of the shipped world
/// of that name; "" when there is none.
std::string findWorld(const std::string& request);

}  // namespace orris
