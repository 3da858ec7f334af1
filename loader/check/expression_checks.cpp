#include "check/expression_checks.h"

#include "frame/uniforms.h"
#include "pack/expression.h"

namespace orris {

void checkCustomUniforms(const FolderInput& input, Diagnostics& diagnostics) {
  CustomUniforms(input.pack.properties.customUniforms, expressionInput, diagnostics);
}

}  // namespace orris
