// The text between two conditionals of a file, and what of it could be a branch: where an #if or #endif
// that is missing may have stood.
#pragma once

#include <map>
#include <string_view>
#include <utility>
#include <vector>

namespace orris {

/// What of the text since the last conditional can be a branch. Lines of a file, 0: nothing can.
struct BranchRoom {
  int ends = 0;              ///< the end of one that begins at that conditional
  int begins = 0;            ///< the start of one that ends here
  bool blankBefore = false;  ///< the last line is blank
  int shallowest = 0;        ///< least depth of braces since that conditional
  std::vector<std::pair<int, int>> paragraphs{};  ///< first and last line of each
};

/// Follows the lines of one file. A branch begins and ends at one depth of braces, and where nothing
/// else is known it is a paragraph.
class BranchText {
 public:
  /// A line of code or comment; `code` is without comments.
  void addLine(std::string_view code, bool blank, int line);
  /// A directive that is no conditional.
  void addDirective(int line);
  void addConditional(int line);

  int depth() const { return depth_; }
  BranchRoom room() const;

 private:
  void addCharacter(char c);
  void endLine(int line);

  int depth_ = 0, start_ = 0, shallowest_ = 0;
  int first_ = 0, ends_ = 0, paragraph_ = 0;
  int texts_ = 0;
  std::vector<std::pair<int, int>> paragraphs_;
  bool wasBlank_ = false, ended_ = false;
  std::map<int, int> textsBefore_ = {{0, 0}};  ///< the first place of each depth that still goes on
};

}  // namespace orris
