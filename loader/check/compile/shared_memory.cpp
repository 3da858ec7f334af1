#include <orris/check/compile/shared_memory.h>

#include <algorithm>

#include <orris/check/interface/glsl_types.h>

namespace orris {
namespace {

struct Layout {
  std::int64_t size = 0;
  std::int64_t align = 4;
};
constexpr int kDeepest = 16;
constexpr std::int64_t kLargest = std::int64_t{1} << 40;

std::int64_t roundUp(std::int64_t value, std::int64_t align) {
  return (value + align - 1) / align * align;
}

Layout vectorLayout(std::int64_t scalar, int rows) {
  return {scalar * rows, scalar * (rows == 3 ? 4 : rows)};
}

Layout repeat(const Layout& element, std::int64_t count) {
  return {roundUp(element.size, element.align) * (count - 1) + element.size, element.align};
}

std::optional<Layout> layoutOf(const StageInterface& stage, std::string_view type,
                               const std::vector<std::int64_t>& sizes, int depth);

std::optional<Layout> structLayout(const StageInterface& stage, const StructType& type, int depth) {
  Layout whole;
  for (std::size_t i = 0; i < type.members.size(); ++i) {
    const auto member = layoutOf(stage, type.members[i].type, type.memberSizes[i], depth + 1);
    if (!member) return std::nullopt;
    whole.size = roundUp(whole.size, member->align) + member->size;
    whole.align = std::max(whole.align, member->align);
  }
  whole.size = roundUp(whole.size, whole.align);
  return whole;
}

std::optional<Layout> layoutOf(const StageInterface& stage, std::string_view type,
                               const std::vector<std::int64_t>& sizes, int depth) {
  if (depth > kDeepest) return std::nullopt;
  std::optional<Layout> layout;
  const NumericType numeric = numericType(type);
  if (numeric.component != 0) {
    layout = vectorLayout(numeric.component == 'd' ? 8 : 4, numeric.rows);
    if (numeric.columns > 1) layout = repeat(*layout, numeric.columns);
  } else {
    const auto known = std::find_if(stage.structs.begin(), stage.structs.end(),
                                    [&](const StructType& s) { return s.name == type; });
    if (known != stage.structs.end()) layout = structLayout(stage, *known, depth);
  }
  for (auto size = sizes.rbegin(); layout && size != sizes.rend(); ++size) {
    if (*size <= 0) return std::nullopt;
    if (layout->size > kLargest / *size) return std::nullopt;
    layout = repeat(*layout, *size);
  }
  return layout;
}

}  // namespace

std::optional<std::int64_t> sharedMemoryBytes(const StageInterface& stage) {
  std::int64_t bytes = 0;
  for (const StageGlobal& global : stage.globals) {
    if (global.storage != StageGlobal::Storage::Shared || !global.used) continue;
    const auto layout = layoutOf(stage, global.type, global.arraySizes, 0);
    if (!layout) return std::nullopt;
    bytes = roundUp(bytes, layout->align) + layout->size;
    if (bytes > kLargest) return bytes;
  }
  return bytes;
}

}  // namespace orris
