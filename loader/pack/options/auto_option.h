// Options that choose for themselves: `auto.<option>.<value> = cost` lines of shaders.properties say
// what each value costs in the scene at hand, and the host takes the cheapest. Data, not code.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orris/core/diagnostic.h>

namespace orris {

/// The value of an option that lets the host choose another of its values.
inline constexpr const char* kAutoValue = "AUTO";

/// What is known of a scene, by name (sceneQuantities()).
using Quantities = std::map<std::string, double, std::less<>>;

/// A quantity of scenes that costs may name.
struct SceneQuantity {
  std::string_view name, meaning;  ///< with its unit
};
/// All that the host knows.
std::span<const SceneQuantity> sceneQuantities();

/// A number times any quantities, milliseconds.
struct CostTerm {
  double factor = 0;
  std::vector<std::string> quantities;
};

/// What must hold for a value to be chosen.
struct CostCondition {
  std::string quantity;
  bool below = true;  ///< else: at least
  double bound = 0;
};

/// `auto.shadow_method.map = 0.3 + 1e-6 pixels if sun >= 0.01 and casters >= 1`
struct AutoCandidate {
  std::string option, value;
  std::vector<CostTerm> terms;
  std::vector<CostCondition> conditions;
  SourceLocation at;

  double cost(const Quantities& scene) const;  ///< milliseconds a frame
  bool allowed(const Quantities& scene) const;
  /// Names of all quantities, with repetitions.
  std::vector<std::string> quantities() const;
  /// As written, in one spelling: "0.3 + 1e-06 pixels if sun >= 0.01".
  std::string formula() const;
};

/// One value as it was judged.
struct AutoEstimate {
  std::string value;
  double milliseconds = 0;
  bool allowed = true;
};

/// What was chosen for an option, and of what.
struct AutoChoice {
  std::string option, value;
  std::vector<AutoEstimate> candidates;
};

/// Another value must cost less than this share of the present one's to take its place, so that a
/// scene at the border of two does not make them alternate.
inline constexpr double kAutoChange = 0.85;

/// The cheapest allowed candidate of `option`; the first of equals. `present`: the value in force
/// before, "" for none. An empty value when the option has no candidate that is allowed.
AutoChoice chooseAuto(std::span<const AutoCandidate> candidates, const std::string& option,
                      const Quantities& scene, const std::string& present);

}  // namespace orris
