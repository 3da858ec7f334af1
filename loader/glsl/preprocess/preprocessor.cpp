#include <orris/glsl/preprocess/preprocessor.h>

#include <utility>

#include <orris/core/add_diagnostic.h>
#include <orris/glsl/preprocess/directive_runner.h>

namespace orris {

TokenStream preprocess(const FlatSource& source, const MacroDefinitions& environment,
                       Diagnostics& diagnostics, NameWatch* watch) {
  TokenStream stream;
  stream.sites = source.sites;
  DirectiveRunner runner(source, environment, stream, diagnostics, watch);
  {
    MacroExpander expander(runner, runner.expansion());
    Token token;
    while (expander.next(token)) stream.tokens.push_back(std::move(token));
  }
  runner.finish();
  return stream;
}

void requireVersion(const TokenStream& stream, Diagnostics& diagnostics) {
  if (stream.versionOrigin.line > 0) return;
  SourceLocation at;
  if (!stream.sites.empty()) at = {stream.sites.front().file, 1, 0};
  addError(diagnostics, "version-missing", at, "no active #version; exactly one is required",
           "begin the file with '#version 330 compatibility'");
}

}  // namespace orris
