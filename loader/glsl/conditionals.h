// The stack of open #if blocks.
#pragma once

#include <string>
#include <vector>

#include "glsl/source_map.h"

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
  std::string close();

  struct Open {
    Origin at;
    std::string directive;
    bool parentActive = true;
    bool active = true;
    bool taken = true;
    bool sawElse = false;
  };
  const std::vector<Open>& unclosed() const { return stack_; }

 private:
  std::vector<Open> stack_;
};

}  // namespace orris
