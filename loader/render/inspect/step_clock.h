// What a step of a frame costs: time that passed, processor time, and time of a graphics card.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include <orris/gl/handle.h>

namespace orris {

struct StepTime {
  std::string name;
  double seconds = 0;           ///< that passed, with the way to the driver and back
  double processorSeconds = 0;  ///< of all threads; of a software rasteriser what the step costs
  std::optional<double> cardSeconds;  ///< between time stamps of the graphics card; a software rasteriser's say nothing
};

/// Needs one context to be current in all calls.
class StepClock {
 public:
  /// `hasCard`: the driver's time stamps are to be believed.
  explicit StepClock(bool hasCard);

  void start();
  /// Waits for the driver.
  StepTime stop(std::string name);

 private:
  std::chrono::steady_clock::time_point start_;
  double processorStart_ = 0;
  gl::Handle<gl::deleteQuery> first_, last_;  ///< none without a card
};

}  // namespace orris
