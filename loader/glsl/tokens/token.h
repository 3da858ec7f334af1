// GLSL tokens with their origin: what the preprocessor yields and the rewrites edit.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <orris/glsl/tokens/source_map.h>

namespace orris {

enum class TokenKind { Identifier, Number, Punctuator, Comment, Other };

struct Token {
  TokenKind kind = TokenKind::Other;
  std::string text;
  bool spaceBefore = false;
  int newlinesBefore = 0;  ///< line breaks before this token in the output
  Origin origin;
  int macro = -1;        ///< index into TokenStream::macroNames, or -1
  Origin written;        ///< of a token from a macro's body: its place in the definition
  bool painted = false;  ///< the preprocessor's mark: never expand this name again
  bool unused = false;   ///< of a function that nothing calls: printed as MappedText::Unused
};

inline bool isPunctuator(const Token& token, std::string_view text) {
  return token.kind == TokenKind::Punctuator && token.text == text;
}

inline bool isIdentifier(const Token& token, std::string_view text) {
  return token.kind == TokenKind::Identifier && token.text == text;
}

/// A preprocessed stage: no directives remain in `tokens`; comments do.
struct TokenStream {
  std::vector<Token> tokens;
  std::vector<IncludeSite> sites;
  std::vector<std::string> macroNames;
  std::vector<Origin> macroOrigins;  ///< definition of each macro; site -1: by the host
  int version = 0;                   ///< from the active #version; 0 when there was none
  std::string profile;               ///< "compatibility", "core" or ""
  Origin versionOrigin;
  struct Extension {
    std::string name, behaviour;
    Origin origin;
  };
  std::vector<Extension> extensions;  ///< active #extension lines, in order
};

/// Splits GLSL (no directives) into tokens; lines and columns count from the start of `text`, the
/// site stays -1. A block comment that is not closed ends with the text.
std::vector<Token> tokenize(std::string_view text);

/// Appends the tokens of `text` from offset `from` to `out`; `origin.column` is the offset in `text`
/// plus 1. Returns the offset of a block comment that `text` does not close, or text.size().
std::size_t tokenizeFrom(std::string_view text, std::size_t from, std::vector<Token>& out);

/// Would `left` directly followed by `right` be read as other tokens ("-" and "-1")?
bool wouldGlue(const Token& left, const Token& right);

/// Text and map: "#version N profile", the extensions, then the tokens without comments.
MappedText print(const TokenStream& stream);

}  // namespace orris
