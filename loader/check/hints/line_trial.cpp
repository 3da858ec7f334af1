#include <orris/check/hints/line_trial.h>

#include <algorithm>
#include <map>
#include <utility>

#include <orris/glsl/compile/validate.h>
#include <orris/pack/mods/mods.h>

namespace orris {
namespace {

/// Errors by file and text: their lines move with the one that is added.
std::map<std::pair<std::string, std::string>, int> countErrors(const Diagnostics& diagnostics) {
  std::map<std::pair<std::string, std::string>, int> count;
  for (const Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.severity == Severity::Error) ++count[{diagnostic.at.file, diagnostic.message}];
  }
  return count;
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

bool fixedBy(const ShaderPack& pack, const ProgramUnit& unit, const MissingInclude& added,
             const Diagnostics& errors) {
  const auto left = diagnosticsWith(pack, unit, {added.at.file, added.at.line, added.target},
                                    CompileErrors::All);
  if (!left) return false;
  Diagnostics had = unit.program->diagnostics;
  had.insert(had.end(), errors.begin(), errors.end());
  const auto before = countErrors(had), after = countErrors(*left);
  const bool noneIsNew = std::ranges::all_of(after, [&](const auto& error) {
    const auto known = before.find(error.first);
    return known != before.end() && error.second <= known->second;
  });
  return noneIsNew && after != before;
}

}  // namespace orris
