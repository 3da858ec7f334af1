// What Iris puts in place of the names of old GLSL, and what it declares by itself, by kind of
// program. Iris: CommonTransformer, VanillaTransformer, VanillaCoreTransformer, SodiumTransformer,
// SodiumCoreTransformer, CompositeTransformer, CompositeCoreTransformer, DHTerrainTransformer,
// DHGenericTransformer, EntityPatcher.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "glsl/iris/iris_text.h"

namespace orris {

struct IrisName {
  std::string_view name;         ///< what the author writes
  std::string_view replacement;  ///< "": the name itself, declared where the author does not
  std::string_view declaration;  ///< GLSL that must stand before the first use; "" for none
};

/// The names that Iris knows in a stage of `program`. `core` as isCoreForIris() says.
std::vector<IrisName> irisNames(const IrisProgram& program, Stage stage, bool core);

/// The highest n for which gl_TextureMatrix[n] is known there; nullopt: none is.
std::optional<int> lastTextureMatrix(const IrisProgram& program, bool core);

}  // namespace orris
