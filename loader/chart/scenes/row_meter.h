// Measures settings on one scene: independent runs for their bias, turns for their cost.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <orris/chart/measure/reference_picture.h>
#include <orris/chart/measure/setting_session.h>
#include <orris/chart/scenes/scene_row.h>

namespace orris {

struct RowPlan {
  int runs = 4;      ///< three at least
  int warmUp = 180;  ///< frames of a run before the first that counts
  int frames = 64;   ///< of a run that are judged
  int rounds = 30;   ///< pairs of times; 0: neither costs nor lag
  int visit = 6;     ///< frames in a row, twice a round
  FrameClock clock = FrameClock::Processor;
  std::string buffer;  ///< "" for the screen
  unsigned seed = 0;   ///< the runs' random numbers follow from it
};

class RowMeter {
 public:
  /// All must outlive this. The world's events are left out.
  RowMeter(gl::Context& context, const World& world, const ReferencePicture& reference, const RowPlan& plan)
      : context_(context), world_(world), reference_(reference), plan_(plan) {}

  /// All but the costs, which are 0; a lag of -1 where costs are not asked for. nullopt: see diagnostics.
  std::optional<SceneRow> row(const SessionRequest& request, const std::string& setting, Diagnostics& diagnostics);
  /// Fills in the costs of rows beside the first; `requests` are theirs. false: see diagnostics.
  bool addCosts(const std::vector<SessionRequest>& requests, std::vector<SceneRow>& rows, Diagnostics& diagnostics);

 private:
  class Sums;
  bool run(SessionRequest request, int number, Sums& sums, SceneRow& row, Diagnostics& diagnostics);
  bool addCosts(const std::vector<SessionRequest>& requests, const World& world, PairedCost SceneRow::*cost,
                std::vector<SceneRow>& rows, Diagnostics& diagnostics);

  gl::Context& context_;
  const World& world_;
  const ReferencePicture& reference_;
  const RowPlan& plan_;
};

}  // namespace orris
