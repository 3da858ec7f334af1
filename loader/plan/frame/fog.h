// The game's fog, which packs read and draw themselves: FogRenderer of Minecraft 1.21.1.
#pragma once

#include <orris/plan/frame/frame_state.h>

namespace orris {

/// Blocks from the eye; where linear fog begins and where nothing else is seen.
struct FogRange {
  float start = 0, end = 0;
};
/// `renderStage` is an MC_RENDER_STAGE_*: the sky has a fog of its own, from the eye on, and the stars have none, which
/// the game makes a start farther than anything.
FogRange fogRangeOf(const FrameState& state, int renderStage);

/// What it is in: of the air `environment.fogColor` as daylight leaves it, of fluids their own; brighter with night vision
/// and for an eye that is used to the water, black with blindness and darkness.
glm::vec3 fogColorOf(const FrameState& state);

/// Fog is linear (0), but exponential in water (Iris: MixinFogRenderer).
float fogDensityOf(const FrameState& state);
/// 0 sphere, 1 cylinder: near and thick fog lies around the eye, that of the distance around its vertical axis.
int fogShapeOf(const FrameState& state);

}  // namespace orris
