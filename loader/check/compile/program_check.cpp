#include <orris/check/compile/program_check.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <tuple>

#include <orris/check/compile/unused_functions.h>
#include <orris/check/compile/version_hints.h>
#include <orris/check/hints/common_include.h>
#include <orris/check/hints/compile_hints.h>
#include <orris/check/hints/double_include.h>
#include <orris/check/hints/language_hints.h>
#include <orris/check/hints/line_trial.h>
#include <orris/check/pack/open_comments.h>
#include <orris/glsl/compile/validate.h>
#include <orris/pack/mods/mods.h>

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

// Its programs become part of a shader of the mod's own, which this host does not have.
constexpr std::string_view kPatchingMod = "Voxy";

/// A name that resembles none of the pack's may be the mod's.
void excuseNamesOfTheMod(Diagnostics& diagnostics) {
  for (Diagnostic& diagnostic : diagnostics) {
    if (!diagnostic.hint.empty() ||
        diagnostic.message.find("undeclared identifier") == std::string::npos)
      continue;
    diagnostic.severity = Severity::Note;
    diagnostic.notes.push_back("the mod may declare it");
  }
}

std::string unitName(const ProgramSource& program, const std::string& name) {
  return program.folder == "/" ? "/" + name : program.folder + "/" + name;
}

/// Has the program no #version that its host takes? Reported as that: what another GLSL lacks is no further mistake. OptiFine takes
/// a stage without one for GLSL 1.20, which is what is judged then; no host takes one that GLSL does not have.
bool lacksVersion(const ProgramUnit& unit) {
  const bool needed = unit.judged != unit.stages;
  return std::ranges::any_of(unit.program->diagnostics, [needed](const Diagnostic& d) {
    return d.id == "version-malformed" || (needed && d.id == "version-missing");
  });
}

/// Does Iris refuse the program or, for what stands in it, the pack? Compilers may not see it.
bool irisRefuses(const ProgramSource& program) {
  return program.misnames || std::ranges::any_of(program.diagnostics, [](const Diagnostic& d) {
           return d.effect == Effect::RefusesProgram || d.effect == Effect::RefusesPack;
         });
}

SourceLines sourceLinesOf(const ShaderPack& pack) {
  return [&pack](const std::string& file, int line) { return pack.sourceLine(file, line); };
}

// The tables of built-in functions of a version are made once, before the workers are forked.
void warmUp(const std::vector<ProgramUnit>& units) {
  std::set<std::string> versions;
  for (const ProgramUnit& unit : units) {
    for (const StageText* stage : unit.judged) {
      const std::string& text = stage->text.text;
      versions.insert(text.substr(0, text.find('\n')));
    }
  }
  for (const std::string& version : versions) {
    StageText stage;
    stage.text.text = version + "\nvoid main() {}\n";
    Diagnostics ignored;
    validateWithGlslang(
        {&stage}, [](const std::string&, int) { return std::string(); }, ignored);
  }
}

}  // namespace

std::vector<ProgramUnit> programUnits(const ProgramSource& program) {
  std::vector<ProgramUnit> units;
  const ModFamily* family = modFamilyOf(program.group);
  const bool refused = irisRefuses(program);
  using Stages = std::vector<const StageText*>;
  const auto add = [&](const std::string& name, Stages stages, Stages judged) {
    std::uint64_t hash = hashOf(stages);
    if (judged.empty()) judged = stages;
    // Versions that the text for drawing levels may tell texts apart.
    if (judged != stages) hash = hash * 31 + hashOf(judged);
    hash += refused;
    units.push_back({unitName(program, name), hash, std::move(stages), std::move(judged), &program,
                     family ? family->name : std::string_view(), program.incomplete, refused});
  };
  // A fullscreen program and a compute shader may share their name.
  for (const ComputeSource& compute : program.computes) {
    add(compute.name + ".csh", {&compute.text},
        compute.irisText ? Stages{&*compute.irisText} : Stages{});
  }
  Stages stages, judged;
  for (const StageText& stage : program.stages) stages.push_back(&stage);
  for (const StageText& stage : program.irisStages) judged.push_back(&stage);
  if (!stages.empty()) add(program.name, std::move(stages), std::move(judged));
  return units;
}

