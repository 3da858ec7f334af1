#include "check/expression_checks.h"

#include <string>
#include <utility>

#include "frame/uniforms.h"
#include "pack/expression.h"

namespace orris {

void checkCustomUniforms(const FolderInput& input, Diagnostics& diagnostics) {
  Diagnostics found;
  CustomUniforms(input.pack.properties.customUniforms, expressionInput, found);
  for (Diagnostic& d : found) {
    // A pack names the biomes of newer games than the one it runs in.
    const bool ofGame = d.message.find("unknown name BIOME_") != std::string::npos;
    if (ofGame) d.severity = Severity::Note;
    diagnostics.push_back(std::move(d));
  }
}

}  // namespace orris
