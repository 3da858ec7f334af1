#include "render/gpu_program.h"

#include <algorithm>

#include "gl/functions.h"
#include "glsl/rewrite/interface_repair.h"

namespace orris {
namespace {

unsigned stageEnum(Stage stage) {
  switch (stage) {
    case Stage::Vertex:
      return GL_VERTEX_SHADER;
    case Stage::TessControl:
      return GL_TESS_CONTROL_SHADER;
    case Stage::TessEvaluation:
      return GL_TESS_EVALUATION_SHADER;
    case Stage::Geometry:
      return GL_GEOMETRY_SHADER;
    case Stage::Fragment:
      return GL_FRAGMENT_SHADER;
    case Stage::Compute:
      return GL_COMPUTE_SHADER;
  }
  return 0;
}

bool isInteger(ValueType type) {
  return type == ValueType::Bool || type == ValueType::Int || type == ValueType::IVec2 ||
         type == ValueType::IVec3;
}

// Packs declare some uniforms with another type than the host's (hideGUI as int or bool, colours as
// vec3 or vec4): values are converted to what the program declared.
void uploadValue(int location, unsigned type, const Value& value) {
  float f[4];
  int i[4];
  const bool integer = isInteger(value.type);
  for (int k = 0; k < 4; ++k) {
    f[k] = integer ? static_cast<float>(value.i[k]) : value.f[k];
    i[k] = integer ? value.i[k] : static_cast<int>(std::clamp(value.f[k], -2.0e9f, 2.0e9f));
  }
  switch (type) {
    case GL_FLOAT:
      gl::Uniform1f(location, f[0]);
      break;
    case GL_FLOAT_VEC2:
      gl::Uniform2f(location, f[0], f[1]);
      break;
    case GL_FLOAT_VEC3:
      gl::Uniform3f(location, f[0], f[1], f[2]);
      break;
    case GL_FLOAT_VEC4:
      gl::Uniform4f(location, f[0], f[1], f[2], f[3]);
      break;
    case GL_INT:
    case GL_BOOL:
      gl::Uniform1i(location, i[0]);
      break;
    case GL_INT_VEC2:
    case GL_BOOL_VEC2:
      gl::Uniform2i(location, i[0], i[1]);
      break;
    case GL_INT_VEC3:
    case GL_BOOL_VEC3:
      gl::Uniform3i(location, i[0], i[1], i[2]);
      break;
    case GL_INT_VEC4:
    case GL_BOOL_VEC4:
      gl::Uniform4i(location, i[0], i[1], i[2], i[3]);
      break;
    case GL_UNSIGNED_INT:
      gl::Uniform1ui(location, static_cast<unsigned>(i[0]));
      break;
    case GL_FLOAT_MAT3:
      if (value.type == ValueType::Mat3)
        gl::UniformMatrix3fv(location, 1, GL_FALSE, value.f.data());
      break;
    case GL_FLOAT_MAT4:
      if (value.type == ValueType::Mat4)
        gl::UniformMatrix4fv(location, 1, GL_FALSE, value.f.data());
      break;
    default:
      break;
  }
}

int customIndex(const CustomUniforms& custom, const std::string& name) {
  const auto& values = custom.values();
  const auto it =
      std::find_if(values.begin(), values.end(), [&](const auto& v) { return v.first == name; });
  return it == values.end() ? -1 : static_cast<int>(it - values.begin());
}

// Mesa words them so: "Too much shared memory used", "Too many fragment shader texture samplers".
bool exceedsLimit(const std::string& linkLog) {
  return linkLog.find("Too much ") != std::string::npos ||
         linkLog.find("Too many ") != std::string::npos;
}

void markAsLimit(Diagnostic& diagnostic) {
  diagnostic.severity = Severity::Warning;
  diagnostic.id = "target-limit";
  diagnostic.notes.push_back("this driver cannot run the program; it is left out");
}

void reportLink(const std::string& log, const StageText& stage, const SourceLines& lines,
                Diagnostics& diagnostics) {
  Diagnostics found;
  mapDriverLog(log, Severity::Error, stage, lines, found);
  for (Diagnostic& diagnostic : found) {
    if (exceedsLimit(log)) markAsLimit(diagnostic);
    diagnostics.push_back(std::move(diagnostic));
  }
}

// Mesa words it so: "extension `GL_KHR_shader_subgroup_basic' unsupported in compute shader".
bool lacksExtension(const Diagnostic& diagnostic) {
  return diagnostic.message.starts_with("extension `") &&
         diagnostic.message.find("' unsupported in ") != std::string::npos;
}

/// What a stage does with an extension that the driver lacks is not told besides: whether that is
/// right, glslang says.
void reportCompile(const std::string& log, const StageText& stage, const SourceLines& lines,
                   Diagnostics& diagnostics) {
  Diagnostics found;
  mapDriverLog(log, Severity::Error, stage, lines, found);
  if (std::any_of(found.begin(), found.end(), lacksExtension)) {
    std::erase_if(found, [](const Diagnostic& d) { return !lacksExtension(d); });
    for (Diagnostic& diagnostic : found) markAsLimit(diagnostic);
  }
  diagnostics.insert(diagnostics.end(), found.begin(), found.end());
}

/// What glslang refuses too is said as validate says it. Of extensions only the driver is a judge.
bool reportAsValidate(const std::vector<const StageText*>& written, const SourceLines& lines,
                      Diagnostics& diagnostics) {
  Diagnostics found;
  validateWithGlslang(written, lines, found);
  const bool judges = std::none_of(found.begin(), found.end(), [](const Diagnostic& d) {
    return d.message.find("extension not supported") != std::string::npos;
  });
  if (!judges || !hasErrors(found)) return false;
  diagnostics.insert(diagnostics.end(), found.begin(), found.end());
  return true;
}

}  // namespace

GpuProgram buildGpuProgram(const std::string& label, const std::vector<const StageText*>& written,
                           const SourceLines& lines, Diagnostics& diagnostics) {
  GpuProgram result;
  const auto repaired = repairInterface(written);
  std::vector<const StageText*> stages = written;
  for (size_t i = 0; repaired && i < stages.size(); ++i) stages[i] = &repaired->stages[i];
  std::vector<gl::StageSource> sources;
  for (const StageText* stage : stages) {
    sources.push_back({stageEnum(stage->stage), stage->text.text});
    result.patches |= stage->stage == Stage::TessControl || stage->stage == Stage::TessEvaluation;
  }
  std::vector<std::pair<std::string, int>> outputs;
  for (int i = 0; i < 8; ++i) outputs.emplace_back("outColor" + std::to_string(i), i);
  result.program = gl::buildProgram(sources, outputs, label);
  if (result.program.linked || reportAsValidate(written, lines, diagnostics)) return result;
  for (size_t i = 0; i < stages.size(); ++i)
    if (result.program.stageFailed[i])
      reportCompile(result.program.stageLogs[i], *stages[i], lines, diagnostics);
  const bool compiled = std::none_of(result.program.stageFailed.begin(),
                                     result.program.stageFailed.end(), [](bool f) { return f; });
  if (compiled && !stages.empty())
    reportLink(result.program.linkLog, *stages.back(), lines, diagnostics);
  return result;
}

void matchUniforms(GpuProgram& program, const CustomUniforms& custom) {
  program.frameUniforms.clear();
  program.drawUniforms.clear();
  program.samplers.clear();
  program.images.clear();
  const bool watershadow =
      std::any_of(program.program.uniforms.begin(), program.program.uniforms.end(),
                  [](const gl::ActiveVariable& u) { return u.name == "watershadow"; });
  for (const gl::ActiveVariable& uniform : program.program.uniforms) {
    if (uniform.location < 0) continue;
    if (gl::isSampler(uniform.type) || gl::isImage(uniform.type)) {
      auto& list = gl::isSampler(uniform.type) ? program.samplers : program.images;
      list.push_back({uniform.name, uniform.type, static_cast<int>(list.size()), uniform.location,
                      parseBufferName(uniform.name, watershadow)});
      continue;
    }
    UniformBinding binding{uniform.location, uniform.type, findUniform(uniform.name),
                           customIndex(custom, uniform.name), uniform.name};
    if (binding.row == nullptr && binding.custom < 0) continue;
    const bool perDraw = binding.row != nullptr && binding.row->perDraw;
    (perDraw ? program.drawUniforms : program.frameUniforms).push_back(std::move(binding));
  }
}

void uploadUniforms(const std::vector<UniformBinding>& uniforms, const FrameState& state,
                    const DrawState& draw, const CustomUniforms& custom) {
  for (const UniformBinding& uniform : uniforms)
    uploadValue(uniform.location, uniform.type,
                uniform.row != nullptr ? uniform.row->value(state, draw)
                                       : custom.values()[uniform.custom].second);
}

}  // namespace orris
