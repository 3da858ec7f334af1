// The pack that a window runs: loading it again, its option values, and its option file.
#pragma once

#include <chrono>
#include <deque>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/input/common.h"
#include "app/output/report.h"
#include "app/view/apart/kept_pack.h"
#include <orris/gl/context.h>
#include <orris/render/session/render_session.h>

namespace orris {

/// What the last attempt to load or change the pack did.
struct LoadOutcome {
  std::string cause;
  bool succeeded = true;
  double seconds = 0;  ///< reading, preparing and compiling, with the frames in between
  int frames = 0;            ///< drawn meanwhile
  double longestFrame = 0;   ///< of these, seconds from one to the next
  LoadReport report;
  Diagnostics problems;  ///< errors and warnings
};

/// The pack's own, beside it and named like it, unless the command line names another one.
std::string optionFileOf(const PackOptions& options);

/// Changes are begun here and go on while frames are drawn; one asked for while another is in progress waits
/// for it.
class LivePack {
 public:
  /// All three must outlive it.
  LivePack(const PackOptions& options, gl::Context& context, Report& report);

  /// The first load; of `kept`, where a process died of a later one. false: reported.
  bool open(const SceneOptions& scene, const ImageOptions& image, World world,
            const Camera& camera, const std::optional<KeptState>& kept = {});
  /// The process before this one died of an attempt.
  void noteDeath(const Diagnostic& cause);

  RenderSession& session() { return *session_; }
  const RenderSession& session() const { return *session_; }
  /// From its files; `withOptionFile`: values of the option file as it is then, too.
  void reload(const std::string& cause, bool withOptionFile);
  /// Profiles in the pack's order, where it has some.
  void nextProfile();
  void setProfile(const std::string& name);
  /// Chosen by hand: takes the place of profile, option file and command line, and is saved to the
  /// option file once it runs. An empty value takes the option back to its default.
  void setOptions(const std::string& cause, const OptionValues& changes);
  /// These values and no others.
  void chooseValues(const std::string& cause, const OptionValues& values);
  void resetOptions() { chooseValues("all options reset", {}); }
  /// The values of a profile over those in force, saved like others chosen by hand.
  void chooseProfile(const std::string& name);
  /// Builds the programs with exactly these options as uniforms; another change than of their values
  /// ends that.
  void setLive(const std::set<std::string>& names);
  /// A value for the next frames, not saved: the option becomes live first where it is not yet.
  void drag(const std::string& name, const std::string& value);
  /// Why each option cannot be live, "" for those that can; nullptr while a thread finds that out, unless
  /// `wait`.
  const std::map<std::string, std::string>* liveReasons(bool wait);

  /// Between frames: works for about so many seconds at what was begun. true: an attempt ended, see
  /// outcome(). `passed`: seconds since the last call.
  bool advance(double seconds, double passed);
  /// Waits for the next attempt to end; false: there is none.
  bool finish();
  /// What is being done ("tint.glsl changed"), "" for nothing.
  std::string doing() const;

  /// Non-default values in force, as asked for.
  const OptionValues& values() const { return session_->asked().values; }
  const std::string& optionFile() const { return optionFile_; }
  const LoadOutcome& outcome() const { return outcome_; }
  /// Did this object write the option file since the last call? Then its change is no news.
  bool takeSaved() { return std::exchange(saved_, false); }

 private:
  using Clock = std::chrono::steady_clock;
  /// `loader` is asked when the attempt begins, for what is in force then.
  struct Attempt {
    std::string cause;
    std::function<PackLoader()> loader;
    bool saves = false;
    std::string drags{};  ///< an option that becomes live because it is dragged
    Clock::time_point begun{};
    int frames = 0;
    double longestFrame = 0;
  };

  std::shared_ptr<const FileSource> openKept(const KeptState& kept);
  PackOptions optionsNow() const;
  PackLoader readingAgain(bool withOptionFile) const;
  PackLoader withValues(const OptionValues& values) const;
  PackLoader withLive(const std::set<std::string>& names) const;
  void begin();
  bool end(std::optional<bool> succeeded, Diagnostics diagnostics);
  void save();

  const PackOptions& options_;
  gl::Context& context_;
  Report& report_;
  std::string optionFile_;
  std::unique_ptr<RenderSession> session_;
  std::deque<Attempt> attempts_;  ///< the first is in progress
  std::size_t loadsBefore_ = 0;   ///< of the session, when it began
  LoadOutcome outcome_;
  bool saved_ = false;
  OptionValues dragged_;  ///< values that are not those of the pack
  struct LiveFacts {
    std::shared_ptr<const ShaderPack> pack;  ///< they are of this one
    std::future<std::map<std::string, std::string>> coming;
    std::map<std::string, std::string> reasons;
  };
  LiveFacts live_;
};

}  // namespace orris
