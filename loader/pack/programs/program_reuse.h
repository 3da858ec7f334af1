// Which programs of an earlier build of a pack a new build takes over.
#pragma once

#include <set>
#include <string>
#include <vector>

#include <orris/pack/programs/folder_build.h>
#include <orris/pack/programs/program_list.h>
#include <orris/pack/shader_pack.h>

namespace orris {

/// Those that no value that differs can change, and no file that was edited in between.
class ProgramReuse {
 public:
  /// `programs` are those of `old`; nullptr: there are none. All must outlive it.
  ProgramReuse(const FolderBuild* old, const ProgramList& programs, const FolderBuild& build);
  /// nullptr: it must be built.
  ProgramList::Pointer operator()(const ProgramEntry& entry) const;

 private:
  bool isSame(const ProgramEntry& entry, const ProgramSource& program) const;
  bool reachesEdit(const ProgramEntry& entry) const;

  const FolderBuild* old_;
  const ProgramList& programs_;
  const FolderBuild& build_;
  bool usable_ = false;
  std::vector<std::string> changed_;  ///< options, sorted
  std::set<std::string> edited_;      ///< files
};

}  // namespace orris
