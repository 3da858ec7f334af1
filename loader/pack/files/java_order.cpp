#include <orris/pack/files/java_order.h>

#include <algorithm>
#include <cstdint>

namespace orris {
namespace {

/// Objects.hash(path), spread as HashMap does; of a path in ASCII.
std::uint32_t hashOf(const std::string& path) {
  std::uint32_t text = 0;
  for (const char c : path) text = 31 * text + static_cast<unsigned char>(c);
  const std::uint32_t hash = 31 + text;
  return hash ^ hash >> 16;
}

/// A HashMap doubles when three quarters of it are full.
std::uint32_t bucketCount(std::size_t entries) {
  std::uint32_t count = 16;
  while (entries > count / 4 * 3) count *= 2;
  return count;
}

}  // namespace

std::vector<std::string> inJavaHashOrder(std::vector<std::string> paths) {
  const std::uint32_t mask = bucketCount(paths.size()) - 1;
  std::ranges::stable_sort(paths, {}, [&](const std::string& path) { return hashOf(path) & mask; });
  return paths;
}

}  // namespace orris
