// glslang's syntax errors as sentences: its parser names tokens by the words of its grammar.
#pragma once

#include <string>
#include <string_view>

#include <orris/glsl/tokens/source_map.h>

namespace orris {

struct SyntaxMessage {
  std::string text;    ///< "syntax error: expected ';' before 'b'"; "" when the message is another one
  std::string behind;  ///< "syntax error: expected ';' after": what stands before is to follow
  int column = 0;      ///< of what was not expected, in the compiled text; 0 when it is not found
};

/// What `message`, said of `line` of the text (0: of its end), means.
SyntaxMessage readSyntaxError(const MappedText& text, int line, std::string_view message);

}  // namespace orris
