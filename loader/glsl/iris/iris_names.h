// What Iris puts in place of the names of old GLSL, and what it declares by itself, by kind of
// program. Iris: CommonTransformer, VanillaTransformer, VanillaCoreTransformer, SodiumTransformer,
// SodiumCoreTransformer, CompositeTransformer, CompositeCoreTransformer, DHTerrainTransformer,
// DHGenericTransformer, EntityPatcher.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include <orris/glsl/iris/iris_text.h>

namespace orris {

struct IrisName {
  std::string_view name;         ///< what the author writes
  std::string_view replacement;  ///< "": the name itself, declared where the author does not
  std::string_view declaration;  ///< GLSL that must stand before the first use; "" for none
  bool taken = false;            ///< Iris declares the name even where the author does
};

/// The names that Iris knows in a stage of `program`. `core` as isCoreForIris() says.
std::vector<IrisName> irisNames(const IrisProgram& program, Stage stage, bool core);

/// Functions of Iris's own are never the only ones to name themselves: the author's of that name are
/// not left out as unused.
bool isIrisFunction(const IrisProgram& program, Stage stage, std::string_view name);

/// Does Iris declare the name itself in programs of some kind, even where the author does?
bool isTakenByIris(std::string_view name);

/// The highest n for which gl_TextureMatrix[n] is known there; nullopt: none is.
std::optional<int> lastTextureMatrix(const IrisProgram& program, bool core);

}  // namespace orris
