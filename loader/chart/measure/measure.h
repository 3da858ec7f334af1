// Error and cost of many settings: each drawn long enough to have settled, then all in turns.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <orris/chart/measure/reference_picture.h>
#include <orris/chart/measure/setting_result.h>
#include <orris/chart/measure/setting_session.h>

namespace orris {

struct MeasurePlan {
  int warmUp = 180;  ///< frames before the first that counts
  int frames = 64;   ///< whose error is measured
  int rounds = 30;   ///< pairs of times
  int visit = 6;     ///< frames in a row, twice a round
  FrameClock clock = FrameClock::Wall;
  std::string buffer;      ///< "" for the screen
  std::size_t alive = 64;  ///< settings kept loaded at the same time, the baseline not counted
};

/// One setting on its way. The owner fills in all but what is measured.
struct SettingJob {
  SessionRequest request;
  const ReferencePicture* reference = nullptr;  ///< nullptr: only the cost is wanted
  float exposure = 1;                           ///< of the reference, for SSIM
  SettingResult result;                         ///< what is known already is not measured again
  bool errorDone() const { return reference == nullptr || result.error.has_value(); }
  bool done(const MeasurePlan& plan) const {
    return errorDone() && int(result.pairs.size()) >= plan.rounds;
  }
};

/// What the owner wants to know while it goes on.
struct MeasureHooks {
  std::function<void(int frames)> drew;
  std::function<void(const SettingJob&)> changed;  ///< something more is known: worth keeping
  /// The error of a setting is known: its last frame and the mean of all.
  std::function<void(const SettingJob&, const ImageF& frame, const ImageF& mean)> pictures;
};

/// Frames that are left to draw, about.
int framesLeft(const std::vector<SettingJob*>& jobs, const MeasurePlan& plan);

class Measuring {
 public:
  using Clock = std::chrono::steady_clock;

  /// All must outlive this. `end`: when to stop; nullopt: when all is done.
  Measuring(gl::Context& context, const World& world, const MeasurePlan& plan,
            const MeasureHooks& hooks, std::optional<Clock::time_point> end);

  /// Measures what the jobs lack, each beside the first of them, the baseline, in groups that fit
  /// into memory. Errors of one setting end it, not the others; they are in diagnostics.
  void run(const std::vector<SettingJob*>& jobs, Diagnostics& diagnostics);

  /// Mean and halves of `frames` frames of a setting, drawn after those that errors are measured on, so
  /// that the same noise is not on both sides. nullopt: see diagnostics, or the time was over.
  std::optional<ReferencePicture> drawReference(const SessionRequest& request, int frames,
                                                Diagnostics& diagnostics);

 private:
  struct Member {
    SettingJob* job;
    std::unique_ptr<SettingSession> session;
  };
  using Group = std::vector<Member>;
  bool timeLeft() const;
  void beginErrors(std::size_t groupsLeft);
  bool draw(SettingSession& session, int frames, Diagnostics& diagnostics);
  std::unique_ptr<SettingSession> openSettled(const SessionRequest& request,
                                              Diagnostics& diagnostics);
  bool measureError(Member& member, Diagnostics& diagnostics);
  std::size_t fillGroup(Group& group, const std::vector<SettingJob*>& jobs, std::size_t next,
                        Diagnostics& diagnostics);
  void measureTimes(Group& group, Diagnostics& diagnostics);
  void round(Group& group, Diagnostics& diagnostics);

  gl::Context& context_;
  const World& world_;
  const MeasurePlan& plan_;
  const MeasureHooks& hooks_;
  std::optional<Clock::time_point> end_, errorsEnd_;
};

}  // namespace orris
