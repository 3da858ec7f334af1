// A command that draws with a stranger's programs runs in a process of its own, which another one watches:
// when the driver dies or does not come back, that is a message and no end of the command without a word.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "app/drawing/output_broker.h"
#include "app/output/report.h"
#include <orris/gl/context.h>

namespace CLI {
class App;
}

namespace orris {

/// What the process that draws may take.
struct WorkLimits {
  std::string frameTime = "300s";  ///< for one frame, one program, or loading
  std::string memory;              ///< "8G"; "": driverMemory()
};
void addLimitFlags(CLI::App& command, WorkLimits& limits);
std::chrono::seconds frameTimeOf(const WorkLimits& limits);

/// "512M", "8G" in bytes; nullopt for other texts and for less than 64M.
std::optional<std::size_t> parseMemory(const std::string& text);

struct SupervisedWork {
  WorkLimits limits;
  gl::Backend backend = gl::Backend::Auto;
  std::string pack{};  ///< its path, to which messages point until a pass or program is at work
  AllowedOutputs outputs{};
  /// In a sandbox from confineDrawing() on, where the driver is a software rasteriser: for work that starts
  /// no program and writes nothing but `outputs`.
  bool confined = false;
};

/// Runs `work` in a process of its own. It returns in that process, with what `work` returned. In the process
/// that watches it returns only when the other one ended without saying why: reported, kHostFailed; else it
/// ends the program with the other's status. A signal that ends the program ends both at once.
int runSupervised(const SupervisedWork& supervised, Report& report, const std::function<int()>& work);

/// For `work`, before it makes a context: from now on outputs go through the process that watches, and all
/// else that a sandbox refuses is refused. Nothing happens unless SupervisedWork::confined.
void confineDrawing();

}  // namespace orris
