// A linked program with its uniforms, samplers and images matched to what the host provides.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gl/program.h"
#include "pack/shader_pack.h"
#include "plan/program_uses.h"
#include "plan/uniforms.h"

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

/// What one GL program needs before each draw.
struct GpuProgram {
  gl::Program program;
  std::vector<UniformBinding> frameUniforms, drawUniforms;
  std::vector<SamplerBinding> samplers, images;
  bool patches = false;  ///< has tessellation stages
};

/// Compiles and links; driver messages of failures are mapped into `diagnostics`: errors, but a
/// warning where the program exceeds a limit of the driver.
GpuProgram buildGpuProgram(const std::string& label, const std::vector<const StageText*>& stages,
                           const SourceLines& lines, Diagnostics& diagnostics);

/// Matches uniforms to the table and to the custom uniforms, gives samplers and images their units.
void matchUniforms(GpuProgram& program, const CustomUniforms& custom);

/// Uploads to the program in use.
void uploadUniforms(const std::vector<UniformBinding>& uniforms, const FrameState& state,
                    const DrawState& draw, const CustomUniforms& custom);

}  // namespace orris
