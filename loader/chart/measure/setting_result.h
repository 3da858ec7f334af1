// What is known of one setting, and its text, so that a chart can be made in several runs and by
// several machines.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <orris/chart/measure/error_meter.h>
#include <orris/chart/measure/statistics.h>

namespace orris {

/// Times of one pass, milliseconds a frame: one for each visit.
struct PassTimes {
  std::string name;
  std::vector<double> times;
  bool operator==(const PassTimes&) const = default;
};

struct SettingResult {
  std::string label;
  std::string key;  ///< fingerprint of all that the numbers depend on
  std::string chosen;  ///< for options that are AUTO: "SHADOW_METHOD=MAP_PCF"; "" where none is
  std::optional<ErrorSummary> error;
  double ssim = 0;                ///< of one frame as displayed
  std::vector<TimePair> pairs;    ///< one a round
  std::vector<double> frames;     ///< milliseconds of every timed frame
  std::vector<PassTimes> passes;  ///< in frame order
  bool operator==(const SettingResult&) const = default;
};

/// JSON, one object.
std::string writeResult(const SettingResult& result);
/// nullopt when the text is no result; never throws.
std::optional<SettingResult> parseResult(const std::string& text);

}  // namespace orris
