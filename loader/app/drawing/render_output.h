// What `orris render` leaves behind: pictures, buffers, sources, times.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/input/shown_buffer.h"
#include "app/output/report.h"
#include <orris/render/session/render_session.h>

namespace orris {

struct RenderOutputs {
  std::string picture;
  OptionValues dumps;   ///< buffer, or buffer@pass -> file
  OptionValues shows;   ///< buffer as parseShown() takes it -> picture or table
  std::string probe;    ///< pixel "X,Y", "" for none
  bool checkFinite = false;
  std::string timings;  ///< CSV
  std::string patched;  ///< folder
  bool allowMissing = false;  ///< programs that the driver cannot run are no error
};

/// The time of one step of one frame.
struct FrameStepTime {
  int frame = 0;
  StepTime step;
};

/// Can everything be written that is asked for? Before any work.
bool checkPaths(const RenderOutputs& outputs, Report& report);
/// Do the buffers of --dump exist? Before the first frame.
bool checkBuffers(const RenderOutputs& outputs, const FrameRenderer& renderer, Report& report);

/// Buffers after passes, by the name that --dump gives them.
using PassDumps = std::map<std::string, ImageF>;

/// What --show names: a picture of the values, a table of a bufferObject.
bool writeShown(const std::string& path, const ShownBuffer& asked, const BufferView& view,
                Report& report);

/// The picture, the buffers and the times.
bool writeOutputs(const RenderOutputs& outputs, const FrameRenderer& renderer,
                  const PassDumps& passDumps, const std::vector<FrameStepTime>& times,
                  Report& report);

/// The result for --json: driver, steps, targets, what each (re)load built.
nlohmann::json describe(RenderSession& session, const gl::DriverInfo& driver);

}  // namespace orris
