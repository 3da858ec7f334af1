#include <orris/glsl/tokens/outline.h>

#include <algorithm>
#include <array>

#include <orris/glsl/rewrite/rewrite_rules.h>

namespace orris {
namespace {

constexpr std::array<std::string_view, 27> kQualifiers = {
    "const",    "uniform",  "in",       "out",       "inout",         "attribute", "varying",
    "flat",     "smooth",   "centroid", "sample",    "patch",         "invariant", "precise",
    "highp",    "mediump",  "lowp",     "shared",    "buffer",        "coherent",  "volatile",
    "restrict", "readonly", "layout",   "writeonly", "noperspective", "subroutine"};

bool opens(const Token& t) {
  return t.kind == TokenKind::Punctuator && (t.text == "(" || t.text == "[" || t.text == "{");
}

class OutlineReader {
 public:
  explicit OutlineReader(const std::vector<Token>& tokens) : tokens_(tokens) {}

  std::vector<OutlineItem> run() {
    std::size_t i =
        tokens_.empty() || tokens_[0].kind != TokenKind::Comment ? 0 : nextCode(tokens_, 0);
    while (i < tokens_.size()) {
      const OutlineItem item = readItem(i);
      items_.push_back(item);
      i = nextCode(tokens_, item.end - 1);
    }
    return std::move(items_);
  }

 private:
  OutlineItem readItem(std::size_t begin) const {
    OutlineItem item;
    item.begin = begin;
    if (isPunctuator(tokens_[begin], ";")) {
      item.kind = OutlineItem::Kind::Empty;
      item.end = begin + 1;
      return item;
    }
    bool assigned = false;
    for (std::size_t i = begin; i < tokens_.size(); i = nextCode(tokens_, i)) {
      const Token& token = tokens_[i];
      if (isPunctuator(token, "=")) assigned = true;
      if (isPunctuator(token, ";")) {
        item.end = i + 1;
        return item;
      }
      if (!opens(token)) continue;
      const std::size_t close = closingBracket(tokens_, i);
      if (close >= tokens_.size()) break;
      if (!assigned && token.text == "(" && readFunction(item, i, close)) return item;
      i = close;
    }
    item.end = tokens_.size();
    return item;
  }

  // "type name ( ... ) {" or "type name ( ... ) ;" with the parentheses given.
  bool readFunction(OutlineItem& item, std::size_t open, std::size_t close) const {
    const std::size_t name = previousCode(tokens_, open);
    if (name <= item.begin || name >= tokens_.size()) return false;
    if (tokens_[name].kind != TokenKind::Identifier || tokens_[name].text == "layout") return false;
    const std::size_t after = nextCode(tokens_, close);
    if (after >= tokens_.size()) return false;
    item.name = name;
    if (isPunctuator(tokens_[after], ";")) {
      item.kind = OutlineItem::Kind::Prototype;
      item.end = after + 1;
      return true;
    }
    if (!isPunctuator(tokens_[after], "{")) return false;
    item.kind = OutlineItem::Kind::Function;
    item.end = std::min(closingBracket(tokens_, after) + 1, tokens_.size());
    return true;
  }

  const std::vector<Token>& tokens_;
  std::vector<OutlineItem> items_;
};

class DeclarationReader {
 public:
  DeclarationReader(const std::vector<Token>& tokens, const OutlineItem& item)
      : tokens_(tokens), i_(item.begin), end_(item.end) {}

  Declaration run() {
    readQualifiers();
    readType();
    while (i_ < end_ && tokens_[i_].kind == TokenKind::Identifier) readDeclarator();
    return std::move(result_);
  }

 private:
  void advance() { i_ = nextCode(tokens_, i_); }
  bool at(std::string_view text) const { return i_ < end_ && isPunctuator(tokens_[i_], text); }

  void skipBrackets() {
    i_ = std::min(closingBracket(tokens_, i_), end_);
    advance();
  }

  void readQualifiers() {
    while (i_ < end_ && tokens_[i_].kind == TokenKind::Identifier &&
           isQualifier(tokens_[i_].text)) {
      result_.qualifiers.push_back(i_);
      advance();
      if (at("(")) skipBrackets();
    }
  }

  void readType() {
    result_.type = i_;
    const bool isStruct = i_ < end_ && isIdentifier(tokens_[i_], "struct");
    if (i_ < end_) advance();
    if (isStruct && i_ < end_ && tokens_[i_].kind == TokenKind::Identifier) {
      result_.type = i_;
      advance();
    }
    if (at("{")) {
      result_.isBlock = !isStruct;
      readMembers();
      skipBrackets();
    }
    while (at("[")) skipBrackets();
  }

  // A member's name stands before ';', ',' or '['.
  void readMembers() {
    const std::size_t close = std::min(closingBracket(tokens_, i_), end_);
    for (std::size_t m = i_; m < close; m = nextCode(tokens_, m)) {
      if (tokens_[m].kind == TokenKind::Identifier &&
          (followedBy(tokens_, m, ";") || followedBy(tokens_, m, ",") ||
           followedBy(tokens_, m, "["))) {
        result_.members.push_back(m);
      }
    }
  }

  void readDeclarator() {
    Declarator declarator;
    declarator.name = i_;
    advance();
    while (at("[")) skipBrackets();
    if (at("=")) {
      advance();
      declarator.initBegin = i_;
      while (i_ < end_ && !at(",") && !at(";")) {
        if (opens(tokens_[i_])) {
          skipBrackets();
        } else {
          advance();
        }
      }
      declarator.initEnd = std::min(i_, end_);
    }
    result_.declarators.push_back(declarator);
    if (at(",")) advance();
  }

  const std::vector<Token>& tokens_;
  std::size_t i_;
  std::size_t end_;
  Declaration result_;
};

}  // namespace

bool isQualifier(std::string_view word) {
  return std::find(kQualifiers.begin(), kQualifiers.end(), word) != kQualifiers.end();
}

std::vector<OutlineItem> outline(const std::vector<Token>& tokens) {
  return OutlineReader(tokens).run();
}

Declaration parseDeclaration(const std::vector<Token>& tokens, const OutlineItem& item) {
  return DeclarationReader(tokens, item).run();
}

std::size_t Declaration::qualifier(const std::vector<Token>& tokens, std::string_view text) const {
  for (std::size_t q : qualifiers) {
    if (tokens[q].text == text) return q;
  }
  return npos;
}

}  // namespace orris
