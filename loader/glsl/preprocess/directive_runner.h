// Reads a flattened source line by line and runs its directives; what remains is the unexpanded text
// of active branches.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <orris/glsl/preprocess/conditionals.h>
#include <orris/glsl/preprocess/line_reader.h>
#include <orris/glsl/preprocess/macro_expander.h>
#include <orris/glsl/syntax/conditional_balance.h>

namespace orris {

/// Iris: JcppProcessor logs what its preprocessor complains about and goes on.
inline constexpr const char* kTolerated = "Iris goes on after this, other hosts refuse the program";

class DirectiveRunner : public TokenSource {
 public:
  /// `stream` takes the version, the extensions and the names of used macros.
  DirectiveRunner(const FlatSource& source, const MacroDefinitions& environment,
                  TokenStream& stream, Diagnostics& diagnostics, NameWatch* watch = nullptr);

  bool next(Token& token) override;
  ExpansionState& expansion() { return expansion_; }

  /// Reports what is still open at the end.
  void finish();

  /// Runs one directive; `tokens` starts with its name, comments are removed.
  void run(std::vector<Token> tokens, const Origin& hash);
  bool active() const { return conditionals_.active(); }

 private:
  struct Directive;
  static const Directive* find(std::string_view name);

  bool readLine();
  bool takeDirective();
  void report(Severity severity, std::string id, const Origin& at, std::string message,
              std::string hint = "");
  /// An error by which Iris does not draw what it stands in: `effect` says how much.
  void refuse(Effect effect, std::string id, const Origin& at, std::string message, std::string hint = "");
  void reportUnknown(const std::string& name, const std::string& meant, const Origin& hash);
  void reportUnbalanced(const Origin& at, std::string problem);
  void reportUnbalanced(const UnbalancedConditional& found);
  void reportUnclosedComment(const Origin& at);
  void warnTrailing(const std::vector<Token>& tokens, std::size_t from, const std::string& name);
  bool evaluate(const std::vector<Token>& tokens);
  bool isTrue(const std::vector<Token>& tokens);
  bool replaceDefined(const std::vector<Token>& tokens, std::vector<Token>& out);
  bool macroNamed(const std::vector<Token>& tokens);

  void onIf(const std::vector<Token>& tokens);
  void onIfdef(const std::vector<Token>& tokens);
  void onElif(const std::vector<Token>& tokens);
  void onElse(const std::vector<Token>& tokens);
  void onEndif(const std::vector<Token>& tokens);
  void onDefine(const std::vector<Token>& tokens);
  void onUndef(const std::vector<Token>& tokens);
  void onVersion(const std::vector<Token>& tokens);
  void onExtension(const std::vector<Token>& tokens);
  void onError(const std::vector<Token>& tokens);
  void onIgnored(const std::vector<Token>& tokens);

  /// Reports the files whose own conditionals do not pair, once; false when there is none, so that
  /// it is the order of the includes that matters.
  bool reportInFiles();

  const FlatSource& source_;
  std::optional<std::vector<UnbalancedConditional>> unbalanced_;
  LineReader reader_;
  const std::vector<IncludeSite>& sites_;
  TokenStream& stream_;
  Diagnostics& diagnostics_;
  std::size_t reported_ = 0;
  MacroTable macros_;
  Conditionals conditionals_;
  ExpansionState expansion_;
  std::vector<Token> line_;
  std::size_t position_ = 0;
  int pendingNewlines_ = 0;
};

/// A comment counts as one blank.
void removeComments(std::vector<Token>& tokens);
/// The author's words of a token list, one blank where there was white space.
std::string joinTokens(const std::vector<Token>& tokens, std::size_t from);

}  // namespace orris
