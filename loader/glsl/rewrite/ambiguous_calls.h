// Calls of built-in functions that a driver takes to be ambiguous: rule ambiguous-calls.
#pragma once

#include <optional>
#include <string>

#include <orris/glsl/compile/validate.h>

namespace orris {

inline constexpr const char* kAmbiguousCallsRule = "ambiguous-calls";

/// The text with functions of the host for the built-in ones that `log`, of the driver's compiler, calls ambiguous: these
/// have no variant of doubles, so that an int beside floats can only become a float, as GLSL 4.00 has it (section 4.1.10).
/// For NVIDIA's driver (580.159), which refuses clamp(int, float, float). nullopt: the log names no such function, or none
/// that the rule knows.
std::optional<StageText> settleAmbiguousCalls(const StageText& stage, const std::string& log);

}  // namespace orris
