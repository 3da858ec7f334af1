// The pack that a window runs: loading it again, its option values, and its option file.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/input/common.h"
#include "app/report/report.h"
#include "gl/context.h"
#include "render/render_session.h"

namespace orris {

/// What the last attempt to load or change the pack did.
struct LoadOutcome {
  std::string cause;
  bool succeeded = true;
  double seconds = 0;  ///< reading, preparing and compiling
  LoadReport report;
  Diagnostics problems;  ///< errors and warnings
};

class LivePack {
 public:
  /// All three must outlive it.
  LivePack(const PackOptions& options, gl::Context& context, Report& report);

  /// The first load. false: reported.
  bool open(const SceneOptions& scene, const ImageOptions& image, World world,
            const Camera& camera);

  RenderSession& session() { return *session_; }
  const RenderSession& session() const { return *session_; }
  /// From its files; `withOptionFile`: values of the option file as it is now, too.
  bool reload(const std::string& cause, bool withOptionFile);
  /// Profiles in the pack's order; false: it has none, or the load failed.
  bool nextProfile();
  bool setProfile(const std::string& name);
  /// Chosen by hand: takes the place of profile, option file and command line, and is saved to the
  /// option file once it runs. An empty value takes the option back to its default.
  bool setOptions(const std::string& cause, const OptionValues& changes);
  bool resetOptions();
  /// The values of a profile over those in force, saved like others chosen by hand.
  bool chooseProfile(const std::string& name);

  /// Non-default values in force, as asked for.
  const OptionValues& values() const { return session_->asked().values; }
  const std::string& optionFile() const { return optionFile_; }
  const LoadOutcome& outcome() const { return outcome_; }
  /// Did this object write the option file since the last call? Then its change is no news.
  bool takeSaved() { return std::exchange(saved_, false); }

 private:
  std::optional<LoadRequest> readChoices(bool withOptionFile);
  template <class Change>
  bool attempt(const std::string& cause, const Change& change);
  bool choose(const std::string& cause, const OptionValues& values);
  void save();

  const PackOptions& options_;
  gl::Context& context_;
  Report& report_;
  std::string optionFile_;
  std::unique_ptr<RenderSession> session_;
  LoadOutcome outcome_;
  bool saved_ = false;
};

}  // namespace orris
