// GLSL tokens with their origin: what the preprocessor yields and the rewrites edit.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "glsl/source_map.h"

namespace orris {

enum class TokenKind { Identifier, Number, Punctuator, Comment, Other };

struct Token {
  TokenKind kind = TokenKind::Other;
  std::string text;
  bool spaceBefore = false;
  int newlinesBefore = 0;  ///< line breaks before this token in the output
  Origin origin;
  int macro = -1;          ///< index into TokenStream::macroNames, or -1
};

/// A preprocessed stage: no directives remain in `tokens`; comments do.
struct TokenStream {
  std::vector<Token> tokens;
  std::vector<IncludeSite> sites;
  std::vector<std::string> macroNames;
  int version = 0;                     ///< from the active #version; 0 when there was none
  std::string profile;                 ///< "compatibility", "core" or ""
  Origin versionOrigin;
  struct Extension {
    std::string name, behaviour;
    Origin origin;
  };
  std::vector<Extension> extensions;   ///< active #extension lines, in order
};

/// Splits one line group of GLSL (no directives) into tokens; used by the preprocessor and by tests.
std::vector<Token> tokenize(std::string_view text);

/// Text and map: "#version N profile", the extensions, then the tokens without comments.
MappedText print(const TokenStream& stream);

}  // namespace orris
