// From a failing configuration to what it fails for: a minimal set of option values, and the values
// of the other options that it needs.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <orris/pack/options/options.h>

namespace orris {

/// An option and the values with which the failure occurs, all else as in the minimal failure.
struct Condition {
  std::string option;
  std::vector<std::string> values;  ///< in the author's order
  std::vector<std::string> others;  ///< tried and good
};

struct Cause {
  std::vector<Condition> conditions;  ///< of options set away from their default first
  bool complete = true;               ///< false: not every option could be tried
};

/// What a try gave. Another failure may hide the one that is looked for, so it says nothing.
enum class Trial { Good, Fails, FailsOtherwise };

/// Does the failure occur with these values (those that differ from the defaults)?
using FailsWith = std::function<Trial(const OptionValues& values)>;

/// The smallest part of `values` with which it still fails, by delta debugging: taking away any one
/// value makes it good. Asks at most `tries` times and lowers the number.
OptionValues minimalValues(const OptionValues& values, const FailsWith& fails, int& tries);

/// Which values of the options in `minimal`, and of those in `others`, the failure needs. Each is
/// changed alone.
Cause findCause(const OptionSet& options, const OptionValues& minimal,
                const std::vector<std::string>& others, const FailsWith& fails, int tries);

/// "INDIRECT=GTAO and WATER=false", "QUALITY is 2 or 3".
std::string describe(const Cause& cause, const OptionSet& options);

}  // namespace orris
