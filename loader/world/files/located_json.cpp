#include <orris/world/files/located_json.h>

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <unordered_set>

#include <orris/core/limits.h>
#include <orris/core/message_limits.h>

namespace orris {
namespace {

/// "[json.exception.parse_error.101] parse error at line 1, column 2: what" without what stands
/// before its last part; the diagnostic's own location says it.
std::string withoutPrefix(std::string what) {
  const std::size_t bracket = what.find("] ");
  if (bracket != std::string::npos) what.erase(0, bracket + 2);
  const std::size_t column = what.find(", column ");
  const std::size_t end = column == std::string::npos ? column : what.find(": ", column);
  if (end != std::string::npos) what.erase(0, end + 2);
  return what;
}

/// Follows the parser through the text. The parser reports every token but commas and colons, and
/// nothing else but white space stands between tokens, so the next token's start is known.
class TokenCursor {
 public:
  explicit TokenCursor(std::string_view text) : text_(text) {
    if (text.starts_with("\xef\xbb\xbf")) position_ = 3;
  }

  /// Start of the next token, which is then skipped.
  std::size_t next() {
    skipWhile(
        [](char c) { return std::string_view(" \t\r\n,:").find(c) != std::string_view::npos; });
    const std::size_t start = position_;
    const char first = start < text_.size() ? text_[start] : '\0';
    if (first == '"') {
      skipString();
    } else if (std::string_view("[]{}").find(first) != std::string_view::npos) {
      ++position_;
    } else {
      skipWhile([](char c) {
        return std::string_view(" \t\r\n,:[]{}").find(c) == std::string_view::npos;
      });
    }
    return start;
  }

 private:
  template <class Predicate>
  void skipWhile(Predicate predicate) {
    while (position_ < text_.size() && predicate(text_[position_])) ++position_;
  }

  void skipString() {
    for (++position_; position_ < text_.size() && text_[position_] != '"'; ++position_) {
      if (text_[position_] == '\\') ++position_;
    }
    ++position_;
  }

  std::string_view text_;
  std::size_t position_ = 0;
};

/// Builds the tree from nlohmann's events; its own tree has no positions.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  TreeBuilder(const JsonText& source, JsonNode& root, Diagnostics& diagnostics)
      : source_(source), cursor_(source.text), root_(root), diagnostics_(diagnostics) {}

  bool null() override { return add(JsonNode::Kind::Null) != nullptr && fits(); }
  bool boolean(bool value) override {
    add(JsonNode::Kind::Boolean)->boolean = value;
    return fits();
  }
  bool number_integer(number_integer_t value) override {
    JsonNode* node = add(JsonNode::Kind::Integer);
    node->integer = value;
    node->real = double(value);
    return fits();
  }
  bool number_unsigned(number_unsigned_t value) override {
    if (value > number_unsigned_t(std::numeric_limits<std::int64_t>::max())) {
      return number_float(double(value), {});
    }
    return number_integer(number_integer_t(value));
  }
  bool number_float(number_float_t value, const string_t&) override {
    add(JsonNode::Kind::Real)->real = value;
    return fits();
  }
  bool string(string_t& value) override {
    add(JsonNode::Kind::String)->text = std::move(value);
    return fits();
  }
  bool binary(binary_t&) override { return false; }  // never in text
  bool start_object(std::size_t) override { return open(JsonNode::Kind::Object); }
  bool start_array(std::size_t) override { return open(JsonNode::Kind::Array); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& value) override {
    const std::size_t offset = cursor_.next();
    JsonNode& object = *open_.back();
    if (!keys_.back().insert(value).second) {
      diagnostics_.push_back(
          source_.error(offset, source_.rules->syntaxId, fmt::format("the key \"{}\" is given twice", value)));
      return false;
    }
    object.members.push_back({std::move(value), offset, {}});
    return true;
  }

  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& problem) override {
    Diagnostic error =
        source_.error(position > 0 ? position - 1 : 0, source_.rules->syntaxId, withoutPrefix(problem.what()));
    MessageBudget().take(error);  // it quotes what was read last, however long
    diagnostics_.push_back(std::move(error));
    return false;
  }

