// Fixed-function state of one step: matrices, blending, alpha test, culling, fog.
// Contract: README "Fullscreen geometry", programs.csv default_blend and default_alpha_test.
#pragma once

#include <cstdint>

#include <orris/plan/frame/frame_state.h>
#include <orris/plan/schedule/schedule.h>
#include <orris/plan/frame/uniforms.h>

namespace orris {

/// State for a fullscreen program.
void setFullscreenState(const ProgramSource* program, DrawState& draw);
/// State for geometry; `program` null: the built-in shader. Fills blend and alpha facts of `draw`.
void setGeometryState(const Step& step, const ProgramSource* program, DrawState& draw);
/// The matrices of `draw` and those of the light's texture coordinates: GL's own, which compatibility
/// shaders read. In a core context uniforms hold them (plan/frame/core_profile_uniforms.h).
void loadMatrices(DrawState& draw, bool lightmapMatrix);
void loadModelView(const glm::mat4& modelView);
/// GL's own fog for what is drawn in an MC_RENDER_STAGE_* (plan/frame/fog.h).
void setFog(const FrameState& state, int renderStage);
void unsetAlphaTest();
/// Buffers of the step for which the program has no output stay as they are: GL leaves open what they get, and a software
/// rasteriser blends with whatever was there. `outputs`: outputsOf().
void maskBuffers(const Step& step, std::uint32_t outputs);
void unmaskBuffers(const Step& step, std::uint32_t outputs);

/// The projection of fullscreen programs: the 0..1 quad to clip space, z row zero.
glm::mat4 fullscreenProjection();
/// Value of MC_RENDER_STAGE_* for what a step draws.
int renderStageOf(Geometry geometry);

}  // namespace orris
