// The lamps that shadow volumes are drawn for, as shadowvolume.lights asks.
#pragma once

#include <optional>
#include <string>

namespace orris {

constexpr int kMostVolumeLights = 8;

struct VolumeLightSettings {
  int count = 0;    ///< 0..kMostVolumeLights
  float range = 1;  ///< blocks a light level
};

/// "4" or "4 1.5"; nullopt for anything else.
std::optional<VolumeLightSettings> parseVolumeLights(const std::string& text);

}  // namespace orris
