// Compiling and linking a program of a pack, with what a driver cannot do done otherwise.
#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <utility>

#include <orris/render/gpu_program.h>
#include <orris/gl/functions.h>
#include <orris/glsl/rewrite/ambiguous_calls.h>
#include <orris/glsl/rewrite/core_text.h>
#include <orris/glsl/rewrite/interface_repair.h>
#include <orris/glsl/rewrite/shared_buffer.h>
#include <orris/glsl/rewrite/subgroups.h>

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

// Mesa words it so: "extension `GL_KHR_shader_subgroup_basic' unsupported in compute shader"; NVIDIA: "extension
// GL_KHR_shader_subgroup_basic not supported".
bool lacksExtension(const Diagnostic& diagnostic) {
  return diagnostic.message.starts_with("extension ") &&
         (diagnostic.message.find("' unsupported in ") != std::string::npos ||
          diagnostic.message.ends_with(" not supported"));
}

/// What a stage does with an extension that the driver lacks is not reported again: whether that is
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

/// The stages as they are drawn with; `made` holds those that differ from what was given.
struct DrawnStages {
  std::vector<const StageText*> stages;
  std::deque<StageText> made;

  void replace(std::size_t i, StageText text) {
    made.push_back(std::move(text));
    stages[i] = &made.back();
  }
};

DrawnStages drawnStages(const std::vector<const StageText*>& written) {
  DrawnStages drawn{written, {}};
  if (auto repaired = repairInterface(written)) {
    for (std::size_t i = 0; i < written.size(); ++i)
      drawn.replace(i, std::move(repaired->stages[i]));
  }
  if (!gl::isCoreProfile()) return drawn;
  std::vector<StageText> core = coreTexts(drawn.stages);
  for (std::size_t i = 0; i < core.size(); ++i) drawn.replace(i, std::move(core[i]));
  return drawn;
}

gl::Program linkStages(const DrawnStages& drawn, const std::string& label) {
  std::vector<gl::StageSource> sources;
  for (const StageText* stage : drawn.stages)
    sources.push_back({stageEnum(stage->stage), stage->text.text});
  std::vector<std::pair<std::string, int>> outputs;
  for (int i = 0; i < 8; ++i) outputs.emplace_back("outColor" + std::to_string(i), i);
  return gl::buildProgram(sources, outputs, label);
}

bool isSoftwareRasteriser() {
  const GLubyte* name = gl::GetString(GL_RENDERER);
  return name != nullptr &&
         std::string_view(reinterpret_cast<const char*>(name)).find("llvmpipe") !=
             std::string_view::npos;
}

/// Puts what `rewrite` makes of a stage that failed, and of the log of its failure, in its place. Does it make something?
template <class Rewrite>
bool replaceFailed(DrawnStages& drawn, const gl::Program& program, const Rewrite& rewrite) {
  bool replaced = false;
  for (std::size_t i = 0; i < drawn.stages.size(); ++i) {
    if (!program.stageFailed[i]) continue;
    std::optional<StageText> text = rewrite(*drawn.stages[i], program.stageLogs[i]);
    replaced |= text.has_value();
    if (text) drawn.replace(i, std::move(*text));
  }
  return replaced;
}

std::optional<StageText> withoutSubgroups(const StageText& stage, const std::string& log) {
  const bool lacks = log.find("ubgroup") != std::string::npos && isSoftwareRasteriser();
  return lacks ? emulateSubgroups(stage) : std::nullopt;
}

/// The name of the rule that puts other code in place of what the driver lacks; "" when none does.
std::string_view replaceLacking(DrawnStages& drawn, GpuProgram& program,
                                std::vector<std::string>& blocks) {
  if (replaceFailed(drawn, program.program, settleAmbiguousCalls)) return kAmbiguousCallsRule;
  if (replaceFailed(drawn, program.program, withoutSubgroups)) return kSubgroupsRule;
  const bool tooMuch = program.program.linkLog.find("Too much shared memory") != std::string::npos;
  auto moved = tooMuch && blocks.empty() ? moveSharedToBuffers(*drawn.stages.front()) : std::nullopt;
  if (!moved) return {};
  drawn.replace(0, std::move(moved->text));
  blocks = std::move(moved->blocks);
  return kSharedBufferRule;
}

/// Bindings from the last one down: packs count from the first.
void readSharedBlocks(const std::vector<std::string>& names, GpuProgram& program) {
  GLint bindings = 0;
  gl::GetIntegerv(GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, &bindings);
  const unsigned id = program.program.id();
  for (const std::string& name : names) {
    const unsigned index = gl::GetProgramResourceIndex(id, GL_SHADER_STORAGE_BLOCK, name.c_str());
    if (index == GL_INVALID_INDEX) continue;
    const GLenum asked = GL_BUFFER_DATA_SIZE;
    GLint bytes = 0;
    gl::GetProgramResourceiv(id, GL_SHADER_STORAGE_BLOCK, index, 1, &asked, 1, nullptr, &bytes);
    const auto binding = static_cast<unsigned>(--bindings);
    gl::ShaderStorageBlockBinding(id, index, binding);
    program.sharedBlocks.push_back({binding, static_cast<std::size_t>(bytes), {}});
  }
}

Diagnostic emulationNote(std::string_view rule, const StageText& stage) {
  return {.severity = Severity::Note,
          .id = "driver-emulation",
          .at = stage.text.locate(1, 1),
          .message = fmt::format("this driver lacks what the program asks for; rule {} puts other "
                                 "code in its place",
                                 rule)};
}

struct Logs {
  std::vector<std::string> stages;
  std::vector<bool> failed;
  std::string link;
};

void reportFailure(const std::vector<const StageText*>& stages, const Logs& logs,
                   const SourceLines& lines, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < stages.size(); ++i)
    if (logs.failed[i]) reportCompile(logs.stages[i], *stages[i], lines, diagnostics);
  const bool compiled =
      std::none_of(logs.failed.begin(), logs.failed.end(), [](bool f) { return f; });
  if (compiled && !stages.empty()) reportLink(logs.link, *stages.back(), lines, diagnostics);
}

}  // namespace

GpuProgram buildGpuProgram(const std::string& label, const std::vector<const StageText*>& written,
                           const SourceLines& lines, Diagnostics& diagnostics) {
  GpuProgram result;
  DrawnStages drawn = drawnStages(written);
  for (const StageText* stage : written)
    result.patches |= stage->stage == Stage::TessControl || stage->stage == Stage::TessEvaluation;
  result.program = linkStages(drawn, label);
  if (!result.program.linked && reportAsValidate(written, lines, diagnostics)) return result;
  // What the messages of a failure are about.
  const std::vector<const StageText*> asked = drawn.stages;
  const Logs logs{result.program.stageLogs, result.program.stageFailed, result.program.linkLog};
  std::vector<std::string> blocks;
  Diagnostics notes;
  while (!result.program.linked) {
    const std::string_view rule = replaceLacking(drawn, result, blocks);
    if (rule.empty()) break;
    notes.push_back(emulationNote(rule, *written.front()));
    result.program = linkStages(drawn, label);
  }
  if (!result.program.linked) {
    reportFailure(asked, logs, lines, diagnostics);
    return result;
  }
  readSharedBlocks(blocks, result);
  diagnostics.insert(diagnostics.end(), notes.begin(), notes.end());
  return result;
}

}  // namespace orris
