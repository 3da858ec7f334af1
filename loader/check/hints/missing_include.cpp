#include <orris/check/hints/missing_include.h>

#include <algorithm>
#include <map>
#include <set>

#include <orris/check/hints/include_place.h>
#include <orris/core/files/pack_path.h>
#include <orris/pack/mods/voxy.h>

namespace orris {
namespace {

// Packs are untrusted, and the best candidates come first.
constexpr std::size_t kMostTargets = 64, kMostFiles = 128, kMostCandidates = 16;
// Places tried in one file, and trials in all: each compiles the program once.
constexpr std::size_t kPlacesOfFile = 4, kMostTrials = 16;

// What speaks for a file and what it should include, beside likeness() to one that does.
constexpr double kAllNames = 3;     // it makes all names known
constexpr double kAllPeers = 1;     // all files beside it do the same
constexpr double kOrphan = 0.8;     // nothing includes the target any more
constexpr double kUser = 0.5;       // the file itself uses the name
constexpr double kSameStem = 0.7;   // world0/final.fsh of program/final.glsl
constexpr double kInChain = 0.3;    // the use is in the file, or included by it
constexpr double kGap = 0.5;        // a blank line beside an #include
constexpr double kNextPlace = 0.3;  // what a place loses to the likelier one before it

std::string_view stemOf(std::string_view path) {
  path = path.substr(path.rfind('/') + 1);
  return path.substr(0, path.rfind('.'));
}

std::string_view suffixOf(std::string_view path) {
  const std::size_t dot = path.rfind('.');
  return dot == std::string_view::npos ? "" : path.substr(dot);
}

struct Candidate {
  std::string file, target;
  std::set<std::size_t> names;  ///< those that the target makes known
  double score = 0;
  int before = 0;
};

/// A candidate at one of its places.
struct Placed {
  MissingInclude include;
  std::set<std::size_t> names;
  double score = 0;
};

class Search {
 public:
  Search(DefinitionIndex& index, const std::vector<std::string>& reached,
         const std::vector<UnknownName>& names, const IncludeTrial& trial)
      : index_(index), names_(names), trial_(trial) {
    for (const std::string& file : reached) {
      if (!index.files().contains(file) || !order_.try_emplace(file, order_.size()).second)
        continue;
      if (files_.size() < kMostFiles) files_.push_back(file);
    }
  }

  std::vector<MissingInclude> run() {
    findTargets();
    std::set<std::size_t> open;
    for (std::size_t i = 0; i < names_.size(); ++i) open.insert(i);
    std::vector<MissingInclude> result;
    while (!open.empty()) {
      const auto best = bestOf(open);
      if (!best) break;
      result.push_back(best->first);
      for (const std::size_t name : best->second) open.erase(name);
    }
    return result;
  }

 private:
  /// The files that would make each name known: its definers and what leads to them.
  void findTargets() {
    for (std::size_t i = 0; i < names_.size(); ++i) {
      std::vector<std::string> queue;
      for (const SourceLocation& definition : index_.definitionsOf(names_[i].name))
        queue.push_back(definition.file);
      std::set<std::string> seen;
      while (!queue.empty() && seen.size() < kMostTargets) {
        const std::string file = queue.back();
        queue.pop_back();
        if (order_.contains(file) || !seen.insert(file).second) continue;
        if (isTarget(file, names_[i].name)) targets_[file].insert(i);
        for (const SourceLocation& includer : index_.includersOf(file))
          queue.push_back(includer.file);
      }
    }
  }

  // Entry files are not included by others, and what holds main is no library.
  bool isTarget(const std::string& file, const std::string& name) {
    const bool isEntry = file.ends_with("sh") || isVoxyFile(file);
    if (isEntry && index_.includersOf(file).empty()) return false;
    return name == "main" || !leadsToMain(file);
  }

  bool leadsToMain(const std::string& file) {
    const auto [known, isNew] = leadsToMain_.try_emplace(file);
    if (isNew) {
      known->second = std::ranges::any_of(
          index_.definitionsOf("main"),
          [&](const SourceLocation& main) { return index_.reaches(file, main.file); });
    }
    return known->second;
  }

  std::optional<std::pair<MissingInclude, std::set<std::size_t>>> bestOf(
      const std::set<std::size_t>& open) {
    std::vector<Candidate> candidates;
    for (const auto& [target, known] : targets_) {
      std::set<std::size_t> names;
      std::ranges::set_intersection(known, open, std::inserter(names, names.end()));
      if (names.empty()) continue;
      for (const std::string& file : files_) {
        if (auto candidate = weigh(file, target, names)) candidates.push_back(*candidate);
      }
    }
    std::ranges::stable_sort(candidates, std::ranges::greater(), &Candidate::score);
    candidates.resize(std::min(candidates.size(), kMostCandidates));
    return firstThatWorks(placed(candidates, open.size()));
  }

