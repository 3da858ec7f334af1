#include "check/common_include.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "check/compile_hints.h"
#include "check/diagnostic_codec.h"
#include "check/include_trial.h"
#include "check/isolated_jobs.h"
#include "check/stage_files.h"

namespace orris {
namespace {

constexpr const char* kMissing = "include-probably-missing";
// Each trial compiles this many programs; the rest are taken to be like them.
constexpr std::size_t kMostSamples = 6;

const Diagnostic* missingOf(const Diagnostics& diagnostics) {
  const auto found = std::ranges::find(diagnostics, kMissing, &Diagnostic::id);
  return found == diagnostics.end() ? nullptr : &*found;
}

class CommonInclude {
 public:
  CommonInclude(const ShaderPack& pack, const std::vector<ProgramUnit>& units,
                const std::vector<Diagnostics>& found)
      : pack_(pack), units_(units), found_(found), index_(pack) {
    std::set<std::pair<std::string, int>> places;
    for (std::size_t i = 0; i < units.size(); ++i) {
      const Diagnostic* missing = missingOf(found[i]);
      if (!missing) continue;
      ++failing_;
      if (places.emplace(missing->at.file, missing->at.line).second &&
          samples_.size() < kMostSamples)
        samples_.push_back(i);
    }
  }

  bool areSeveral() const { return samples_.size() > 1; }

  /// The one line that heals all samples, as a diagnostic.
  std::optional<Diagnostic> find() {
    std::optional<MissingInclude> healing;
    const IncludeTrial trial = [&](const MissingInclude& added) {
      if (!healing && healsAll(added)) healing = added;
      return healing.has_value();
    };
    const std::vector<UnknownName> names = unknownNames();
    findMissingIncludes(index_, commonFiles(), names, trial);
    if (!healing) return std::nullopt;
    const UnknownName& name = names[healing->first];
    return Diagnostic{
        .severity = Severity::Error,
        .id = kMissing,
        .at = healing->at,
        .message = fmt::format("'{}' is unknown at {}:{}, and {} program{} like this: an #include "
                               "seems to be missing here",
                               name.name, name.at.file, name.at.line, failing_ - 1,
                               failing_ == 2 ? " more is" : "s more are"),
        .sourceLine = pack_.sourceLine(healing->at.file, healing->at.line),
        .hint = fmt::format("#include \"{}\"", healing->target)};
  }

 private:
  bool healsAll(const MissingInclude& added) const {
    return std::ranges::all_of(samples_, [&](std::size_t i) {
      Diagnostics errors = found_[i];
      std::erase_if(errors, [](const Diagnostic& d) { return d.id == kMissing; });
      return healsWith(pack_, units_[i], added, errors);
    });
  }

  /// Files that all samples read, in the order of the first one's text.
  std::vector<std::string> commonFiles() {
    std::vector<std::string> common = filesOf(index_, failingStage(samples_.front()));
    for (const std::size_t i : samples_) {
      const std::vector<std::string> files = filesOf(index_, failingStage(i));
      std::erase_if(common, [&](const std::string& file) {
        return std::ranges::find(files, file) == files.end();
      });
    }
    return common;
  }

  /// The stage that the first error of a unit is in.
  const StageText& failingStage(std::size_t i) {
    const auto& stages = units_[i].stages;
    for (const Diagnostic& diagnostic : found_[i]) {
      for (const StageText* stage : stages) {
        if (diagnostic.severity == Severity::Error && lineOf(*stage, diagnostic.at) > 0)
          return *stage;
      }
    }
    return *stages.back();
  }

  std::vector<UnknownName> unknownNames() const {
    std::vector<UnknownName> names;
    for (const std::size_t i : samples_) {
      for (const Diagnostic& diagnostic : found_[i]) {
        const std::string name = unknownName(diagnostic.message);
        if (!name.empty() && diagnostic.id != kMissing)
          names.push_back({name, diagnostic.at, diagnostic.includedFrom});
      }
    }
    return names;
  }

  const ShaderPack& pack_;
  const std::vector<ProgramUnit>& units_;
  const std::vector<Diagnostics>& found_;
  DefinitionIndex index_;
  std::vector<std::size_t> samples_;  ///< units that were told different places
  int failing_ = 0;                   ///< units in all that were told any
};

}  // namespace

void mergeMissingIncludes(const ShaderPack& pack, const std::vector<ProgramUnit>& units,
                          std::vector<Diagnostics>& found) {
  CommonInclude common(pack, units, found);
  if (!common.areSeveral()) return;
  Diagnostics merged;
  const auto work = [&](std::size_t) {
    const auto one = common.find();
    return encodeDiagnostics(one ? Diagnostics{*one} : Diagnostics{});
  };
  runIsolated({.count = 1, .workers = 1, .work = work}, [&](std::size_t, JobOutcome outcome) {
    if (outcome.kind == JobOutcome::Kind::Done) merged = decodeDiagnostics(outcome.result);
    return true;
  });
  if (merged.empty()) return;
  bool told = false;
  for (Diagnostics& diagnostics : found) {
    // What else a program lacks stays told.
    const auto had = std::erase_if(diagnostics, [&](const Diagnostic& d) {
      return d.id == kMissing && d.hint == merged.front().hint;
    });
    if (had > 0 && !told) diagnostics.push_back(merged.front());
    told = told || had > 0;
  }
  if (!told) found.front().push_back(merged.front());
}

}  // namespace orris
