#include "core/pack_path.h"

#include <algorithm>
#include <vector>

namespace orris {

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
    } else if (!parts.empty()) {
      parts.pop_back();
    } else if (aboveRoot == AboveRoot::Refuse) {
      return std::nullopt;
    }
  }
  std::string resolved;
  for (const std::string_view part : parts) resolved.append("/").append(part);
  return resolved.empty() ? "/" : resolved;
}

std::string_view packPathParent(std::string_view path) {
  const size_t slash = path.rfind('/');
  return slash == std::string_view::npos || slash == 0 ? "/" : path.substr(0, slash);
}

}  // namespace orris
