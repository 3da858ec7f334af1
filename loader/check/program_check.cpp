#include "check/program_check.h"

#include <fmt/format.h>

#include <atomic>
#include <functional>
#include <set>
#include <thread>

#include "check/compile_hints.h"
#include "frame/gpu_program.h"
#include "glsl/validate.h"
#include "pack/mods.h"

namespace orris {
namespace {

std::uint64_t hashOf(const std::vector<const StageText*>& stages) {
  std::uint64_t hash = 0;
  for (const StageText* stage : stages) {
    const std::uint64_t text = std::hash<std::string>()(stage->text.text);
    hash = (hash ^ (text + std::uint64_t(stage->stage))) * 0x100000001b3u;
  }
  return hash;
}

std::string unitName(const ProgramSource& program, const std::string& name) {
  return program.folder == "/" ? "/" + name : program.folder + "/" + name;
}

std::vector<ProgramUnit> unitsWithoutVerdict(const ShaderPack& pack, const Verdicts& verdicts) {
  std::vector<ProgramUnit> units;
  std::set<std::uint64_t> taken;
  for (ProgramUnit& unit : programUnits(pack)) {
    if (!verdicts.contains(unit.hash) && taken.insert(unit.hash).second) {
      units.push_back(std::move(unit));
    }
  }
  return units;
}

SourceLines sourceLinesOf(const ShaderPack& pack) {
  return [&pack](const std::string& file, int line) { return pack.sourceLine(file, line); };
}

void runOnThreads(int jobs, size_t count, const std::function<void(size_t)>& work) {
  std::atomic<size_t> next = 0;
  const auto loop = [&] {
    for (size_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::jthread> threads;
  for (int i = 1; i < jobs; ++i) threads.emplace_back(loop);
  loop();
}

}  // namespace

std::vector<ProgramUnit> programUnits(const ShaderPack& pack) {
  std::vector<ProgramUnit> units;
  const auto add = [&](const ProgramSource& program, const std::string& name,
                       std::vector<const StageText*> stages) {
    const std::uint64_t hash = hashOf(stages);
    const ModFamily* family = modFamilyOf(program.group);
    units.push_back({unitName(program, name), hash, std::move(stages),
                     family ? family->name : std::string_view()});
  };
  for (const auto* programs : {&pack.programs, &pack.modPrograms}) {
    for (const ProgramSource& program : *programs) {
      // A fullscreen program and a compute shader may share their name.
      for (const ComputeSource& compute : program.computes)
        add(program, compute.name + ".csh", {&compute.text});
      std::vector<const StageText*> stages;
      for (const StageText& stage : program.stages) stages.push_back(&stage);
      if (!stages.empty()) add(program, program.name, std::move(stages));
    }
  }
  return units;
}

void checkWithGlslang(const ShaderPack& pack, int jobs, Verdicts& verdicts,
                      Diagnostics& diagnostics) {
  const std::vector<ProgramUnit> units = unitsWithoutVerdict(pack, verdicts);
  std::vector<Diagnostics> found(units.size());
  const SourceLines lines = sourceLinesOf(pack);
  DefinitionIndex index(pack);
  runOnThreads(jobs, units.size(), [&](size_t i) {
    std::vector<StageText> stages;
    for (const StageText* stage : units[i].stages) stages.push_back(*stage);
    validateWithGlslang(stages, lines, found[i]);
    if (hasErrors(found[i])) explainUnknownNames(index, units[i].stages, found[i]);
  });
  for (size_t i = 0; i < units.size(); ++i) {
    verdicts[units[i].hash] = !hasErrors(found[i]);
    if (!units[i].mod.empty()) markAsOfMod(units[i].mod, found[i]);
    diagnostics.insert(diagnostics.end(), found[i].begin(), found[i].end());
  }
}

void checkWithDriver(const ShaderPack& pack, Verdicts& verdicts, Diagnostics& diagnostics) {
  const SourceLines lines = sourceLinesOf(pack);
  for (const ProgramUnit& unit : unitsWithoutVerdict(pack, verdicts)) {
    Diagnostics found;
    const GpuProgram program = buildGpuProgram(unit.name, unit.stages, lines, found);
    verdicts[unit.hash] = program.program.linked;
    if (!unit.mod.empty()) markAsOfMod(unit.mod, found);
    diagnostics.insert(diagnostics.end(), found.begin(), found.end());
  }
}

Diagnostics ruleNotes(const ShaderPack& pack) {
  Diagnostics notes;
  const auto add = [&](const ProgramSource& program, const std::string& name,
                       const std::vector<AppliedRule>& rules) {
    for (const AppliedRule& rule : rules) {
      Diagnostic& note = notes.emplace_back();
      note.severity = Severity::Note;
      note.id = "rule-applied";
      note.at = rule.first;
      note.message = fmt::format("{}: rule {} applied {} time{}", unitName(program, name),
                                 rule.rule, rule.count, rule.count == 1 ? "" : "s");
    }
  };
  for (const auto* programs : {&pack.programs, &pack.modPrograms}) {
    for (const ProgramSource& program : *programs) {
      for (const ComputeSource& compute : program.computes)
        add(program, compute.name, compute.rules);
      add(program, program.name, program.rules);
    }
  }
  return notes;
}

}  // namespace orris
