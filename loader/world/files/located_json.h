// JSON whose values know where they stand, for messages with line and column.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <orris/core/diagnostic.h>

namespace orris {

struct JsonMember;

/// One value. `offset` is the byte of the text where it starts.
struct JsonNode {
  enum class Kind { Null, Boolean, Integer, Real, String, Array, Object };
  Kind kind = Kind::Null;
  std::size_t offset = 0;
  bool boolean = false;
  std::int64_t integer = 0;
  double real = 0;  ///< also set for integers
  std::string text;
  std::vector<JsonNode> items;
  std::vector<JsonMember> members;  ///< in the order of the text

  /// The member's value; nullptr when this is no object or has no such member.
  const JsonNode* find(std::string_view key) const;
};

struct JsonMember {
  std::string key;
  std::size_t offset = 0;
  JsonNode value;
};

/// How mistakes in a kind of file are reported.
struct JsonRules {
  const char *syntaxId, *valueId;
  Severity severity;
  bool alone;  ///< nothing may stand behind the value; in files of the game anything may
  std::size_t mostBytes;  ///< a larger file is refused before it is read
};
extern const JsonRules kWorldJson, kResourceJson;

/// Text and its name, to locate diagnostics in.
struct JsonText {
  std::string_view text;
  std::string file;
  const JsonRules* rules = &kWorldJson;
  /// A message at the line and column of `offset`, with its source line.
  Diagnostic error(std::size_t offset, std::string id, std::string message,
                   std::string hint = "") const;
};

/// Strict JSON (no comments), nesting 32, repeated keys refused. nullopt and one error otherwise.
std::optional<JsonNode> parseLocatedJson(const JsonText& source, Diagnostics& diagnostics);

}  // namespace orris
