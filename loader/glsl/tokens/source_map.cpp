#include <orris/glsl/tokens/source_map.h>

#include <algorithm>

namespace orris {
namespace {

const MappedText::Segment* segmentAt(const MappedText& text, int line, int column) {
  if (line < 1 || static_cast<std::size_t>(line) > text.lines.size()) return nullptr;
  const auto& segments = text.lines[static_cast<std::size_t>(line) - 1];
  if (segments.empty()) return nullptr;
  auto after = std::upper_bound(
      segments.begin(), segments.end(), column,
      [](int wanted, const MappedText::Segment& segment) { return wanted < segment.column; });
  return after == segments.begin() ? &segments.front() : &*(after - 1);
}

}  // namespace

SourceLocation locate(const std::vector<IncludeSite>& sites, const Origin& origin) {
  if (origin.site < 0 || static_cast<std::size_t>(origin.site) >= sites.size()) return {};
  return {sites[static_cast<std::size_t>(origin.site)].file, origin.line, origin.column};
}

std::vector<SourceLocation> includedFrom(const std::vector<IncludeSite>& sites, int site) {
  std::vector<SourceLocation> chain;
  // A parent always precedes its child, so a malformed table cannot make this loop for ever.
  while (site >= 0 && static_cast<std::size_t>(site) < sites.size()) {
    const IncludeSite& child = sites[static_cast<std::size_t>(site)];
    if (child.parent < 0 || child.parent >= site) break;
    chain.push_back({sites[static_cast<std::size_t>(child.parent)].file, child.parentLine, 0});
    site = child.parent;
  }
  return chain;
}

SourceLocation MappedText::locate(int line, int column) const {
  const Segment* segment = segmentAt(*this, line, column);
  return segment ? orris::locate(sites, segment->origin) : SourceLocation{};
}

std::vector<SourceLocation> MappedText::includedFrom(int line, int column) const {
  const Segment* segment = segmentAt(*this, line, column);
  return segment ? orris::includedFrom(sites, segment->origin.site) : std::vector<SourceLocation>{};
}

int MappedText::macroIndexAt(int line, int column) const {
  const Segment* segment = segmentAt(*this, line, column);
  if (!segment || segment->macro < 0) return -1;
  return static_cast<std::size_t>(segment->macro) < macroNames.size() ? segment->macro : -1;
}

SourceLocation MappedText::locateInMacro(int line, int column) const {
  const Segment* segment = segmentAt(*this, line, column);
  return segment && segment->macro >= 0 ? orris::locate(sites, segment->written) : SourceLocation{};
}

std::string_view MappedText::macroAt(int line, int column) const {
  const int index = macroIndexAt(line, column);
  return index < 0 ? std::string_view() : macroNames[static_cast<std::size_t>(index)];
}

}  // namespace orris
