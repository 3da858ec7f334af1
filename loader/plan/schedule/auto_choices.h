// Options whose value is AUTO, resolved: a program is compiled for the value that costs least here.
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <orris/pack/options/auto_option.h>
#include <orris/pack/shader_pack.h>

namespace orris {

/// Measures the named quantities of the scene as it is now.
using SceneMeter = std::function<Quantities(const std::set<std::string>& wanted)>;

class AutoChoices {
 public:
  /// Chooses anew for `asked`, a pack under the values of `request`. What was chosen before keeps its
  /// place unless another is clearly cheaper (kAutoChange).
  void choose(const ShaderPack& asked, const LoadRequest& request, const SceneMeter& meter);
  /// `request` with what was chosen in place of AUTO.
  LoadRequest applied(LoadRequest request) const;

  /// One for each option that is AUTO and has candidates, in the pack's order; its value is AUTO where
  /// no candidate is allowed.
  const std::vector<AutoChoice>& all() const { return choices_; }
  const Quantities& quantities() const { return quantities_; }
  /// "LIGHT_METHOD=CLUSTERED SHADOW_METHOD=MAP"; "" when nothing was chosen.
  std::string text() const;

 private:
  std::string present(const std::string& option) const;

  std::vector<AutoChoice> choices_;
  Quantities quantities_;
};

/// The candidates that the pack's properties list, and the options that are AUTO and have some.
std::vector<AutoCandidate> autoCandidates(const ShaderPack& pack);
std::vector<std::string> optionsAtAuto(const ShaderPack& pack);

}  // namespace orris
