// The tokens of a compiled text, with the author's indentation: what messages about its syntax
// reason with.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include <orris/glsl/compile/validate.h>
#include <orris/glsl/tokens/source_map.h>
#include <orris/glsl/tokens/token.h>

namespace orris {

/// Tokens of `text` without its lines of directives; origins are places in the text.
std::vector<Token> tokensOf(const MappedText& text);

/// The author's place just behind a token of `text`; file "" in text made by the host.
SourceLocation placeAfter(const MappedText& text, const Token& token);

/// Where a syntax error that a compiler found in `line` (0: at the end of the text) really is, when
/// the line begins with what the compiler did not expect: behind the token before it. `message` is
/// the compiler's. nullopt when nothing is missing there.
std::optional<Token> tokenBeforeGap(const MappedText& text, int line, std::string_view message);

/// The "(" that has no ")" in the statement whose end in `line` a compiler did not expect, when only
/// one line of the statement lacks one. nullopt otherwise.
std::optional<Token> unclosedParenthesis(const MappedText& text, int line,
                                         std::string_view message);

}  // namespace orris
