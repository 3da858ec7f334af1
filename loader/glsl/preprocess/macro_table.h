// The macros known at one point of a source, and how a #define becomes one.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <orris/glsl/preprocess/name_watch.h>
#include <orris/glsl/preprocess/preprocessor.h>
#include <orris/glsl/tokens/token.h>

namespace orris {

/// One definition. It outlives its #undef, because an expansion may still be reading it.
struct Macro {
  enum Role { Plain = -1, Paste = -2, Stringify = -3 };
  std::string name;
  std::vector<std::string> parameters;
  std::vector<Token> body;
  std::vector<int> roles;  ///< for each body token: a parameter's index, or a Role
  bool functionLike = false;
  bool variadic = false;  ///< the last parameter takes the remaining arguments
  bool disabled = false;  ///< being expanded now (recursion guard)
  int mapIndex = -1;      ///< index in TokenStream::macroNames once used
  Origin origin;
};

class MacroTable {
 public:
  /// `watch`, when given, learns which of its names find() is asked for.
  explicit MacroTable(const MacroDefinitions& environment, NameWatch* watch = nullptr);

  /// Defines from the tokens after "#define" (comments removed), replacing any former definition.
  /// Returns what is wrong, "" when nothing is.
  std::string define(const std::vector<Token>& tokens, const Origin& origin);
  void undefine(std::string_view name);
  /// nullptr when there is no such macro.
  Macro* find(std::string_view name);
  /// What the names are looked up for from now on: a use of NameWatch. Returns what it was.
  unsigned char setPurpose(unsigned char use) { return std::exchange(purpose_, use); }

 private:
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const {
      return std::hash<std::string_view>{}(text);
    }
  };
  struct Entry {
    Macro* macro = nullptr;
    int watched = -1;  ///< index of the name in the watch
  };
  std::unordered_map<std::string, Entry, Hash, std::equal_to<>> byName_;
  std::deque<Macro> all_;
  NameWatch* watch_;
  unsigned char purpose_ = NameWatch::kText;
};

}  // namespace orris
