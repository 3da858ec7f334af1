#include "check/pack/expression_checks.h"

#include "plan/uniforms.h"
#include "pack/expressions/expression.h"

namespace orris {

void checkCustomUniforms(const FolderInput& input, Diagnostics& diagnostics) {
  CustomUniforms(input.pack.properties.customUniforms, expressionInput, diagnostics);
}

}  // namespace orris
