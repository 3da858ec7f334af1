// What the program was doing when it ran out of memory: the message of last resort names it.
#pragma once

#include <exception>
#include <string>
#include <string_view>

namespace orris {

/// Lives as long as one piece of work on one file. The innermost one that an exception leaves is kept.
class WorkStage {
 public:
  /// "reading", "/composite.fsh".
  WorkStage(std::string_view doing, std::string_view file)
      : doing_(doing), file_(file), exceptions_(std::uncaught_exceptions()) {}
  ~WorkStage();
  WorkStage(const WorkStage&) = delete;
  WorkStage& operator=(const WorkStage&) = delete;

  /// "while reading /composite.fsh", or "" when no exception left a stage.
  static std::string whereFailed();

 private:
  std::string_view doing_, file_;
  int exceptions_;
};

}  // namespace orris
