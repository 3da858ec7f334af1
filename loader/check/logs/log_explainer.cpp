#include <orris/check/logs/log_explainer.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include <orris/pack/files/text.h>

namespace orris {
namespace {

constexpr std::string_view kDebugHint =
    "for exact places turn on Iris's debug mode (Ctrl+D in its list of packs), load the pack again "
    "and give --patched-shaders the game's folder patched_shaders";

std::string_view endingOf(Stage stage) {
  constexpr std::array<std::string_view, 6> kEndings = {"vsh", "tcs", "tes", "gsh", "fsh", "csh"};
  return kEndings[static_cast<std::size_t>(stage)];
}

/// The stages that a log section can be about.
struct Candidates {
  std::string program;  ///< after fallbacks
  std::vector<const StageText*> stages;
};

const ProgramSource* findProgram(const ShaderPack& pack, const std::string& name) {
  if (const ProgramSource* program = pack.resolve(name)) return program;
  const auto mod = std::ranges::find(pack.modPrograms, name, &ProgramSource::name);
  return mod == pack.modPrograms.end() ? nullptr : &*mod;
}

Candidates candidatesOf(const ShaderPack& pack, const LoggedShader& shader) {
  Candidates candidates{.program = shader.program};
  const auto wants = [&](Stage stage) {
    return shader.stage.empty() || shader.stage == endingOf(stage);
  };
  // Iris: a geometry shader is named after what it draws, without the group.
  const ProgramSource* program = findProgram(pack, shader.program);
  if (program == nullptr) program = findProgram(pack, "gbuffers_" + shader.program);
  if (program != nullptr) {
    candidates.program = program->name;
    for (const StageText& stage : program->stages) {
      if (wants(stage.stage)) candidates.stages.push_back(&stage);
    }
  }
  for (const ProgramSource& other : pack.programs) {
    for (const ComputeSource& compute : other.computes) {
      if (compute.name == shader.program && wants(Stage::Compute)) {
        candidates.stages.push_back(&compute.text);
      }
    }
  }
  return candidates;
}

class Explainer {
 public:
  explicit Explainer(const ExplainInput& input) : input_(input) {}

  Diagnostics run() {
    for (const LogSection& section : input_.sections) explain(section);
    if (diagnostics_.empty()) {
      diagnostics_.push_back({.severity = Severity::Note,
                              .id = "log-empty",
                              .at = {input_.logName, 0, 0},
                              .message = "the log holds no message of a shader compiler"});
    }
    return std::move(diagnostics_);
  }

 private:
  void explain(const LogSection& section) {
    const std::string name = section.name.empty() ? input_.stage : section.name;
    if (name.empty())
      return refuse(section, "the log does not say which shader this is about",
                    "name it: --stage composite.fsh");
    const Candidates candidates = candidatesOf(input_.pack, shaderOfLogName(name));
    if (candidates.stages.empty()) {
      return refuse(section, fmt::format("the pack has no program for the shader {}", name),
                    "is it the same pack, with the same options and --dimension?");
    }
    for (const LogEntry& entry : parseCompilerLog(section.text, Severity::Warning)) {
      add(section, name, entry, candidates);
    }
  }

  void refuse(const LogSection& section, std::string message, std::string hint) {
    diagnostics_.push_back({.severity = Severity::Warning,
                            .id = "log-program",
                            .at = {input_.logName, section.line, 0},
                            .message = std::move(message),
                            .sourceLine = section.text.substr(0, section.text.find('\n')),
                            .hint = std::move(hint)});
  }

  void add(const LogSection& section, const std::string& name, const LogEntry& entry,
           const Candidates& candidates) {
    const auto place = findPlace(section, name, entry, candidates);
    LogEntry placed = entry;
    placed.line = place ? place->line : 0;
    placed.column = place ? place->column : 0;
    const StageText& stage = place ? *place->stage : *candidates.stages.front();
    const SourceLines lines = [this](const std::string& file, int line) {
      return input_.pack.sourceLine(file, line);
    };
    Diagnostic d = locateLogEntry(placed, "log-message", stage, lines);
    d.notes.push_back(place ? "place is " + place->how : "place is unknown: only the shader is");
    d.notes.push_back(whereInLog(section, name, entry, candidates.program));
    if (input_.patched.empty() && !(place && place->how.starts_with("exact"))) d.hint = kDebugHint;
    diagnostics_.push_back(std::move(d));
  }

  std::optional<LogPlace> findPlace(const LogSection& section, const std::string& name,
                                    const LogEntry& entry, const Candidates& candidates) {
    for (const StageText* stage : candidates.stages) {
      const PatchedShader* patched = patchedOf(name, candidates.program, endingOf(stage->stage));
      if (patched == nullptr) continue;
      if (auto place = placer_.byPatchedText(entry, *patched, *stage)) return place;
    }
    if (section.name.empty()) {
      if (auto place = placer_.byOwnText(entry, *candidates.stages.front())) return place;
    }
    if (entry.severity == Severity::Error) {
      if (auto place = placer_.byOwnProblem(entry, candidates.stages)) return place;
    }
    return placer_.byName(entry, candidates.stages);
  }

  // Iris: ShaderPrinter numbers its files and names those of chunk shaders "sodium_...". The last
  // one is of the dimension loaded last, which the log is about.
  const PatchedShader* patchedOf(std::string_view name, const std::string& program,
                                 std::string_view ending) const {
    const std::string shader(name.substr(0, name.rfind('.')));
    const std::set<std::string> wanted = {fmt::format("{}.{}", shader, ending),
                                          fmt::format("{}.{}", program, ending),
                                          fmt::format("sodium_{}.{}", program, ending)};
    const PatchedShader* best = nullptr;
    for (const PatchedShader& file : input_.patched) {
      const std::size_t number = file.file.find('_');
      const std::string plain = number == 3 ? file.file.substr(4) : file.file;
      if (wanted.contains(plain) && (best == nullptr || best->file < file.file)) best = &file;
    }
    return best;
  }

  std::string whereInLog(const LogSection& section, const std::string& name, const LogEntry& entry,
                         const std::string& program) const {
    std::string text = fmt::format("{}:{}: {}", input_.logName, section.line, name);
    if (entry.line > 0) text += fmt::format(", line {} of the compiled text", entry.line);
    if (!name.starts_with(program)) text += fmt::format("; it is made of {}", program);
    return text;
  }

  const ExplainInput& input_;
  LogPlacer placer_;
  Diagnostics diagnostics_;
};

}  // namespace

Diagnostics explainLog(const ExplainInput& input) { return Explainer(input).run(); }

}  // namespace orris
