#include <orris/glsl/compile/validate.h>

#include <fmt/format.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <memory>
#include <optional>
#include <string_view>

#include <orris/glsl/compile/compiler_log.h>
#include <orris/glsl/compile/plain_types.h>
#include <orris/glsl/compile/stage_errors.h>
#include <orris/glsl/rewrite/interface_repair.h>
#include <orris/glsl/syntax/brace_check.h>
#include <orris/glsl/tokens/text_tokens.h>

namespace orris {
namespace {

struct GlslangProcess {
  GlslangProcess() { glslang::InitializeProcess(); }
  ~GlslangProcess() { glslang::FinalizeProcess(); }
};

EShLanguage languageOf(Stage stage) {
  constexpr std::array<EShLanguage, 6> kLanguages = {EShLangVertex,         EShLangTessControl,
                                                     EShLangTessEvaluation, EShLangGeometry,
                                                     EShLangFragment,       EShLangCompute};
  return kLanguages[static_cast<std::size_t>(stage)];
}

// glslang's own numbers are the minima of the specification in places; a desktop driver of GL 4.5
// (Mesa llvmpipe measured) allows more.
TBuiltInResource desktopLimits() {
  TBuiltInResource limits = *GetDefaultResources();
  for (int TBuiltInResource::*images :
       {&TBuiltInResource::maxImageUnits, &TBuiltInResource::maxVertexImageUniforms,
        &TBuiltInResource::maxTessControlImageUniforms,
        &TBuiltInResource::maxTessEvaluationImageUniforms,
        &TBuiltInResource::maxGeometryImageUniforms, &TBuiltInResource::maxFragmentImageUniforms,
        &TBuiltInResource::maxComputeImageUniforms, &TBuiltInResource::maxCombinedImageUniforms}) {
    limits.*images = std::max(limits.*images, 32);
  }
  for (int TBuiltInResource::*textures :
       {&TBuiltInResource::maxTextureImageUnits, &TBuiltInResource::maxVertexTextureImageUnits,
        &TBuiltInResource::maxGeometryTextureImageUnits,
        &TBuiltInResource::maxComputeTextureImageUnits}) {
    limits.*textures = std::max(limits.*textures, 32);
  }
  limits.maxCombinedTextureImageUnits = std::max(limits.maxCombinedTextureImageUnits, 192);
  limits.maxCombinedShaderOutputResources = std::max(limits.maxCombinedShaderOutputResources, 64);
  limits.maxVaryingFloats = std::max(limits.maxVaryingFloats, 128);
  limits.maxVaryingComponents = std::max(limits.maxVaryingComponents, 128);
  limits.maxComputeUniformComponents = std::max(limits.maxComputeUniformComponents, 4096);
  limits.maxGeometryOutputVertices = std::max(limits.maxGeometryOutputVertices, 1024);
  limits.maxGeometryTotalOutputComponents = std::max(limits.maxGeometryTotalOutputComponents, 4096);
  return limits;
}

const TBuiltInResource& limits() {
  static const TBuiltInResource kLimits = desktopLimits();
  return kLimits;
}

// glslang knows fewer extensions than drivers do, and only the driver's word counts.
bool isUnknownExtension(const LogEntry& entry) {
  return entry.message.find("extension not supported") != std::string::npos;
}

// `varying` in core GLSL below 4.20, which every driver takes.
bool isDeprecation(const LogEntry& entry) {
  return entry.severity == Severity::Warning &&
         entry.message.find("deprecated in version") != std::string::npos;
}

// Its linker takes redeclared built-in varyings (gl_FogFragCoord, gl_TexCoord) for a clash of names.
// And stages of different versions, which GL links, know other members of the built-in block.
bool isFalseLinkAlarm(const LogEntry& entry) {
  const auto isBuiltInBlock = [](const std::string& note) {
    return note.find("Block: gl_PerVertex") != std::string::npos;
  };
  return entry.message.find("Anonymous member name used for global variable") !=
             std::string::npos ||
         std::any_of(entry.notes.begin(), entry.notes.end(), isBuiltInBlock);
}

LineEdit editOf(const SourceLocation& at, const SourceLines& lines, char brace, bool removes) {
  std::string line = lines(at.file, at.line);
  const auto column = std::min(line.size(), std::size_t(std::max(at.column - 1, 0)));
  if (removes)
    line.replace(column, 1, " ");
  else
    line.insert(column, 1, brace);
  return {at.file, at.line, line, true};
}

/// Where the brace is missing, or the one that is too many.
void describeBrace(const MissingBrace& missing, const StageText& stage, const SourceLines& lines,
                   Diagnostic& d) {
  const SourceLocation partner =
      stage.text.locate(missing.partner.origin.line, missing.partner.origin.column);
  const Origin& place = missing.surplus ? missing.partner.origin : missing.after.origin;
  d.includedFrom = stage.text.includedFrom(place.line, place.column);
  if (missing.surplus) {
    d.at = partner;
    d.message = "'}' without '{': nothing opens what it would close";
    return;
  }
  d.at = placeOfBrace(stage.text, missing, lines);
  d.message = fmt::format("expected '{}' after '{}': nothing {} the '{}' at {}:{}", missing.brace,
                          missing.after.text, missing.brace == '}' ? "closes" : "opens",
                          missing.partner.text, partner.file, partner.line);
  // When it goes behind an #include.
  const auto own = std::ranges::find(d.includedFrom, d.at.file, &SourceLocation::file);
  if (own != d.includedFrom.end()) d.includedFrom.erase(d.includedFrom.begin(), own + 1);
}

// Compilers name the place where a brace made no sense any more; what they say of the lines behind
// the missing one follows from it.
bool reportMissingBrace(const std::vector<LogEntry>& entries, const StageText& stage,
                        const SourceLines& lines, Diagnostics& diagnostics) {
  const auto isOfSyntax = [](const LogEntry& entry) {
    return entry.message.find("syntax error") != std::string::npos;
  };
  // To read all of the text takes as long as a good part of compiling it.
  if (std::ranges::none_of(entries, isOfSyntax)) return false;
  const auto missing = findMissingBrace(stage.text, lines);
  if (!missing) return false;
  Diagnostic d;
  d.id = "brace-unbalanced";
  describeBrace(*missing, stage, lines, d);
  if (d.at.file.empty()) return false;  // in the host's own lines, where no author can add or remove one
  if (lines) {
    d.sourceLine = lines(d.at.file, d.at.line);
    d.repair = editOf(d.at, lines, missing->brace, missing->surplus);
  }
  diagnostics.push_back(std::move(d));
  return true;
}

/// The text of a compute shader of a version without compute shaders, as one of a version that has them: glslang prints to standard
/// output and reads its built-in functions anew for each. Nothing for other stages.
std::optional<std::string> asComputeShader(const StageText& stage) {
  constexpr std::string_view kDirective = "#version ";
  constexpr int kFirstWithCompute = 420;
  const std::string& text = stage.text.text;
  if (stage.stage != Stage::Compute || !text.starts_with(kDirective)) return std::nullopt;
  int version = 0;
  std::from_chars(text.data() + kDirective.size(), text.data() + text.size(), version);
  if (version >= kFirstWithCompute) return std::nullopt;
  return "#version 430" + text.substr(std::min(text.find('\n'), text.size()));
}

bool compile(glslang::TShader& shader, const StageText& stage, const SourceLines& lines,
             CompileErrors wanted, Diagnostics& diagnostics) {
  const std::optional<std::string> raised = asComputeShader(stage);
  if (raised) {
    LogEntry entry;
    entry.line = entry.column = 1;
    entry.message = "compute shaders require version 420 or above";
    diagnostics.push_back(locateLogEntry(entry, "glsl-compile", stage, lines));
  }
  const std::string& compiled = raised ? *raised : stage.text.text;
  const char* text = compiled.c_str();
  const int length = static_cast<int>(compiled.size());
  shader.setStringsWithLengths(&text, &length, 1);
  constexpr int kDefaultVersion = 110;
  const EShMessages messages =
      wanted == CompileErrors::All ? EShMsgCascadingErrors : EShMsgDefault;
  bool ok = shader.parse(&limits(), kDefaultVersion, false, messages);
  std::vector<LogEntry> entries = parseCompilerLog(shader.getInfoLog(), Severity::Error);
  if (!ok && reportMissingBrace(entries, stage, lines, diagnostics)) return false;
  std::erase_if(entries, isDeprecation);
  for (LogEntry& entry : entries) {
    if (isUnknownExtension(entry)) entry.severity = Severity::Warning;
  }
  for (LogEntry& entry : ownMistakes(std::move(entries), stage.text.text)) {
    entry.message = withPlainTypes(entry.message);
    diagnostics.push_back(locateLogEntry(entry, "glsl-compile", stage, lines));
  }
  return ok && !raised;
}

// Messages of the linker have no place: "Linking fragment stage: ...".
void reportLink(const glslang::TProgram& program, const std::vector<const StageText*>& stages,
                const SourceLines& lines, Diagnostics& diagnostics) {
  for (LogEntry& entry :
       parseCompilerLog(const_cast<glslang::TProgram&>(program).getInfoLog(), Severity::Error)) {
    if (isFalseLinkAlarm(entry)) continue;
    const auto named = std::find_if(stages.begin(), stages.end(), [&entry](const StageText* stage) {
      return entry.message.find(fmt::format("{} stage", stageName(stage->stage))) !=
             std::string::npos;
    });
    diagnostics.push_back(locateLogEntry(entry, "glsl-link",
                                         named == stages.end() ? *stages.front() : **named, lines));
  }
}

}  // namespace

void validateWithGlslang(const std::vector<const StageText*>& written, const SourceLines& lines,
                         Diagnostics& diagnostics, CompileErrors wanted) {
  static const GlslangProcess kProcess;
  if (written.empty()) return;
  const auto repaired = repairInterface(written);
  std::vector<const StageText*> stages = written;
  for (std::size_t i = 0; repaired && i < stages.size(); ++i) stages[i] = &repaired->stages[i];
  // The program refers to the shaders, so it is declared after and dies before them.
  std::vector<std::unique_ptr<glslang::TShader>> shaders;
  glslang::TProgram program;
  bool compiled = true;
  for (const StageText* stage : stages) {
    shaders.push_back(std::make_unique<glslang::TShader>(languageOf(stage->stage)));
    compiled = compile(*shaders.back(), *stage, lines, wanted, diagnostics) && compiled;
    program.addShader(shaders.back().get());
  }
  if (!compiled) return;
  program.link(EShMsgDefault);
  reportLink(program, stages, lines, diagnostics);
}

}  // namespace orris
