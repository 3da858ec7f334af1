// A command that draws with a stranger's programs runs in a process of its own, which another one watches:
// when the driver dies or does not come back, that is a message and no end of the command without a word.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/drawing/file_broker.h"
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

/// What the process that watches does besides.
class Attendant {
 public:
  virtual ~Attendant() = default;
  /// When there is something to be read, and every few milliseconds. A status: the other process is ended, and
  /// runSupervised() returns it.
  virtual std::optional<int> attend() = 0;
  /// Has something to be read when there is more to do.
  virtual int descriptor() const = 0;
};

struct SupervisedWork {
  WorkLimits limits;
  gl::Backend backend = gl::Backend::Auto;
  bool software = false;  ///< `work` will see to it that `backend` is a software rasteriser
  std::string pack{};  ///< its path, to which messages point until a pass or program is at work
  AllowedFiles files{};
  /// In a sandbox from confineDrawing() on, where the driver is a software rasteriser: for work that starts
  /// no program and writes nothing but the outputs of `files`.
  bool confined = false;
  /// Of work with a window of the process that watches; nullptr: it has none.
  Attendant* attendant = nullptr;
  /// The work ends by itself when it is asked to, and may do other work before: the first signal is passed on to it.
  bool endsItself = false;
};

/// Runs `work` in a process of its own. It returns in that process, with what `work` returned. In the process
/// that watches it returns only when the other one ended without saying why: reported, kHostFailed; else it
/// ends the program with the other's status. A signal that ends the program ends both at once, unless
/// SupervisedWork::endsItself.
int runSupervised(const SupervisedWork& supervised, Report& report, const std::function<int()>& work);

/// For `work`, before it makes a context: from now on outputs go through the process that watches, and all
/// else that a sandbox refuses is refused. Of open files only `keep` stay. Nothing happens unless
/// SupervisedWork::confined.
void confineDrawing(std::vector<int> keep = {});

}  // namespace orris
