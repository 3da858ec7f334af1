#include <orris/pack/files/extended_graph.h>

#include <algorithm>

namespace orris {

ExtendedGraph::ExtendedGraph(const FolderBuild& build, const AddedLine& added) : build_(build) {
  const PackFiles& files = build.files();
  const FileLines* before = build.lines(added.file);
  if (!before || added.line < 1 || static_cast<std::size_t>(added.line) > before->size() + 1)
    return;
  graph_.includes = files.graph.includes;
  if (!added.target.empty() && !reach(added)) return;
  file_ = added.file;
  lines_ = *before;
  lines_.insert(lines_.begin() + (added.line - 1), added.text);
  std::map<int, std::string> moved;
  for (auto& [line, target] : graph_.includes[file_])
    moved[line >= added.line ? line + 1 : line] = std::move(target);
  if (!added.target.empty()) moved[added.line] = added.target;
  graph_.includes[file_] = std::move(moved);
}

bool ExtendedGraph::reach(const AddedLine& added) {
  const PackFiles& files = build_.files();
  if (!files.graph.files.contains(added.target)) {
    Diagnostics ignored;  // of a file that nothing includes yet
    more_ = readIncludeGraph(*files.source, {added.target}, ignored);
    graph_.includes.merge(more_.includes);
  }
  const auto reached = reachableFiles(graph_, added.target);
  return std::ranges::find(reached, added.file) == reached.end();
}

const FileLines* ExtendedGraph::lines(const std::string& file) const {
  if (file == file_) return &lines_;
  if (const FileLines* known = build_.lines(file)) return known;
  const auto found = more_.files.find(file);
  return found == more_.files.end() ? nullptr : &found->second;
}

}  // namespace orris
