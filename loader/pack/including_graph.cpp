#include "pack/including_graph.h"

#include <algorithm>

namespace orris {

IncludingGraph::IncludingGraph(const FolderBuild& build, const AddedInclude& added)
    : build_(build) {
  const PackFiles& files = build.files();
  const FileLines* before = build.lines(added.file);
  if (!before || added.line < 1 || static_cast<std::size_t>(added.line) > before->size() + 1)
    return;
  graph_.includes = files.graph.includes;
  if (!files.graph.files.contains(added.target)) {
    Diagnostics ignored;  // of a file that nothing includes yet
    more_ = readIncludeGraph(*files.source, {added.target}, ignored);
    graph_.includes.merge(more_.includes);
  }
  const auto reached = reachableFiles(graph_, added.target);
  if (std::ranges::find(reached, added.file) != reached.end()) return;
  file_ = added.file;
  lines_ = *before;
  lines_.insert(lines_.begin() + (added.line - 1), "");
  std::map<int, std::string> moved;
  for (auto& [line, target] : graph_.includes[file_])
    moved[line >= added.line ? line + 1 : line] = std::move(target);
  moved[added.line] = added.target;
  graph_.includes[file_] = std::move(moved);
}

const FileLines* IncludingGraph::lines(const std::string& file) const {
  if (file == file_) return &lines_;
  if (const FileLines* known = build_.lines(file)) return known;
  const auto found = more_.files.find(file);
  return found == more_.files.end() ? nullptr : &found->second;
}

}  // namespace orris
