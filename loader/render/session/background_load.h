// Loading a pack on a thread of its own, which needs no GL context: reading, preprocessing, rewriting.
#pragma once

#include <functional>
#include <future>
#include <memory>

#include <orris/pack/shader_pack.h>
#include <orris/plan/schedule/auto_choices.h>

namespace orris {

/// Loads a pack, or builds it again; may change the request, which stands for the pack from then on.
/// nullptr and diagnostics: it cannot. Runs on another thread: it owns all that it uses.
using PackLoader = std::function<std::shared_ptr<const ShaderPack>(LoadRequest&, Diagnostics&)>;

class BackgroundLoad {
 public:
  struct Result {
    std::shared_ptr<const ShaderPack> pack;  ///< nullptr where there are errors
    LoadRequest request;
    Diagnostics problems;
    /// The same pack with the choices that were guessed; nullptr without any, and where it has errors.
    std::shared_ptr<const ShaderPack> settled;
    Diagnostics settledProblems;
  };

  /// Begins at once. The destructor waits. `guess`: what options that are AUTO will probably become, so
  /// that no second load is needed where they do. `before`: a build with such choices, which lends programs
  /// that nothing of the change reaches; nullptr: none.
  BackgroundLoad(LoadRequest request, PackLoader load, AutoChoices guess,
                 std::shared_ptr<const ShaderPack> before);
  /// Waits for so many seconds at most.
  bool readyWithin(double seconds) const;
  void wait() const { result_.wait(); }
  /// Waits, too; once.
  Result take() { return result_.get(); }

 private:
  std::future<Result> result_;
};

}  // namespace orris