std::vector<ProgramUnit> programUnits(const ShaderPack& pack) {
  std::vector<ProgramUnit> units;
  for (const auto* programs : {&pack.programs, &pack.modPrograms}) {
    for (const ProgramSource& program : *programs) {
      for (ProgramUnit& unit : programUnits(program)) units.push_back(std::move(unit));
    }
  }
  return units;
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

std::string entryFile(const ProgramUnit& unit) {
  const auto& sites = unit.stages.back()->text.sites;
  return sites.empty() ? unit.name : sites.front().file;
}

Diagnostic lostJob(const JobOutcome& outcome, std::string_view tool, const std::string& name,
                   const std::string& file) {
  const bool crashed = outcome.kind == JobOutcome::Kind::Crashed;
  return {.id = crashed ? "compiler-crash" : "compiler-timeout",
          .at = {.file = file},
          .message = crashed
                         ? fmt::format("{} died while checking {}: {}", tool, name, outcome.cause)
                         : fmt::format("{} did not finish checking {} in time", tool, name),
          .hint =
              "leave out parts of the program until the rest compiles: players' drivers may "
              "fail on the same lines"};
}

bool hasUnclosedComment(const ProgramSource& program) {
  return std::ranges::any_of(program.diagnostics,
                             [](const Diagnostic& d) { return d.id == "comment-unclosed"; });
}

void checkWithGlslang(const ShaderPack& pack, int jobs, Verdicts& verdicts, Diagnostics& diagnostics,
                      std::set<std::uint64_t>* quiet, TrialMemo* known) {
  const std::vector<ProgramUnit> units = unitsWithoutVerdict(pack, verdicts);
  if (units.empty()) return;
  std::vector<Diagnostics> found(units.size());
  const SourceLines lines = sourceLinesOf(pack);
  DefinitionIndex index(pack);
  TrialMemo own;
  TrialMemo& trials = known ? *known : own;
  if (jobs > 0) warmUp(units);
  const auto check = [&](size_t i) {
    // Names that a missing file would declare are no further mistakes.
    if (units[i].incomplete || lacksVersion(units[i])) return trials.encode({});
    Diagnostics messages;
    validateWithGlslang(units[i].judged, lines, messages);
    for (const StageText* stage : units[i].judged) checkUnusedSyntax(pack, *stage, messages);
    // What the comment swallows is not looked for elsewhere.
    if (hasErrors(messages) && !hasUnclosedComment(*units[i].program) &&
        !readsOpenEndedFile(pack, units[i])) {
      if (units[i].judged != units[i].stages) explainVersions(units[i].judged, lines, messages);
      explainDoubleIncludes(units[i].judged, messages);
      explainLanguage(index, units[i].judged, messages);
      const Diagnostics errors = messages;
      const IncludeTrial trial = [&](const MissingInclude& added) {
        return fixedBy(pack, units[i], added, errors, trials);
      };
      explainUnknownNames(index, units[i].judged, trial, messages);
    }
    return trials.encode(messages);
  };
  runIsolated({.count = units.size(), .workers = jobs, .work = check},
              [&](size_t i, const JobOutcome& outcome) {
                found[i] = outcome.kind == JobOutcome::Kind::Done
                               ? trials.decode(outcome.result)
                               : Diagnostics{lostJob(outcome, "the compiler", units[i].name,
                                                     entryFile(units[i]))};
                return true;
              });
  mergeMissingIncludes(pack, units, jobs, trials, found);
  for (size_t i = 0; i < units.size(); ++i) {
    verdicts[units[i].hash] = !hasErrors(found[i]) && !units[i].incomplete && !units[i].refused &&
                              !lacksVersion(units[i]);
    if (quiet != nullptr && found[i].empty() && verdicts[units[i].hash]) quiet->insert(units[i].hash);
    if (!units[i].mod.empty()) markAsOfMod(units[i].mod, found[i]);
    if (units[i].mod == kPatchingMod) excuseNamesOfTheMod(found[i]);
    diagnostics.insert(diagnostics.end(), found[i].begin(), found[i].end());
  }
}

Diagnostics ruleNotes(const ShaderPack& pack) {
  struct Uses {
    int times = 0, programs = 0;
    std::string first;  ///< the first of the programs
    SourceLocation at;
  };
  std::map<std::tuple<std::string, std::string, int>, Uses> byPlace;
  const auto add = [&](const ProgramSource& program, const std::string& name,
                       const std::vector<AppliedRule>& rules) {
    for (const AppliedRule& rule : rules) {
      Uses& uses = byPlace[{rule.first.file, rule.rule, rule.first.line}];
      if (uses.programs++ == 0) {
        uses.first = unitName(program, name);
        uses.at = rule.first;
      }
      uses.times += rule.count;
    }
  };
  for (const auto* programs : {&pack.programs, &pack.modPrograms}) {
    for (const ProgramSource& program : *programs) {
      for (const ComputeSource& compute : program.computes)
        add(program, compute.name, compute.rules);
      add(program, program.name, program.rules);
    }
  }
  Diagnostics notes;
  for (const auto& [place, uses] : byPlace) {
    Diagnostic& note = notes.emplace_back();
    note.severity = Severity::Note;
    note.id = "rule-applied";
    note.at = uses.at;
    note.message = fmt::format("rule {} applied {} time{} in {}", std::get<1>(place), uses.times,
                               uses.times == 1 ? "" : "s", uses.first);
    if (uses.programs > 1)
      note.message +=
          fmt::format(" and {} more program{}", uses.programs - 1, uses.programs == 2 ? "" : "s");
  }
  return notes;
}

}  // namespace orris
