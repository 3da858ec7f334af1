// Another program as a step of ours: fed with a text, its output taken, never through a shell.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace orris {

struct ChildResult {
  bool missing = false;           ///< there is no such program
  std::optional<int> exitStatus;  ///< nullopt: killed, or stopped after `longest`
  std::string output, errors;
  bool succeeded() const { return exitStatus == 0; }
};

/// Runs `arguments[0]`, looked for in PATH, with `input` on its standard input. nullopt when no
/// temporary files can be made. `prepare` is called in the new process, before it becomes the program; for it
/// this one must have no other thread.
std::optional<ChildResult> runChild(const std::vector<std::string>& arguments, const std::string& input,
                                    std::chrono::seconds longest, const std::function<void()>& prepare = {});

}  // namespace orris
