#include <orris/check/hints/line_trial.h>

#include <algorithm>
#include <map>
#include <utility>

#include <orris/glsl/compile/validate.h>
#include <orris/pack/mods/mods.h>

namespace orris {
namespace {

/// Errors by file and text: their lines move with the one that is added.
using ErrorCounts = std::map<std::pair<std::string, std::string>, int>;

ErrorCounts countErrors(const Diagnostics& diagnostics) {
  ErrorCounts count;
  for (const Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.severity == Severity::Error) ++count[{diagnostic.at.file, diagnostic.message}];
  }
  return count;
}

std::uint64_t hashOfTrial(std::uint64_t program, const ErrorCounts& before) {
  const auto add = [&](std::uint64_t value) { program = (program ^ value) * 0x100000001b3u; };
  for (const auto& [error, times] : before) {
    add(std::hash<std::string>()(error.first));
    add(std::hash<std::string>()(error.second));
    add(std::uint64_t(times));
  }
  return program;
}

bool isFixed(const ErrorCounts& before, const ErrorCounts& after) {
  const bool noneIsNew = std::ranges::all_of(after, [&](const auto& error) {
    const auto known = before.find(error.first);
    return known != before.end() && error.second <= known->second;
  });
  return noneIsNew && after != before;
}

}  // namespace

const FolderBuild* buildOf(const ShaderPack& pack, const ProgramSource& program) {
  const auto made = std::ranges::find_if(pack.builds, [&](const auto& build) {
    return build->mod() == modFamilyOf(program.group) && build->folder() == program.folder;
  });
  return made == pack.builds.end() ? nullptr : made->get();
}

std::optional<Diagnostics> diagnosticsWith(const ShaderPack& pack, const ProgramUnit& unit,
                                           const AddedLine& added, CompileErrors wanted) {
  const FolderBuild* build = unit.program ? buildOf(pack, *unit.program) : nullptr;
  const ProgramEntry* entry = build ? build->entryNamed(unit.program->name) : nullptr;
  if (!entry) return std::nullopt;
  const ProgramSource program = build->buildWith(*entry, added);
  const auto units = programUnits(program);
  const auto same = std::ranges::find(units, unit.name, &ProgramUnit::name);
  if (same == units.end()) return std::nullopt;
  Diagnostics left = program.diagnostics;
  validateWithGlslang(
      same->judged, [](const std::string&, int) { return std::string(); }, left, wanted);
  return left;
}

std::optional<std::uint64_t> trialHash(const ShaderPack& pack, const ProgramUnit& unit,
                                       const AddedLine& added) {
  const FolderBuild* build = unit.program ? buildOf(pack, *unit.program) : nullptr;
  const ProgramEntry* entry = build ? build->entryNamed(unit.program->name) : nullptr;
  if (!entry) return std::nullopt;
  // A program is one unit and one more for each of its compute shaders.
  const auto program = build->hashWith(*entry, added);
  return program ? std::optional(*program * 31 + std::hash<std::string>()(unit.name)) : std::nullopt;
}

bool fixedBy(const ShaderPack& pack, const ProgramUnit& unit, const MissingInclude& added,
             const Diagnostics& errors, TrialMemo& trials) {
  const AddedLine line{added.at.file, added.at.line, added.target};
  Diagnostics had = unit.program ? unit.program->diagnostics : Diagnostics();
  had.insert(had.end(), errors.begin(), errors.end());
  const ErrorCounts before = countErrors(had);
  const auto program = trialHash(pack, unit, line);
  const auto trial = program ? std::optional(hashOfTrial(*program, before)) : std::nullopt;
  if (const auto known = trial ? trials.find(*trial) : std::nullopt) return *known != 0;
  const auto left = diagnosticsWith(pack, unit, line, CompileErrors::All);
  const bool fixed = left && isFixed(before, countErrors(*left));
  if (trial) trials.add(*trial, fixed);
  return fixed;
}

}  // namespace orris
