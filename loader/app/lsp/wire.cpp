#include "app/lsp/wire.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <nlohmann/json.hpp>

#include <orris/pack/files/text.h>

namespace orris {
namespace {

constexpr std::string_view kLength = "content-length:";
// The largest file of a pack that is read as text, and room for escapes.
constexpr long long kLongestMessage = 256LL << 20;

/// -1: there is none.
long long lengthIn(std::string_view header) {
  for (const std::string& line : splitLines(header)) {
    const std::string low = lowerCase(line);
    if (!low.starts_with(kLength)) continue;
    const auto length = parseInteger(trim(std::string_view(low).substr(kLength.size())));
    if (length && *length >= 0 && *length <= kLongestMessage) return *length;
  }
  return -1;
}

}  // namespace

bool LspWire::fill() {
  char bytes[1 << 16];
  ssize_t count = 0;
  do count = ::read(in_, bytes, sizeof bytes);
  while (count < 0 && errno == EINTR);
  if (count <= 0) return false;
  read_.append(bytes, std::size_t(count));
  return true;
}

std::optional<nlohmann::json> LspWire::next() {
  const std::size_t end = read_.find("\r\n\r\n");
  if (end == std::string::npos) return std::nullopt;
  const long long length = lengthIn(std::string_view(read_).substr(0, end));
  const std::size_t body = end + 4;
  if (length < 0) {
    broken_ = true;
    return std::nullopt;
  }
  if (read_.size() - body < std::size_t(length)) return std::nullopt;
  auto message = nlohmann::json::parse(read_.begin() + std::ptrdiff_t(body),
                                       read_.begin() + std::ptrdiff_t(body) + length, nullptr, false);
  read_.erase(0, body + std::size_t(length));
  return message.is_object() ? message : nlohmann::json::object();
}

void LspWire::send(const nlohmann::json& message) {
  const std::string body = message.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  const std::string all = fmt::format("Content-Length: {}\r\n\r\n{}", body.size(), body);
  for (std::size_t at = 0; at < all.size();) {
    const ssize_t count = ::write(out_, all.data() + at, all.size() - at);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      broken_ = true;
      return;
    }
    at += std::size_t(count);
  }
}

}  // namespace orris
