#include <orris/glsl/syntax/struct_size.h>

#include <fmt/format.h>

#include <map>
#include <string_view>

#include <orris/core/limits.h>

namespace orris {
namespace {

class StructSizes {
 public:
  explicit StructSizes(const std::vector<Token>& tokens) {
    for (const Token& token : tokens)
      if (token.kind != TokenKind::Comment) tokens_.push_back(&token);
  }

  /// The name of the first struct with too many members; nullptr: there is none.
  const Token* tooLarge() {
    for (; next_ + 2 < tokens_.size(); ++next_) {
      if (!isIdentifier(*tokens_[next_], "struct") || !isPunctuator(*tokens_[next_ + 2], "{"))
        continue;
      const Token& name = *tokens_[next_ + 1];
      next_ += 3;
      if ((sizes_[name.text] = members()) > limits::kStructMembers) return &name;
    }
    return nullptr;
  }

 private:
  /// Of the struct whose '{' stands before the next token. A comma between brackets is none of a list.
  std::size_t members() {
    std::size_t all = 0, type = 1;
    int depth = 0;
    for (; next_ < tokens_.size() && !isPunctuator(*tokens_[next_], "}"); ++next_) {
      const Token& token = *tokens_[next_];
      if (isPunctuator(token, "[") || isPunctuator(token, "(")) ++depth;
      if (isPunctuator(token, "]") || isPunctuator(token, ")")) --depth;
      if (const auto known = sizes_.find(token.text); known != sizes_.end() && depth == 0)
        type = known->second;
      const bool ends = isPunctuator(token, ";");
      if (ends || (depth == 0 && isPunctuator(token, ","))) all += type;
      if (ends) type = 1;
    }
    return all;
  }

  std::vector<const Token*> tokens_;  ///< without comments
  std::size_t next_ = 0;
  std::map<std::string_view, std::size_t> sizes_;
};

}  // namespace

void checkStructSizes(const TokenStream& stream, Diagnostics& diagnostics) {
  const Token* const name = StructSizes(stream.tokens).tooLarge();
  if (!name) return;
  diagnostics.push_back(
      {.severity = Severity::Error,
       .id = "struct-too-large",
       .at = locate(stream.sites, name->origin),
       .message = fmt::format("struct {} has more than {} members with those of its structs",
                              name->text, limits::kStructMembers),
       .includedFrom = includedFrom(stream.sites, name->origin.site)});
}

}  // namespace orris
