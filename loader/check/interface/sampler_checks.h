// What a sampler or image name is bound to, against how it is declared.
#pragma once

#include <optional>
#include <string>

#include <orris/check/interface/stage_interface.h>
#include <orris/pack/shader_pack.h>

namespace orris {

struct SamplerProblem {
  std::string id;
  std::string message;
  std::string hint;
  Severity severity = Severity::Warning;
};

/// nullopt when the declaration fits, or when `global` is no sampler or image, or is bound to
/// something of the pack whose format only the file knows.
std::optional<SamplerProblem> samplerProblem(const ShaderPack& pack, const ProgramSource& program,
                                             const StageGlobal& global);

}  // namespace orris
