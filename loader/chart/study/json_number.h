// Measured values in JSON, which has no infinity.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>

namespace orris {

/// null where `value` is not finite.
inline nlohmann::json jsonNumber(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr);
}

}  // namespace orris
