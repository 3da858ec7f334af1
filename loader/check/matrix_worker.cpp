#include "check/matrix_worker.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "check/diagnostic_codec.h"
#include "glsl/validate.h"

namespace orris {
namespace {

using nlohmann::json;

Diagnostics errorsOf(Diagnostics diagnostics) {
  std::erase_if(diagnostics, [](const Diagnostic& d) { return d.severity != Severity::Error; });
  return diagnostics;
}

Diagnostics loadErrors(const ProgramSource& program) {
  Diagnostics found = program.diagnostics;
  PackDirectives ignored;
  readPackDirectives(program.constLines, program.constSites, ignored, found);
  return errorsOf(std::move(found));
}

Diagnostics compile(const ProgramUnit& unit, const FolderBuild& build) {
  const SourceLines lines = [&build](const std::string& file, int line) {
    const FileLines* known = build.lines(file);
    const auto index = static_cast<std::size_t>(line) - 1;
    return known && line > 0 && index < known->size() ? (*known)[index] : std::string();
  };
  Diagnostics found;
  std::vector<StageText> stages;
  for (const StageText* stage : unit.stages) stages.push_back(*stage);
  validateWithGlslang(stages, lines, found);
  return errorsOf(std::move(found));
}

const ProgramEntry* entryNamed(const FolderBuild& build, const std::string& name) {
  const auto& programs = build.programs();
  const auto found = std::find_if(programs.begin(), programs.end(),
                                  [&](auto& entry) { return entry.name.program == name; });
  return found == programs.end() ? nullptr : &*found;
}

}  // namespace

std::string encode(const MatrixFinding& finding) {
  std::string bytes;
  json::to_cbor(json::array({finding.units, finding.failing, finding.compiled,
                             encodeDiagnostics(finding.errors)}),
                bytes);
  return bytes;
}

MatrixFinding decodeFinding(const std::string& bytes) {
  const json value = json::from_cbor(bytes);
  return {value[0], value[1], value[2], decodeDiagnostics(value[3].get<std::string>())};
}

MatrixFinding MatrixWorker::run(const MatrixJob& job, SharedHashes& seen) {
  const FolderBuild& build = variants_.get(job.build, plan_.configurations[job.configuration]);
  MatrixFinding finding;
  if (!job.entry) {
    finding.errors = errorsOf(build.properties().diagnostics);
    return finding;
  }
  const ProgramSource program = build.build(*job.entry);
  finding.errors = loadErrors(program);
  for (const ProgramUnit& unit : programUnits(program)) {
    finding.units.push_back(unit.hash);
    if (!seen.insert(unit.hash)) continue;
    ++finding.compiled;
    if (!compile(unit, build).empty()) finding.failing.push_back(unit.hash);
  }
  return finding;
}

Diagnostics MatrixWorker::errorsWith(const MatrixJob& job, const OptionValues& values) {
  const FolderBuild& build = variants_.get(job.build, values);
  if (!job.entry) return errorsOf(build.properties().diagnostics);
  const ProgramEntry* entry = entryNamed(build, job.entry->name.program);
  if (!entry) return {};
  const ProgramSource program = build.build(*entry);
  Diagnostics errors = loadErrors(program);
  for (const ProgramUnit& unit : programUnits(program)) {
    const Diagnostics found = compile(unit, build);
    errors.insert(errors.end(), found.begin(), found.end());
  }
  return errors;
}

std::vector<std::string> MatrixWorker::deciding(const MatrixJob& job, const OptionValues& values) {
  const FolderBuild& build = variants_.get(job.build, values);
  std::vector<std::string> names = build.properties().options;
  if (const auto* entry = job.entry ? entryNamed(build, job.entry->name.program) : nullptr) {
    const ProgramSource program = build.build(*entry);
    names.insert(names.begin(), program.conditionOptions.begin(), program.conditionOptions.end());
  }
  std::vector<std::string> unique;
  for (const std::string& name : names) {
    if (std::find(unique.begin(), unique.end(), name) == unique.end()) unique.push_back(name);
  }
  return unique;
}

}  // namespace orris
