#include <orris/check/compile/stage_files.h>

#include <algorithm>
#include <string_view>

#include <orris/pack/files/text.h>

namespace orris {
namespace {

bool holdsOnlyDirectives(DefinitionIndex& index, const std::string& file) {
  const auto lines = index.files().find(file);
  return lines == index.files().end() ||
         std::ranges::all_of(lines->second, [](const std::string& line) {
           const std::string_view text = trim(line);
           return text.empty() || text[0] == '#' || text.starts_with("//");
         });
}

}  // namespace

std::vector<std::string> filesOf(DefinitionIndex& index, const StageText& stage, std::size_t last) {
  const std::vector<IncludeSite>& sites = stage.text.sites;
  const auto& lines = stage.text.lines;
  std::vector<bool> active(sites.size(), false);
  for (std::size_t i = 0; i < (last > 0 ? std::min(last, lines.size()) : lines.size()); ++i) {
    for (const MappedText::Segment& segment : lines[i]) {
      for (int site = segment.origin.site; site >= 0 && !active[std::size_t(site)];
           site = sites[std::size_t(site)].parent)
        active[std::size_t(site)] = true;
    }
  }
  std::vector<std::string> files;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    if (i == 0 || active[i] || holdsOnlyDirectives(index, sites[i].file))
      files.push_back(sites[i].file);
  }
  return files;
}

std::size_t lineOf(const StageText& stage, const SourceLocation& at) {
  const auto& lines = stage.text.lines;
  const auto comesFrom = [&](const MappedText::Segment& segment) {
    const int site = segment.origin.site;
    return site >= 0 && segment.origin.line == at.line &&
           stage.text.sites[std::size_t(site)].file == at.file;
  };
  const auto found = std::ranges::find_if(
      lines, [&](const auto& line) { return std::ranges::any_of(line, comesFrom); });
  return found == lines.end() ? 0 : std::size_t(found - lines.begin()) + 1;
}

}  // namespace orris
