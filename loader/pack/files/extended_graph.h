// The include graph of a pack as it would be with one more line.
#pragma once

#include <orris/pack/programs/folder_build.h>

namespace orris {

class ExtendedGraph {
 public:
  /// `build` must outlive it. Nothing changes when there is no such line or the file would include itself.
  ExtendedGraph(const FolderBuild& build, const AddedLine& added);

  bool changed() const { return !file_.empty(); }
  /// Edges only, without the texts.
  const IncludeGraph& graph() const { return graph_; }
  /// Lines of a file, nullptr: there is none.
  const FileLines* lines(const std::string& file) const;

 private:
  /// Makes known what the target includes; false when that includes the file.
  bool reach(const AddedLine& added);

  const FolderBuild& build_;
  IncludeGraph graph_;
  IncludeGraph more_;  ///< files that only the new line reaches
  std::string file_;   ///< the one that is changed, "" for none
  FileLines lines_;    ///< of it
};

}  // namespace orris
