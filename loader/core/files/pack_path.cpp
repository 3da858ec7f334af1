#include <orris/core/files/pack_path.h>

#include <algorithm>
#include <vector>

namespace orris {
namespace {

/// The folder that is the root, as the one that holds it knows it.
constexpr std::string_view kRootName = "shaders";
constexpr std::string_view kBeside = "..";

/// "/../shaders/a" is "/a"; "/.." names no file.
bool settleBeside(std::vector<std::string_view>& parts) {
  if (parts.front() != kBeside) return true;
  if (parts.size() > 1 && parts[1] == kRootName) parts.erase(parts.begin(), parts.begin() + 2);
  return !parts.empty() && parts.back() != kBeside;
}

}  // namespace

std::optional<std::string> resolvePackPath(std::string_view from, std::string_view path,
                                           AboveRoot aboveRoot) {
  if (path.empty() || path.find_first_of(std::string_view("\0\\", 2)) != std::string_view::npos) {
    return std::nullopt;
  }
  std::string joined =
      path.front() == '/' ? std::string() : std::string(packPathParent(from)) + "/";
  joined += path;

  std::vector<std::string_view> parts;
  for (size_t begin = 0; begin <= joined.size();) {
    const size_t end = std::min(joined.find('/', begin), joined.size());
    const std::string_view part = std::string_view(joined).substr(begin, end - begin);
    begin = end + 1;
    if (part.empty() || part == ".") continue;
    if (part != "..") {
      parts.push_back(part);
    } else if (!parts.empty() && parts.back() != kBeside) {
      parts.pop_back();
    } else if (aboveRoot == AboveRoot::Beside && parts.empty()) {
      parts.push_back(kBeside);
    } else if (aboveRoot != AboveRoot::Stay) {
      return std::nullopt;
    }
  }
  if (!parts.empty() && !settleBeside(parts)) return std::nullopt;
  std::string resolved;
  for (const std::string_view part : parts) resolved.append("/").append(part);
  return resolved.empty() ? "/" : resolved;
}

std::string_view packPathParent(std::string_view path) {
  const size_t slash = path.rfind('/');
  return slash == std::string_view::npos || slash == 0 ? "/" : path.substr(0, slash);
}

}  // namespace orris
