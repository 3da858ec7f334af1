#include "glsl/preprocessor.h"

#include <utility>

#include "glsl/directive_runner.h"

namespace orris {

TokenStream preprocess(const FlatSource& source, const MacroDefinitions& environment,
                       Diagnostics& diagnostics) {
  TokenStream stream;
  stream.sites = source.sites;
  DirectiveRunner runner(source, environment, stream, diagnostics);
  {
    MacroExpander expander(runner, runner.expansion());
    Token token;
    while (expander.next(token)) stream.tokens.push_back(std::move(token));
  }
  runner.finish();
  runner.requireVersion();
  return stream;
}

}  // namespace orris
