// One frame of a pack on a few blocks: what only shows when something is drawn.
#pragma once

#include <chrono>
#include <memory>

#include <orris/core/diagnostic.h>
#include <orris/core/files/file_source.h>
#include <orris/gl/context.h>
#include <orris/pack/shader_pack.h>

namespace orris {

/// Draws one small frame of worlds/everything, which holds something for each program, in
/// a process of its own that may take `time` of the processor; GL errors become diagnostics. What loading
/// reports is left out.
void checkDrawing(gl::Backend backend, const std::shared_ptr<const FileSource>& files,
                  const LoadRequest& load, std::chrono::seconds time, Diagnostics& diagnostics);

}  // namespace orris
