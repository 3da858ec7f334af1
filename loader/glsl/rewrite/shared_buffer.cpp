#include <orris/glsl/rewrite/shared_buffer.h>

#include <fmt/format.h>

#include <map>

#include <orris/glsl/rewrite/rewrite_rules.h>
#include <orris/glsl/rewrite/text_code.h>
#include <orris/glsl/tokens/text_edits.h>

namespace orris {
namespace {

constexpr const char* kSharedPrelude =
    "uint orris_group() { return gl_WorkGroupID.x + gl_NumWorkGroups.x * "
    "(gl_WorkGroupID.y + gl_NumWorkGroups.y * gl_WorkGroupID.z); } "
    "void orris_bufferBarrier() { memoryBarrierBuffer(); memoryBarrierShared(); barrier(); "
    "memoryBarrierBuffer(); } ";

/// "shared TYPE[N] a[M], b;", tokens [first, last) with the ";".
struct SharedDeclaration {
  std::size_t first = 0, last = 0;
  std::vector<std::size_t> names;
  bool array = false;
};

class SharedMover {
 public:
  explicit SharedMover(const StageText& stage)
      : stage_(stage), tokens_(codeTokens(stage.text.text)) {}

  std::optional<SharedBuffers> run() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (!isIdentifier(tokens_[i], "shared") || precededBy(tokens_, i, "(")) continue;
      const SharedDeclaration declaration = read(i);
      i = declaration.last;
      if (declaration.array && !declaration.names.empty()) move(declaration);
    }
    if (blocks_.empty() || !renameUses()) return std::nullopt;
    edits_.insert(offsetOf(tokens_.front()), kSharedPrelude);
    return SharedBuffers{{stage_.stage, edits_.apply(stage_.text)}, blocks_};
  }

 private:
  SharedDeclaration read(std::size_t first) const {
    SharedDeclaration declaration{first, first + 1, {}, false};
    std::size_t& i = declaration.last;
    bool body = false;  // a struct without a name stays: it cannot stand in another
    for (; i < tokens_.size() && !isPunctuator(tokens_[i], ";"); ++i) {
      body |= isPunctuator(tokens_[i], "{");
      declaration.array |= isPunctuator(tokens_[i], "[");
      const bool opens = isPunctuator(tokens_[i], "[") || isPunctuator(tokens_[i], "{");
      if (opens) i = std::min(closingBracket(tokens_, i), tokens_.size() - 1);
      const bool ends = followedBy(tokens_, i, "[") || followedBy(tokens_, i, ",") ||
                        followedBy(tokens_, i, ";");
      // The type has a name behind it, and perhaps brackets between.
      const bool named = tokens_[i].kind == TokenKind::Identifier && i > first + 1;
      if (named && ends && (declaration.names.empty() || precededBy(tokens_, i, ",")))
        declaration.names.push_back(i);
    }
    if (body) declaration.names.clear();
    return declaration;
  }

  void move(const SharedDeclaration& declaration) {
    const std::size_t number = blocks_.size();
    blocks_.push_back(fmt::format("orris_SharedBlock{}", number));
    edits_.rename(offsetOf(tokens_[declaration.first]), tokens_[declaration.first].text.size(),
                  fmt::format("struct orris_Shared{} {{", number));
    edits_.insert(offsetOf(tokens_[declaration.last]) + 1,
                  fmt::format(" }}; layout(std430) coherent buffer {} {{ orris_Shared{} "
                              "orris_shared{}[]; }};",
                              blocks_.back(), number, number));
    for (const std::size_t name : declaration.names)
      places_[tokens_[name].text] = fmt::format("orris_shared{}[orris_group()].", number);
    for (std::size_t i = declaration.first; i <= declaration.last; ++i) declared_.push_back(i);
  }

  /// false: a name is declared again, of a parameter or a variable.
  bool renameUses() {
    std::size_t declared = 0;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      const bool inDeclaration = declared < declared_.size() && declared_[declared] == i;
      declared += inDeclaration ? 1 : 0;
      if (inDeclaration || tokens_[i].kind != TokenKind::Identifier) continue;
      const std::string& word = tokens_[i].text;
      if (word == "barrier" && followedBy(tokens_, i, "("))
        edits_.rename(offsetOf(tokens_[i]), word.size(), "orris_bufferBarrier");
      if (word == "memoryBarrierShared" && followedBy(tokens_, i, "("))
        edits_.rename(offsetOf(tokens_[i]), word.size(), "groupMemoryBarrier");
      const auto place = places_.find(word);
      if (place == places_.end() || precededBy(tokens_, i, ".")) continue;
      const Token& before = tokens_[previousCode(tokens_, i)];
      if (before.kind == TokenKind::Identifier && before.text != "return" && before.text != "else")
        return false;
      edits_.insert(offsetOf(tokens_[i]), place->second);
    }
    return true;
  }

  const StageText& stage_;
  std::vector<Token> tokens_;
  TextEdits edits_;
  std::vector<std::string> blocks_;
  std::map<std::string, std::string, std::less<>> places_;
  std::vector<std::size_t> declared_;  ///< tokens of moved declarations, ascending
};

}  // namespace

std::optional<SharedBuffers> moveSharedToBuffers(const StageText& stage) {
  if (stage.stage != Stage::Compute) return std::nullopt;
  return SharedMover(stage).run();
}

}  // namespace orris
