// How the author laid out the tokens of a text: what the search for a missing brace goes by.
#pragma once

#include <vector>

#include <orris/glsl/compile/validate.h>
#include <orris/glsl/tokens/source_map.h>
#include <orris/glsl/tokens/token.h>

namespace orris {

/// A token with what the author's layout says of it.
struct LaidOut {
  const Token* token;
  bool firstOfLine = false;
  int indent = 0;     ///< of its line
  int statement = 0;  ///< indent of the line where its statement starts
  int around = -1;    ///< of a '{' before an #else or #endif: the indent of that
  int file = 0;       ///< number of its file
  int row = 0;        ///< of the text
};

/// One entry for each token, which must outlive the result. `lines` may be empty: columns count then.
std::vector<LaidOut> readLayout(const std::vector<Token>& tokens, const MappedText& text,
                                const SourceLines& lines);

}  // namespace orris
