// What stands at file scope of a shader: functions and declarations, by token range.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <orris/glsl/tokens/token.h>

namespace orris {

struct OutlineItem {
  enum class Kind { Function, Prototype, Declaration, Empty };
  Kind kind = Kind::Declaration;
  std::size_t begin = 0;  ///< first token, no comment
  std::size_t end = 0;    ///< one past the last
  std::size_t name = 0;   ///< Function and Prototype: token of the name
};

/// Reads file scope without judging it: text it cannot make sense of becomes Declaration items.
std::vector<OutlineItem> outline(const std::vector<Token>& tokens);

struct Declarator {
  std::size_t name = 0;
  std::size_t initBegin = 0;  ///< tokens of the initialiser, empty range when there is none
  std::size_t initEnd = 0;
};

/// A Declaration item taken apart.
struct Declaration {
  std::vector<std::size_t> qualifiers;  ///< tokens, "layout" included
  std::size_t type = 0;                 ///< token of the type or block name
  std::vector<Declarator> declarators;
  std::vector<std::size_t> members;  ///< names inside the braces of a struct or block
  bool isBlock = false;              ///< interface block: without instance name members are global

  /// Token of the qualifier `text`, or npos.
  std::size_t qualifier(const std::vector<Token>& tokens, std::string_view text) const;
  static constexpr std::size_t npos = static_cast<std::size_t>(-1);
};

Declaration parseDeclaration(const std::vector<Token>& tokens, const OutlineItem& item);

/// Is the word a qualifier of GLSL (const, uniform, flat, highp, ...)?
bool isQualifier(std::string_view word);

}  // namespace orris
