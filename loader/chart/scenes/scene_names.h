// The scenes that a study judges settings on, by name.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace orris {

struct SceneName {
  std::string world;   ///< as WORLD
  std::string camera;  ///< "" for the first
  bool operator==(const SceneName&) const = default;
};

/// "cornell", "h4_house@inside", and "random:SEED:N" for N rooms with the seeds SEED, SEED + 2, ... of one parity.
/// nullopt for a list that is malformed.
std::optional<std::vector<SceneName>> parseScenes(const std::vector<std::string>& list);

/// A name for files about the scene.
std::string fileStem(const SceneName& scene);

}  // namespace orris