  std::optional<std::pair<MissingInclude, std::set<std::size_t>>> firstThatWorks(
      const std::vector<Placed>& places) {
    for (const Placed& place : places) {
      if (trials_ == kMostTrials) break;
      ++trials_;
      if (trial_(place.include)) return {{place.include, place.names}};
    }
    if (places.empty()) return std::nullopt;
    return {{places.front().include, places.front().names}};
  }

  std::optional<Candidate> weigh(const std::string& file, const std::string& target,
                                 const std::set<std::size_t>& names) {
    Candidate candidate{file, target, names};
    for (const IncludeLine& line : index_.includesOf(file)) {
      if (line.target == target) return std::nullopt;
    }
    bool inChain = false, isUser = false;
    for (const std::size_t i : names) {
      isUser = isUser || names_[i].at.file == file;
      const auto user = order_.find(names_[i].at.file);
      if (user != order_.end() && order_.at(file) > user->second) return std::nullopt;
      const int needed = neededAt(names_[i], file);
      inChain = inChain || needed > 0;
      if (needed > 0)
        candidate.before = candidate.before ? std::min(candidate.before, needed) : needed;
    }
    const auto& includers = index_.includersOf(target);
    double likest = 0;
    for (const SourceLocation& model : includers)
      likest = std::max(likest, likeness(index_, file, model.file));
    candidate.score = likest + kAllPeers * shareOfPeers(file, target) +
                      (includers.empty() ? kOrphan : 0) + (inChain ? kInChain : 0) +
                      (isUser ? kUser : 0) + (stemOf(file) == stemOf(target) ? kSameStem : 0);
    return candidate;
  }

  /// The line of `file` by which the name must be known, 0 when `file` does not lead to its use.
  static int neededAt(const UnknownName& name, const std::string& file) {
    if (name.at.file == file) return name.at.line;
    for (const SourceLocation& from : name.includedFrom) {
      if (from.file == file) return from.line;
    }
    return 0;
  }

  /// How many of the files beside `file` include the target: 0 to 1.
  double shareOfPeers(const std::string& file, const std::string& target) {
    const std::string_view folder = packPathParent(file), suffix = suffixOf(file);
    const auto isPeer = [&](const std::string& other) {
      return other != file && packPathParent(other) == folder && suffixOf(other) == suffix;
    };
    const auto [count, isNew] = peers_.try_emplace(file);
    if (isNew) {
      for (const auto& [other, lines] : index_.files()) count->second += isPeer(other) ? 1 : 0;
    }
    std::set<std::string_view> same;
    for (const SourceLocation& includer : index_.includersOf(target)) {
      if (isPeer(includer.file)) same.insert(includer.file);
    }
    return count->second < 2 ? 0 : double(same.size()) / double(count->second);
  }

  /// The places of all candidates, the likeliest first.
  std::vector<Placed> placed(const std::vector<Candidate>& candidates, std::size_t open) {
    std::vector<Placed> all;
    for (const Candidate& candidate : candidates) {
      auto places =
          placesByModels(index_, candidate.file, candidate.target, candidate.before, kPlacesOfFile);
      // Without a model only a file on the way to the use says where.
      if (candidate.before > 0) {
        const double share = places.empty() ? 1 : 0;
        places.push_back(
            {placeBehindIncludes(index_, candidate.file, candidate.before), {}, false, share});
        places.push_back({1, {}, false, 0});
      }
      double score =
          candidate.score + kAllNames * double(candidate.names.size()) / double(open) + kNextPlace;
      for (const IncludePlace& place : places) {
        score -= kNextPlace;
        all.push_back({{{candidate.file, place.line, 0},
                        candidate.target,
                        place.model,
                        *candidate.names.begin(),
                        place.share},
                       candidate.names,
                       score + (place.gap ? kGap : 0)});
      }
    }
    std::ranges::stable_sort(all, std::ranges::greater(), &Placed::score);
    return all;
  }

  DefinitionIndex& index_;
  const std::vector<UnknownName>& names_;
  const IncludeTrial& trial_;
  std::size_t trials_ = 0;
  std::vector<std::string> files_;
  std::map<std::string, std::size_t> order_;  ///< of the first text of each file
  std::map<std::string, std::set<std::size_t>> targets_;
  std::map<std::string, bool> leadsToMain_;
  std::map<std::string, std::size_t> peers_;
};

}  // namespace

std::vector<MissingInclude> findMissingIncludes(DefinitionIndex& index,
                                                const std::vector<std::string>& reached,
                                                const std::vector<UnknownName>& names,
                                                const IncludeTrial& trial) {
  return Search(index, reached, names, trial).run();
}

}  // namespace orris
