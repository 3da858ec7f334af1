// A pack that draws frames, behind a handle of the C interface.
#pragma once

#include <memory>
#include <string>

#include <orris/api/context.h>
#include <orris/api/geometry.h>
#include <orris/render/session/render_session.h>

struct OrrisRenderer {
  static constexpr const char* kKind = "OrrisRenderer";
  OrrisContext* context = nullptr;
  OrrisDiagnosticCallback onDiagnostic = nullptr;
  void* user = nullptr;
  bool drawn = false;                                          ///< a frame of this size
  std::string biome, mainHand, offHand, profile, selectedOut;  ///< that were handed out
  // Of the last frame of an engine's geometry.
  orris::EyeSurroundings eye;
  orris::EngineMoment moment;
  std::string selected;  ///< as it was written
  std::unique_ptr<orris::api::SubmittedGeometry>
      geometry;  ///< of an engine; null with a world of Orris
  std::unique_ptr<orris::RenderSession> session;
};

namespace orris::api {

/// Hands the diagnostics to the engine, repetitions left out.
void report(const OrrisRenderer& renderer, Diagnostics diagnostics);

/// As it would be in a batch, but for its vertices; fails where a value cannot be.
Submitted checkedForDraw(const OrrisBatch& batch);

/// reports, and fails with ORRIS_ERROR_PACK when `succeeded` is false.
void finishLoad(OrrisRenderer& renderer, bool succeeded, const Diagnostics& diagnostics);

/// As reported by the driver since the last call.
void addGlErrors(OrrisContext& context, Diagnostics& diagnostics);

void checkSize(int width, int height);

}  // namespace orris::api
