// The stack of open #if blocks.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include <orris/glsl/tokens/source_map.h>

namespace orris {

class Conditionals {
 public:
  /// Is text at this point in an active branch?
  bool active() const { return stack_.empty() || stack_.back().active; }
  /// Must the condition of an #elif here be evaluated?
  bool wantsElif() const {
    return !stack_.empty() && stack_.back().parentActive && !stack_.back().taken &&
           !stack_.back().sawElse;
  }

  void open(const Origin& at, const std::string& directive, bool condition);
  /// The following return what is wrong, "" when nothing is.
  std::string elif (bool condition);
  std::string otherwise();
  std::string close(const Origin& at);

  struct Open {
    Origin at;
    std::string directive;
    bool parentActive = true;
    bool active = true;
    bool taken = true;
    bool sawElse = false;
    bool firstOfFile = false;
    std::size_t closedBefore = 0;  ///< how many blocks had been closed when it was opened
  };

  /// The blocks that most likely lack their #endif. The innermost open #if only is what remains: an
  /// #endif in another file, or further left than its #if, was meant for another one, and so was the
  /// last one of a file that begins with an include guard.
  std::vector<Open> unclosed() const;

  /// The #endif that most likely lacks its #if, when the one at `at` has none left.
  Origin strayClose(const Origin& at) const;

 private:
  struct Closed {
    Open open;
    Origin close;
  };
  Open meantBy(const Open& open) const;

  std::vector<Open> stack_;
  std::vector<Closed> closed_;
  std::set<int> sites_;  ///< with a conditional
};

}  // namespace orris
