#include <orris/check/interface/declaration_checks.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include <orris/check/pack/version_checks.h>
#include <orris/glsl/compile/compiler_log.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

using ProgramCheck = void (*)(const ProgramInterface&, DeclarationReport&);

// In the order of the report.
constexpr ProgramCheck kChecks[] = {checkVaryings, checkNames, checkNewNames, checkOutputs,
                                    checkResourceCounts};

// A declaration in a shared file may not fit those of many programs.
constexpr std::size_t kMostPartners = 3;

std::string keyOfPlace(const Diagnostic& d) {
  return fmt::format("{}:{}:{}:{}", d.at.file, d.at.line, d.id, d.message);
}

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

/// Calls `visit` for each set of stages that link together.
template <typename Visit>
void forEachInterface(const ShaderPack& pack, const Visit& visit) {
  for (const ProgramSource& program : pack.programs) {
    for (const ComputeSource& compute : program.computes) visit(interfaceOf(program, compute));
    if (!program.stages.empty()) visit(interfaceOf(program));
  }
}

}  // namespace

std::string ProgramInterface::name() const {
  const std::string& own = compute ? compute->name : program->name;
  return (program->folder == "/" ? "/" : program->folder + "/") + own;
}

Diagnostic DeclarationReport::locateFinding(const StageInterface& stage, const TextPlace& place,
                                            Finding finding) const {
  LogEntry entry{finding.severity, place.line, place.column, std::move(finding.message),
                 std::move(finding.notes)};
  const ShaderPack& pack = folder.pack;
  Diagnostic diagnostic = locateLogEntry(
      entry, std::move(finding.id), *stage.stage,
      [&pack](const std::string& file, int line) { return pack.sourceLine(file, line); });
  diagnostic.hint = std::move(finding.hint);
  diagnostic.related = std::move(finding.related);
  return diagnostic;
}

void DeclarationReport::add(const StageInterface& stage, const TextPlace& place, Finding finding) {
  const SourceLocation at = stage.stage->text.locate(place.line, place.column);
  if (at.file.empty() || known(at, finding)) return;
  diagnostics_.push_back(locateFinding(stage, place, std::move(finding)));
}

void DeclarationReport::addPair(const Side& from, const Side& to, const Finding& finding) {
  pairs_.push_back({locateFinding(from.stage, from.place, finding),
                    locateFinding(to.stage, to.place, finding)});
}

void DeclarationReport::finishPairs() {
  std::map<std::string, std::set<std::string>> partners;  // of each `from`, distinct places
  for (const Pair& pair : pairs_)
    partners[keyOfPlace(pair.from)].insert(keyOfPlace(pair.to));
  std::map<std::string, std::size_t> made;  // index of the finding at a place
  for (Pair& pair : pairs_) {
    const bool atFrom = partners.at(keyOfPlace(pair.from)).size() > 1;
    Diagnostic& here = atFrom ? pair.from : pair.to;
    const Diagnostic& there = atFrom ? pair.to : pair.from;
    const auto [known, isNew] = made.try_emplace(keyOfPlace(here), diagnostics_.size());
    if (isNew) diagnostics_.push_back(here);
    Diagnostic& finding = diagnostics_[known->second];
    finding.severity = std::max(finding.severity, here.severity);
    const RelatedPlace place{there.at, "the other declaration"};
    std::vector<RelatedPlace>& related = finding.related;
    if (related.size() < kMostPartners && std::ranges::find(related, place) == related.end())
      related.push_back(place);
  }
  pairs_.clear();
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

// The first line of the final text is the host's #version, and comes from its author's.
int DeclarationReport::writtenVersion(const StageInterface& stage) const {
  const SourceLocation at = stage.stage->text.locate(1, 1);
  const std::string line = folder.pack.sourceLine(at.file, at.line);
  const std::size_t word = line.find("#version");
  if (word == std::string::npos) return 0;
  const std::string_view rest = trim(std::string_view(line).substr(word + 8));
  return static_cast<int>(parseInteger(leadingWord(rest)).value_or(0));
}

std::string DeclarationReport::placeName(const StageInterface& stage, const TextPlace& place) {
  const SourceLocation at = stage.stage->text.locate(place.line, place.column);
  return at.file.empty() ? "text added by the host" : fmt::format("{}:{}", at.file, at.line);
}

void checkDeclarations(const FolderInput& input, Diagnostics& diagnostics) {
  DeclarationReport report(input, diagnostics);
  forEachInterface(input.pack, [&](const ProgramInterface& program) { check(program, report); });
  report.finishPairs();
}

std::set<std::string> programsThatDoNotLink(const FolderInput& input) {
  std::set<std::string> names;
  forEachInterface(input.pack, [&](const ProgramInterface& program) {
    Diagnostics found;
    DeclarationReport report(input, found);
    checkVaryings(program, report);
    report.finishPairs();
    if (hasErrors(found)) names.insert(program.name());
  });
  return names;
}

}  // namespace orris
