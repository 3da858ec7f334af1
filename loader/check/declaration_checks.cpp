#include "check/declaration_checks.h"

#include <fmt/format.h>

#include <algorithm>

#include "check/version_checks.h"
#include "glsl/compiler_log.h"

namespace orris {
namespace {

using ProgramCheck = void (*)(const ProgramInterface&, DeclarationReport&);

// In the order of the report.
constexpr ProgramCheck kChecks[] = {checkVaryings, checkNames, checkNewNames, checkOutputs,
                                    checkResourceCounts};

ProgramInterface interfaceOf(const ProgramSource& program) {
  ProgramInterface result{.program = &program};
  for (const StageText& stage : program.stages) result.stages.push_back(readStageInterface(stage));
  return result;
}

ProgramInterface interfaceOf(const ProgramSource& program, const ComputeSource& compute) {
  ProgramInterface result{.program = &program, .compute = &compute};
  result.stages.push_back(readStageInterface(compute.text));
  return result;
}

void check(const ProgramInterface& program, DeclarationReport& report) {
  for (const ProgramCheck run : kChecks) run(program, report);
}

}  // namespace

std::string ProgramInterface::name() const {
  const std::string& own = compute ? compute->name : program->name;
  return (program->folder == "/" ? "/" : program->folder + "/") + own;
}

void DeclarationReport::add(const StageInterface& stage, const TextPlace& place, Finding finding) {
  const SourceLocation at = stage.stage->text.locate(place.line, place.column);
  if (at.file.empty() || known(at, finding)) return;
  LogEntry entry{finding.severity, place.line, place.column, std::move(finding.message),
                 std::move(finding.notes)};
  const ShaderPack& pack = folder.pack;
  Diagnostic& diagnostic = diagnostics_.emplace_back(locateLogEntry(
      entry, std::move(finding.id), *stage.stage,
      [&pack](const std::string& file, int line) { return pack.sourceLine(file, line); }));
  diagnostic.hint = std::move(finding.hint);
}

void DeclarationReport::add(const SourceLocation& at, Finding finding) {
  if (known(at, finding)) return;
  diagnostics_.push_back({.severity = finding.severity,
                          .id = std::move(finding.id),
                          .at = at,
                          .message = std::move(finding.message),
                          .sourceLine = folder.pack.sourceLine(at.file, at.line),
                          .notes = std::move(finding.notes),
                          .hint = std::move(finding.hint)});
}

// A name may be unused in one program and used in another: the graver finding counts.
bool DeclarationReport::known(const SourceLocation& at, const Finding& finding) {
  const std::string key = fmt::format("{}:{}:{}:{}", at.file, at.line, finding.id, finding.message);
  const auto [entry, isNew] = seen_.try_emplace(key, diagnostics_.size());
  if (isNew) return false;
  Severity& severity = diagnostics_[entry->second].severity;
  severity = std::max(severity, finding.severity);
  return true;
}

std::string DeclarationReport::placeName(const StageInterface& stage, const TextPlace& place) {
  const SourceLocation at = stage.stage->text.locate(place.line, place.column);
  return at.file.empty() ? "text added by the host" : fmt::format("{}:{}", at.file, at.line);
}

void checkDeclarations(const FolderInput& input, Diagnostics& diagnostics) {
  DeclarationReport report(input, diagnostics);
  for (const ProgramSource& program : input.pack.programs) {
    for (const ComputeSource& compute : program.computes) {
      check(interfaceOf(program, compute), report);
    }
    if (!program.stages.empty()) check(interfaceOf(program), report);
  }
}

}  // namespace orris
