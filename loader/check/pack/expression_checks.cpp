#include <orris/check/pack/expression_checks.h>

#include <orris/pack/expressions/expression.h>
#include <orris/plan/frame/uniforms.h>

namespace orris {

void checkCustomUniforms(const FolderInput& input, Diagnostics& diagnostics) {
  CustomUniforms(input.pack.properties.customUniforms, expressionInput, diagnostics);
}

}  // namespace orris
