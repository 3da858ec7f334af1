// What the rules of rewrite() share, and their list.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <orris/glsl/iris/iris_text.h>
#include <orris/glsl/rewrite/rewrite.h>

namespace orris {

/// One stage being rewritten.
class RewriteContext {
 public:
  RewriteContext(TokenStream& tokenStream, Stage shaderStage)
      : stream(tokenStream),
        stage(shaderStage),
        packVersion(tokenStream.version > 0 ? tokenStream.version : 110) {}

  /// Notes that `rule` changed something at `origin`.
  void fired(std::string_view rule, const Origin& origin);
  bool hasFired(std::string_view rule) const;

  TokenStream& stream;
  const Stage stage;
  const int packVersion;              ///< before the version rule; no #version means 110
  const IrisProgram* iris = nullptr;  ///< of the text that Iris makes (glsl/iris/iris_text.h)
  std::vector<AppliedRule> rules;
  std::span<const HostName> moreNames{};  ///< of this kind of program, for host-names
};

/// Insertions and removals by token index, collected first and applied in one pass.
class TokenEdits {
 public:
  void insertBefore(std::size_t index, std::vector<Token> tokens);
  void erase(std::size_t first, std::size_t last);  ///< [first, last)
  bool empty() const { return edits_.empty(); }
  /// Later edits of text already erased are dropped. A line break of erased text is kept.
  void apply(std::vector<Token>& tokens);

 private:
  struct Edit {
    std::size_t first;
    std::size_t last;
    std::vector<Token> tokens;
  };
  std::vector<Edit> edits_;
};

/// Index of the nearest token that is no comment, after or before `index`; tokens.size() if none.
std::size_t nextCode(const std::vector<Token>& tokens, std::size_t index);
std::size_t previousCode(const std::vector<Token>& tokens, std::size_t index);
bool followedBy(const std::vector<Token>& tokens, std::size_t index, std::string_view punctuator);
bool precededBy(const std::vector<Token>& tokens, std::size_t index, std::string_view punctuator);
/// Index of the token that closes the bracket at `open`; tokens.size() when there is none.
std::size_t closingBracket(const std::vector<Token>& tokens, std::size_t open);

/// Functions that glslang does not fold although they make constant expressions: of matrices, bit
/// patterns, packing. GLSL 4.50, section 4.3.3.
bool isUnfoldedBuiltin(std::string_view name);

/// Does each brace have its partner? Without it an outline means nothing.
bool bracesBalance(const TokenStream& stream);

/// Tokens made by the host out of GLSL text; the first starts a line when `newLine`.
std::vector<Token> hostTokens(std::string_view text, bool newLine);

void ruleExtensions(RewriteContext& context);
void ruleAttributeVarying(RewriteContext& context);
void ruleFloatLiterals(RewriteContext& context);
void ruleTextureFunctions(RewriteContext& context);
void ruleTextureName(RewriteContext& context);
void ruleReservedNames(RewriteContext& context);
void ruleStraySemicolon(RewriteContext& context);
void ruleUnusedFunctions(RewriteContext& context);
void ruleGlobalConst(RewriteContext& context);
void ruleMixBool(RewriteContext& context);
void ruleZeroInit(RewriteContext& context);
void ruleEntityId(RewriteContext& context);
void ruleSharedBounds(RewriteContext& context);
void ruleOutColor(RewriteContext& context);
void ruleFragData(RewriteContext& context);
void ruleHostNames(RewriteContext& context);
void ruleVersion(RewriteContext& context);

// Of the text that Iris makes, in which `context.iris` is set.
void ruleIrisExtensions(RewriteContext& context);
void ruleIrisConst(RewriteContext& context);
void ruleIrisFragData(RewriteContext& context);
void ruleIrisEntity(RewriteContext& context);
void ruleIrisNames(RewriteContext& context);
void ruleIrisVersion(RewriteContext& context);

}  // namespace orris
