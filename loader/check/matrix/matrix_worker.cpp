#include <orris/check/matrix/matrix_worker.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include <orris/check/workers/diagnostic_codec.h>
#include <orris/glsl/compile/validate.h>
#include <orris/glsl/tokens/shape.h>

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
  validateWithGlslang(unit.judged, lines, found);
  return errorsOf(std::move(found));
}

}  // namespace

std::string encode(const MatrixFinding& finding) {
  json failing = json::array();
  for (const auto& [unit, errors] : finding.failing) {
    failing.push_back({unit, encodeDiagnostics(errors)});
  }
  std::string bytes;
  json::to_cbor(
      json::array({finding.units, failing, finding.compiled, encodeDiagnostics(finding.errors)}),
      bytes);
  return bytes;
}

MatrixFinding decodeFinding(const std::string& bytes) {
  const json value = json::from_cbor(bytes);
  MatrixFinding finding{.units = value[0],
                        .compiled = value[2],
                        .errors = decodeDiagnostics(value[3].get<std::string>())};
  for (const json& failing : value[1]) {
    finding.failing.emplace(failing[0], decodeDiagnostics(failing[1].get<std::string>()));
  }
  return finding;
}

MatrixFinding MatrixWorker::run(const MatrixJob& job) {
  if (job.entry) {
    if (auto known = sweeps_.known(job)) return {.units = std::move(*known)};
  }
  const FolderBuild& build = variants_.get(job.build, plan_.configurations[job.configuration]);
  if (!job.entry) return {.errors = errorsOf(build.properties().diagnostics)};
  Variant variant = shapesOf(job, build);
  MatrixFinding finding{.units = unitShapes(*job.entry, variant.shapes)};
  if (!variant.failed && isClean(job, finding.units)) {
    sweeps_.learn(job, finding.units);
    return finding;
  }
  const ProgramSource program = finish(job, build, std::move(variant));
  finding.errors = loadErrors(program);
  compileNew(program, build, finding);
  if (finding.errors.empty()) {
    clean_.insert({job.build, job.entry->name.program, finding.units});
    sweeps_.learn(job, finding.units);
  }
  return finding;
}

// Parts that the values do not reach have the shape they had.
MatrixWorker::Variant MatrixWorker::shapesOf(const MatrixJob& job, const FolderBuild& build) const {
  const FolderBuild& old = *plan_.builds[job.build];
  const BaseProgram* base = shapes_.find(job);
  if (base && !(base->files == filesOf(*job.entry) &&
                build.properties().shaderMacros == old.properties().shaderMacros)) {
    base = nullptr;
  }
  const auto changed = differingOptions(build.files().options, old.values(), build.values());
  Variant variant;
  for (std::size_t i = 0; i < partCount(*job.entry); ++i) {
    auto& part = variant.parts.emplace_back();
    if (base && !haveCommonName(changed, base->options[i])) {
      variant.shapes.push_back(base->parts[i]);
      continue;
    }
    part = build.buildPart(*job.entry, i);
    variant.failed = variant.failed || hasErrors(part->diagnostics);
    variant.shapes.push_back(shapeOf(part->stream, stageOfPart(*job.entry, i)));
  }
  return variant;
}

// A program like this one was compiled, or is as with the values in force, and all was well with
// what its text says to the host.
bool MatrixWorker::isClean(const MatrixJob& job, const UnitShapes& units) const {
  const BaseProgram* base = shapes_.find(job);
  return (base && base->units == units) ||
         clean_.contains({job.build, job.entry->name.program, units});
}

ProgramSource MatrixWorker::finish(const MatrixJob& job, const FolderBuild& build,
                                   Variant variant) const {
  std::vector<PreprocessedPart> parts;
  for (std::size_t i = 0; i < variant.parts.size(); ++i) {
    auto& part = variant.parts[i];
    parts.push_back(part ? std::move(*part) : build.buildPart(*job.entry, i));
  }
  return build.finish(*job.entry, std::move(parts));
}

void MatrixWorker::compileNew(const ProgramSource& program, const FolderBuild& build,
                              MatrixFinding& finding) {
  const std::vector<ProgramUnit> units = programUnits(program);
  for (std::size_t i = 0; i < units.size() && i < finding.units.size(); ++i) {
    if (!seen_.insert(finding.units[i])) continue;
    ++finding.compiled;
    Diagnostics errors = compile(units[i], build);
    if (!errors.empty()) finding.failing.emplace(finding.units[i], std::move(errors));
  }
}

Diagnostics MatrixWorker::unitErrors(const MatrixJob& job, std::size_t unit) {
  const FolderBuild& build = variants_.get(job.build, plan_.configurations[job.configuration]);
  const ProgramSource program = build.build(*job.entry);
  return compile(programUnits(program).at(unit), build);
}

Diagnostics MatrixWorker::errorsWith(const MatrixJob& job, const OptionValues& values) {
  const FolderBuild& build = variants_.get(job.build, values);
  if (!job.entry) return errorsOf(build.properties().diagnostics);
  const ProgramEntry* entry = build.entryNamed(job.entry->name.program);
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
  if (const auto* entry = job.entry ? build.entryNamed(job.entry->name.program) : nullptr) {
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
