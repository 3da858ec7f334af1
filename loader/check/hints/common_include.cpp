#include <orris/check/hints/common_include.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include <orris/check/compile/stage_files.h>
#include <orris/check/hints/compile_hints.h>
#include <orris/check/hints/line_trial.h>
#include <orris/check/workers/isolated_jobs.h>

namespace orris {
namespace {

constexpr const char* kMissing = "include-probably-missing";
// Each trial compiles this many programs; the rest are taken to be like them.
constexpr std::size_t kMostSamples = 6, kMostAlike = 2;
// Each place takes up to 16 trials.
constexpr std::size_t kMostPlaces = 4, kMostOthers = 3;
// Less likely places in a file, compared with its likeliest, are not reported.
constexpr double kAsLikely = 0.4;

const Diagnostic* missingOf(const Diagnostics& diagnostics) {
  const auto found = std::ranges::find(diagnostics, kMissing, &Diagnostic::id);
  return found == diagnostics.end() ? nullptr : &*found;
}

/// Units that lack an include of something.
using Samples = std::vector<std::size_t>;

class CommonInclude {
 public:
  CommonInclude(const ShaderPack& pack, const std::vector<ProgramUnit>& units,
                const std::vector<Diagnostics>& found, TrialMemo& trials)
      : pack_(pack), units_(units), found_(found), trials_(trials), index_(pack) {
    for (std::size_t i = 0; i < units.size(); ++i) {
      const Diagnostic* missing = missingOf(found[i]);
      if (!missing) continue;
      ++failing_;
      places_[{missing->at.file, missing->at.line}].push_back(i);
    }
  }

  /// The one line that repairs a unit of each place, first, and then others that do; else of each place
  /// the others.
  Diagnostics find() {
    Diagnostics reported;
    Samples ofAll;
    for (const auto& [place, units] : places_) {
      if (ofAll.size() < kMostSamples) ofAll.push_back(units.front());
    }
    if (ofAll.size() > 1) reportAll(ofAll, reported);
    if (!reported.empty()) return reported;
    std::size_t tried = 0;
    for (auto& [place, units] : places_) {
      if (tried++ == kMostPlaces) break;
      Samples alike = units;
      alike.resize(std::min(alike.size(), kMostAlike));
      reported.push_back(*missingOf(found_[alike.front()]));
      addOthers(fixing(alike), reported.back());
    }
    return reported;
  }

 private:
  void reportAll(const Samples& samples, Diagnostics& reported) {
    const std::vector<MissingInclude> places = fixing(samples);
    if (places.empty()) return;
    const MissingInclude& first = places.front();
    const UnknownName name = unknownNames(samples)[first.first];
    reported.push_back(
        {.severity = Severity::Error,
         .id = kMissing,
         .at = first.at,
         .message = fmt::format("'{}' is unknown at {}:{}, and {} program{} like this: an #include "
                                "seems to be missing here",
                                name.name, name.at.file, name.at.line, failing_ - 1,
                                failing_ == 2 ? " more is" : "s more are"),
         .sourceLine = pack_.sourceLine(first.at.file, first.at.line),
         .hint = hintOf(first),
         .repair = LineEdit{first.at.file, first.at.line, hintOf(first)}});
    addOthers(places, reported.back());
  }

  void addOthers(const std::vector<MissingInclude>& places, Diagnostic& first) const {
    std::size_t others = 0;
    for (const MissingInclude& place : places) {
      const bool same = place.at.file == first.at.file && place.at.line == first.at.line;
      if (same || others++ == kMostOthers) continue;
      first.related.push_back({place.at, fmt::format("or {} belongs here", hintOf(place))});
    }
  }

  static std::string hintOf(const MissingInclude& missing) {
    return fmt::format("#include \"{}\"", missing.target);
  }

  /// The places, the likeliest first, where one line repairs all of them; no more than are reported.
  std::vector<MissingInclude> fixing(const Samples& samples) {
    std::vector<MissingInclude> places;
    const IncludeTrial trial = [&](const MissingInclude& added) {
      const bool known = std::ranges::any_of(places, [&](const MissingInclude& place) {
        return place.at == added.at && place.target == added.target;
      });
      const bool likely = places.empty() || added.share >= kAsLikely;
      if (!known && likely && fixesAll(samples, added)) places.push_back(added);
      return places.size() > kMostOthers;
    };
    findMissingIncludes(index_, commonFiles(samples), unknownNames(samples), trial);
    return places;
  }

  bool fixesAll(const Samples& samples, const MissingInclude& added) {
    return std::ranges::all_of(samples, [&](std::size_t i) {
      Diagnostics errors = found_[i];
      std::erase_if(errors, [](const Diagnostic& d) { return d.id == kMissing; });
      return fixedBy(pack_, units_[i], added, errors, trials_);
    });
  }

  /// Files that all samples read, in the order of the first one's text.
  std::vector<std::string> commonFiles(const Samples& samples) {
    std::vector<std::string> common = filesOf(index_, failingStage(samples.front()));
    for (const std::size_t i : samples) {
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

  std::vector<UnknownName> unknownNames(const Samples& samples) const {
    std::vector<UnknownName> names;
    for (const std::size_t i : samples) {
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
  TrialMemo& trials_;
  DefinitionIndex index_;
  std::map<std::pair<std::string, int>, Samples> places_;  ///< which lack an #include where
  int failing_ = 0;                                        ///< units in all that lack any
};

/// Puts findings with more places in for those that are there already; false: these are new.
bool replaceEqual(const Diagnostics& better, std::vector<Diagnostics>& found) {
  bool any = false;
  for (Diagnostics& diagnostics : found) {
    for (Diagnostic& d : diagnostics) {
      const auto same = std::ranges::find_if(better, [&](const Diagnostic& other) {
        return other.id == d.id && other.at == d.at && other.message == d.message;
      });
      if (same == better.end()) continue;
      d = *same;
      any = true;
    }
  }
  return any;
}

}  // namespace

void mergeMissingIncludes(const ShaderPack& pack, const std::vector<ProgramUnit>& units, int jobs,
                          TrialMemo& trials, std::vector<Diagnostics>& found) {
  const auto first = std::ranges::find_if(found, missingOf);
  if (first == found.end()) return;
  Diagnostics reported;
  const auto work = [&](std::size_t) {
    return trials.encode(CommonInclude(pack, units, found, trials).find());
  };
  runIsolated({.count = 1, .workers = jobs, .work = work}, [&](std::size_t, JobOutcome outcome) {
    if (outcome.kind == JobOutcome::Kind::Done) reported = trials.decode(outcome.result);
    return true;
  });
  if (reported.empty()) return;
  if (replaceEqual(reported, found)) return;
  for (Diagnostics& diagnostics : found) {
    // What else a program lacks stays.
    std::erase_if(diagnostics, [&](const Diagnostic& d) {
      return d.id == kMissing && d.hint == reported.front().hint;
    });
  }
  first->insert(first->end(), reported.begin(), reported.end());
}

}  // namespace orris
