#include <orris/check/matrix/matrix_shapes.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include <orris/check/compile/program_check.h>
#include <orris/glsl/tokens/shape.h>

namespace orris {
namespace {

std::vector<std::string> usedNames(const std::vector<std::string>& names,
                                   const std::vector<unsigned char>& uses) {
  std::vector<std::string> used;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    if (uses[i] != 0) used.push_back(names[i]);
  }
  return used;
}

BaseProgram shapesOf(const FolderBuild& build, const ProgramEntry& entry,
                     const ProgramSource& source) {
  BaseProgram program{.source = &source, .files = filesOf(entry)};
  std::set<std::string> ofParts;
  for (std::size_t i = 0; i < partCount(entry); ++i) {
    const PreprocessedPart part = build.buildPart(entry, i);
    program.parts.push_back(shapeOf(part.stream, stageOfPart(entry, i)));
    program.options.push_back(usedNames(build.files().optionNames, part.optionUses));
    ofParts.insert(program.options.back().begin(), program.options.back().end());
  }
  // The program depends on others by directives in comments; any of its parts may hold them.
  for (const std::string& option : source.options) {
    if (ofParts.contains(option)) continue;
    for (auto& options : program.options) {
      options.insert(std::lower_bound(options.begin(), options.end(), option), option);
    }
  }
  program.units = unitShapes(entry, program.parts);
  return program;
}

/// Kind of a value that is a number, with its sign; 0: it is none.
int kindOfValue(std::string_view value) {
  const bool negative = value.starts_with('-');
  const auto kind = numberKind(negative ? value.substr(1) : value);
  return kind ? (negative ? -*kind : *kind) : 0;
}

}  // namespace

std::vector<std::string> filesOf(const ProgramEntry& entry) {
  std::vector<std::string> files;
  for (const auto& [stage, file] : entry.stages) files.push_back(file);
  for (const auto& [name, file] : entry.computes) files.push_back(file);
  return files;
}

UnitShapes unitShapes(const ProgramEntry& entry, const std::vector<std::uint64_t>& parts) {
  UnitShapes units(parts.begin() + static_cast<std::ptrdiff_t>(entry.stages.size()), parts.end());
  if (entry.stages.empty()) return units;
  // Iris makes other texts of one file for a fullscreen program than for terrain.
  const IrisProgram program = irisProgramOf(entry.name);
  std::uint64_t hash = static_cast<std::uint64_t>(program.patch) * 4 +
                       (program.entities ? 2u : 0u) + (program.lines ? 1u : 0u);
  for (std::size_t i = 0; i < entry.stages.size(); ++i) hash = (hash ^ parts[i]) * 0x100000001b3u;
  units.push_back(hash);
  return units;
}

BaseShapes::BaseShapes(const MatrixBase& base, const MatrixPlan& plan) {
  std::set<std::pair<std::size_t, std::string>> wanted;
  for (const MatrixJob& job : plan.jobs) {
    if (job.entry) wanted.emplace(job.build, job.entry->name.program);
  }
  for (const auto& key : wanted) {
    const FolderBuild& build = *plan.builds[key.first];
    const ProgramSource* source = base.folders[key.first].find(key.second);
    const ProgramEntry* entry = build.entryNamed(key.second);
    if (source && entry) programs_.emplace(key, shapesOf(build, *entry, *source));
  }
}

const BaseProgram* BaseShapes::find(const MatrixJob& job) const {
  const auto found = programs_.find({job.build, job.entry->name.program});
  return found == programs_.end() ? nullptr : &found->second;
}

NumberSweeps::Sweep* NumberSweeps::sweepOf(const MatrixJob& job) {
  const BaseProgram* base = shapes_.find(job);
  const FolderBuild& build = *plan_.builds[job.build];
  const OptionValues& values = plan_.configurations[job.configuration];
  const OptionSet& options = build.files().options;
  const auto changed = differingOptions(options, build.values(), values);
  if (!base || changed.size() != 1 || haveCommonName(changed, base->source->conditionOptions) ||
      haveCommonName(changed, build.properties().options) || base->files != filesOf(*job.entry)) {
    return nullptr;
  }
  const int kind = kindOfValue(options.value(values, changed[0]));
  if (kind == 0) return nullptr;
  const auto [sweep, isNew] = sweeps_.try_emplace(
      fmt::format("{} {} {} {}", job.build, job.entry->name.program, changed[0], kind));
  if (isNew && kindOfValue(options.value(build.values(), changed[0])) == kind) {
    sweep->second = {base->units, 1};
  }
  return &sweep->second;
}

std::optional<UnitShapes> NumberSweeps::known(const MatrixJob& job) {
  const Sweep* sweep = sweepOf(job);
  if (!sweep || sweep->values < 2 || sweep->differs) return std::nullopt;
  return sweep->units;
}

void NumberSweeps::learn(const MatrixJob& job, const UnitShapes& units) {
  Sweep* sweep = sweepOf(job);
  if (!sweep) return;
  if (sweep->values++ == 0) sweep->units = units;
  if (sweep->units != units) sweep->differs = true;
}

}  // namespace orris
