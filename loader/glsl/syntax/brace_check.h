// Which brace is missing: a compiler notices only where the text ends or makes no sense any more.
#pragma once

#include <optional>
#include <string_view>

#include <orris/glsl/tokens/source_map.h>
#include <orris/glsl/tokens/token.h>
#include <orris/glsl/compile/validate.h>

namespace orris {

struct MissingBrace {
  char brace = '}';
  Token after;     ///< the last token before the place where it is missing
  Token partner;   ///< the brace that has no other
  int indent = 0;  ///< of the statement with the partner
  bool surplus = false;  ///< no head lacks its '{': it is the partner that is too many
};

/// Columns of white space before the text; tabs reach to multiples of four.
int indentWidth(std::string_view line);

/// Where the author should write it: behind the directives that stand inside the block.
SourceLocation placeOfBrace(const MappedText& text, const MissingBrace& missing,
                            const SourceLines& lines);

/// Judged by functions, which cannot stand in one another, and then by the author's indentation.
/// nullopt when all braces have partners.
std::optional<MissingBrace> findMissingBrace(const MappedText& text, const SourceLines& lines);

}  // namespace orris
