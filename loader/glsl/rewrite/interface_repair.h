// What Iris repairs between the stages of a program, so that it links: rule stage-interface.
// Contract: README "Profiles and the patcher". Iris: CompatibilityTransformer.transformGrouped.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <orris/glsl/compile/validate.h>

namespace orris {

struct RepairedInterface {
  std::vector<StageText> stages;
  std::vector<std::string> names;  ///< of the varyings repaired, in the order of the stages
};

/// An input that is used and that the stage before does not declare is declared there as zero; an
/// output that is never mentioned again is zero; a scalar or vector of another type is converted at
/// the end of main. Blocks, structs, matrices and arrays stay as they are. nullopt: nothing to do.
std::optional<RepairedInterface> repairInterface(const std::vector<const StageText*>& stages);

}  // namespace orris
