#include "check/pack/expression_checks.h"

#include "pack/expressions/expression.h"
#include "plan/uniforms.h"

namespace orris {

void checkCustomUniforms(const FolderInput& input, Diagnostics& diagnostics) {
  CustomUniforms(input.pack.properties.customUniforms, expressionInput, diagnostics);
}

}  // namespace orris