 private:
  JsonNode* add(JsonNode::Kind kind) {
    JsonNode* node = &root_;
    if (!open_.empty()) {
      JsonNode& parent = *open_.back();
      node = parent.kind == JsonNode::Kind::Array ? &parent.items.emplace_back()
                                                  : &parent.members.back().value;
    }
    node->kind = kind;
    node->offset = last_ = cursor_.next();
    return node;
  }

  /// False and an error when there are more values than a world may have.
  bool fits() {
    if (++values_ <= limits::kWorldJsonValues) return true;
    diagnostics_.push_back(source_.error(
        last_, source_.rules->syntaxId, fmt::format("more than {} values up to here", limits::kWorldJsonValues)));
    return false;
  }

  bool open(JsonNode::Kind kind) {
    JsonNode* node = add(kind);
    if (open_.size() >= limits::kWorldJsonDepth) {
      diagnostics_.push_back(
          source_.error(node->offset, source_.rules->syntaxId,
                        fmt::format("nested deeper than {} levels", limits::kWorldJsonDepth)));
      return false;
    }
    keys_.emplace_back();
    open_.push_back(node);  // stays valid: a node's vector grows only after its last child closed
    return fits();
  }

  bool close() {
    cursor_.next();
    keys_.pop_back();
    open_.pop_back();
    return true;
  }

  const JsonText& source_;
  TokenCursor cursor_;
  JsonNode& root_;
  Diagnostics& diagnostics_;
  std::vector<JsonNode*> open_;
  std::vector<std::unordered_set<std::string>> keys_;  ///< of the objects in open_
  std::size_t values_ = 0, last_ = 0;  ///< how many were read, and where the last one stands
};

}  // namespace

const JsonRules kWorldJson = {"world-json-syntax", "world-json-value", Severity::Error, true,
                              std::numeric_limits<std::size_t>::max()};
const JsonRules kResourceJson = {"resource-json-syntax", "resource-json-value", Severity::Warning,
                                 false, limits::kResourceJsonBytes};

const JsonNode* JsonNode::find(std::string_view key) const {
  for (const JsonMember& member : members) {
    if (member.key == key) return &member.value;
  }
  return nullptr;
}

Diagnostic JsonText::error(std::size_t offset, std::string id, std::string message,
                           std::string hint) const {
  offset = std::min(offset, text.size());
  const std::string_view before = text.substr(0, offset);
  const std::size_t newline = before.rfind('\n');
  const std::size_t lineStart = newline == std::string_view::npos ? 0 : newline + 1;
  std::string_view line = text.substr(lineStart, text.find('\n', offset) - lineStart);
  if (line.ends_with('\r')) line.remove_suffix(1);
  const int column = int(offset - lineStart) + 1;
  return {.severity = rules->severity,
          .id = std::move(id),
          .at = {file, int(std::count(before.begin(), before.end(), '\n')) + 1, column},
          .message = std::move(message),
          .sourceLine = quotedLine(line, column),
          .hint = std::move(hint)};
}

std::optional<JsonNode> parseLocatedJson(const JsonText& source, Diagnostics& diagnostics) {
  if (source.text.size() > source.rules->mostBytes) {
    diagnostics.push_back(source.error(0, source.rules->valueId,
                                       fmt::format("the file has {} bytes: expected at most {}",
                                                   source.text.size(), source.rules->mostBytes)));
    return std::nullopt;
  }
  JsonNode root;
  TreeBuilder builder(source, root, diagnostics);
  if (!nlohmann::json::sax_parse(source.text, &builder, nlohmann::json::input_format_t::json, source.rules->alone)) return std::nullopt;
  return root;
}

}  // namespace orris
