// The preprocessor packs are written for (Iris runs JCPP over the flattened source; the driver sees
// no directive but #version and #extension). Contract: contract/README "Preprocessor".
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <orris/core/diagnostic.h>
#include <orris/glsl/preprocess/name_watch.h>
#include <orris/glsl/tokens/token.h>

namespace orris {

/// Object-like macros known from the first line, name and body.
using MacroDefinitions = std::vector<std::pair<std::string, std::string>>;

/// Expands macros and conditionals. A redefinition silently replaces; an undefined identifier in #if
/// is 0; #if is integer arithmetic; `\`-newline joins lines; ## and # work; __LINE__ etc. are
/// ordinary names; #extension and #version of active branches are collected; comments survive as
/// tokens. Errors (unbalanced conditionals, malformed directives, #error) are located diagnostics;
/// preprocessing goes on after each. A source without an active #version keeps version 0.
/// `watch`, when given, learns which of its names were looked up.
TokenStream preprocess(const FlatSource& source, const MacroDefinitions& environment,
                       Diagnostics& diagnostics, NameWatch* watch = nullptr);

/// Reports a stage without an active #version. Contract: "Exactly one active #version is required".
void requireVersion(const TokenStream& stream, Diagnostics& diagnostics);

/// The same over a *.properties text: directives are honoured where '#' opens the line and the word
/// follows without a blank, other '#' and '!' lines are comments and vanish, '#' elsewhere is
/// deleted; macros expand in keys and values (Iris: PropertiesPreprocessor). A backslash joins no
/// lines, so directives work inside a continued value. Line n stays line n, lines of inactive
/// branches become empty. Bodies in `environment` are taken as they are: an empty macro expands to
/// nothing, so give it the body "1" where the contract wants that.
std::string preprocessProperties(const std::string& file, const std::string& text,
                                 const MacroDefinitions& environment, Diagnostics& diagnostics,
                                 NameWatch* watch = nullptr);

}  // namespace orris
