#include <orris/world/blocks/block_state.h>

#include <algorithm>

namespace orris {
namespace {

bool isWord(std::string_view text, std::string_view extra) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [&](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' ||
           extra.find(c) != std::string_view::npos;
  });
}

std::optional<std::string> parseName(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) {
    return isWord(text, "-./") ? std::optional("minecraft:" + std::string(text)) : std::nullopt;
  }
  if (!isWord(text.substr(0, colon), "-.") || !isWord(text.substr(colon + 1), "-./")) {
    return std::nullopt;
  }
  return std::string(text);
}

/// "a=1,b=2"; an empty list is allowed, a repeated key is not.
bool parseProperties(std::string_view text, std::map<std::string, std::string>& properties) {
  while (!text.empty()) {
    const std::size_t comma = text.find(',');
    const std::string_view item = text.substr(0, comma);
    const std::size_t equals = item.find('=');
    if (equals == std::string_view::npos) return false;
    const std::string_view key = item.substr(0, equals), value = item.substr(equals + 1);
    if (!isWord(key, "") || !isWord(value, "")) return false;
    if (!properties.emplace(key, value).second) return false;
    if (comma == std::string_view::npos) return true;
    text.remove_prefix(comma + 1);
    if (text.empty()) return false;
  }
  return true;
}

}  // namespace

std::string_view BlockState::property(const std::string& key, std::string_view fallback) const {
  const auto found = properties.find(key);
  return found == properties.end() ? fallback : std::string_view(found->second);
}

std::string BlockState::toString() const {
  std::string text = name;
  char separator = '[';
  for (const auto& [key, value] : properties) {
    text += separator + key + '=' + value;
    separator = ',';
  }
  return properties.empty() ? text : text + ']';
}

std::optional<BlockState> parseBlockState(std::string_view text) {
  BlockState state;
  const std::size_t bracket = text.find('[');
  const std::optional<std::string> name = parseName(text.substr(0, bracket));
  if (!name) return std::nullopt;
  state.name = *name;
  if (bracket == std::string_view::npos) return state;
  if (text.back() != ']') return std::nullopt;
  const std::string_view inner = text.substr(bracket + 1, text.size() - bracket - 2);
  if (!parseProperties(inner, state.properties)) return std::nullopt;
  return state;
}

}  // namespace orris
