// Macro expansion over a stream of tokens, as the C preprocessor does it: arguments are expanded
// first, results are scanned again, a macro is not expanded inside its own expansion.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <orris/glsl/preprocess/macro_table.h>

namespace orris {

/// Where unexpanded tokens come from.
class TokenSource {
 public:
  virtual ~TokenSource() = default;
  virtual bool next(Token& token) = 0;  ///< false at the end
};

/// What all expansions of one source share.
struct ExpansionState {
  MacroTable& macros;
  std::vector<std::string>& usedNames;  ///< TokenStream::macroNames
  std::vector<Origin>& usedOrigins;
  std::function<void(const Token& at, std::string id, std::string message)> report;
  std::size_t produced = 0;  ///< tokens made by expansions so far
  std::size_t bytes = 0;     ///< length of the texts that these were made of
  std::size_t depth = 0;     ///< nesting of argument expansions
  bool exhausted = false;    ///< a limit was met and reported: nothing expands any more
};

class MacroExpander {
 public:
  MacroExpander(TokenSource& source, ExpansionState& state) : source_(source), state_(state) {}
  ~MacroExpander();
  MacroExpander(const MacroExpander&) = delete;
  MacroExpander& operator=(const MacroExpander&) = delete;

  /// The next fully expanded token; false at the end.
  bool next(Token& token);

 private:
  using Tokens = std::vector<Token>;
  struct Context {
    Tokens tokens;
    std::size_t position = 0;
    Macro* macro = nullptr;
  };
  struct Argument {
    Tokens raw;
    Tokens expanded;
    bool isExpanded = false;
  };

  bool fetch(Token& token);
  void pop();
  bool expand(Token& name);
  bool openParenthesisFollows();
  bool collectArguments(const Macro& macro, const Token& name, std::vector<Argument>& arguments);
  bool fitArguments(const Macro& macro, const Token& name, std::vector<Argument>& arguments);
  Tokens substitute(const Macro& macro, std::vector<Argument>& arguments);
  const Tokens& expandedArgument(Argument& argument);
  void push(Macro& macro, const Token& name, Tokens tokens);
  bool spend(const Token& at, std::size_t tokens);

  TokenSource& source_;
  ExpansionState& state_;
  std::vector<Context> contexts_;
  bool carriedSpace_ = false;  ///< white space of expansions that left nothing
  int carriedNewlines_ = 0;
};

/// Expands a whole list.
std::vector<Token> expandTokens(std::vector<Token> tokens, ExpansionState& state);

}  // namespace orris
