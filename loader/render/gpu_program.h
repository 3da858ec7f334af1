// A linked program with its uniforms, samplers and images matched to what the host provides.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <orris/gl/buffer.h>
#include <orris/gl/program.h>
#include <orris/pack/shader_pack.h>
#include <orris/plan/schedule/program_uses.h>
#include <orris/plan/frame/uniforms.h>

namespace orris {

struct UniformBinding {
  int location = -1;
  unsigned type = 0;  ///< GL enum of the declaration
  const UniformRow* row = nullptr;
  int custom = -1;  ///< index into CustomUniforms::values()
  std::string name;
};

struct SamplerBinding {
  std::string name;
  unsigned type = 0;
  int unit = 0;
  int location = -1;
  std::optional<BufferName> buffer;
};

/// Shared memory of a compute program that lies in a storage buffer (glsl/rewrite/shared_buffer.h).
struct SharedBlock {
  unsigned binding = 0;
  std::size_t bytes = 0;  ///< of one work group
  gl::Buffer buffer;
};

/// What one GL program needs before each draw.
struct GpuProgram {
  gl::Program program;
  std::vector<UniformBinding> frameUniforms, drawUniforms;
  std::vector<SamplerBinding> samplers, images;
  std::vector<SharedBlock> sharedBlocks;
  bool patches = false;  ///< has tessellation stages
};

/// Compiles and links; driver messages of failures are mapped into `diagnostics`: errors, but a
/// warning where the program exceeds a limit of the driver. A core context gets the core text. What
/// the driver lacks and the host can do in its place is a note: rules subgroups, shared-buffer and ambiguous-calls.
GpuProgram buildGpuProgram(const std::string& label, const std::vector<const StageText*>& stages,
                           const SourceLines& lines, Diagnostics& diagnostics);

/// Matches uniforms to the table and to the custom uniforms, gives samplers and images their units.
void matchUniforms(GpuProgram& program, const CustomUniforms& custom);

/// Before a dispatch of so many work groups.
void bindSharedBlocks(GpuProgram& program, std::size_t groups);
/// The same for counts of groups that lie in a buffer; waits for them.
void bindSharedBlocks(GpuProgram& program, unsigned counts, std::size_t offset);

/// Uploads to the program in use.
void uploadUniforms(const std::vector<UniformBinding>& uniforms, const FrameState& state,
                    const DrawState& draw, const CustomUniforms& custom);

}  // namespace orris
