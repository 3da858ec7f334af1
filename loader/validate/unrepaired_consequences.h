// Consequences that need no second check: found by names and places that findings share.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>

#include <orris/report/problem_list.h>
#include <orris/validate/validate_pack.h>

namespace orris {

/// The findings of a pack while they are folded under each other.
class Folds {
 public:
  Folds(const PackVerdict& verdict, ProblemList& problems) : verdict_(verdict), problems_(problems) {}

  const Diagnostics& all() const { return problems_.all(); }
  /// Follows from nothing yet, and is one that a second check would meet.
  bool isOpen(std::size_t i) const;
  /// A mistake that errors follow from is an error.
  void fold(std::size_t i, std::size_t cause);
  /// Names another place of a problem.
  void relate(std::size_t i, RelatedPlace place) { problems_.relate(i, std::move(place)); }
  /// All files that a program file reads, itself among them.
  const std::set<std::string>& filesOf(const std::string& entry);
  /// What its first #include names, "" for none.
  std::string firstIncludeOf(const std::string& entry) const;
  /// Is the problem met only in programs that read `file` in one of their stages?
  bool isOfProgramsWith(const std::string& file, std::size_t i);

 private:
  const PackVerdict& verdict_;
  ProblemList& problems_;
  std::map<std::string, std::set<std::string>> files_;
};

/// The same said of one line as an error and as a warning, and of one comment by several programs; what a
/// macro's call without its end takes along.
void foldTwins(Folds& folds);
/// What follows from files, custom uniforms and other names that are not there or of another type.
void foldByNames(Folds& folds, const FileSource& files);

}  // namespace orris
