// One setting seen by several cameras as one result.
#pragma once

#include <vector>

#include <orris/chart/measure/setting_result.h>

namespace orris {

/// Costs are means over the cameras, round by round; errors the roots of mean squares; SSIM and relMSE
/// means. What one camera lacks (error, pairs) the result lacks. At least one result.
SettingResult combine(const std::vector<const SettingResult*>& cameras);

}  // namespace orris
