// Which render targets a list of steps needs, and how each is made. The second half of buildSchedule.
#pragma once

#include <cstdint>
#include <vector>

#include <orris/plan/schedule/program_uses.h>
#include <orris/plan/schedule/schedule.h>

namespace orris {

/// Buffers that some step of the frame flips, one bit each.
struct FlippedBuffers {
  std::uint32_t color = 0, shadowColor = 0;
};

bool isShadowGroup(ProgramGroup group);

/// Fills targets, copies, programs and sizes of `schedule` from its steps; `uses` is by program.
/// `shadow`: the frame has a shadow pass. Draw buffers of unequal size are diagnostics.
void planTargets(const ShaderPack& pack, const std::vector<ProgramUses>& uses, bool shadow,
                 const FlippedBuffers& flipped, Schedule& schedule, Diagnostics& diagnostics);

}  // namespace orris
