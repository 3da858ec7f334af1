#include "check/missing_include.h"

#include <algorithm>
#include <set>

#include "pack/text.h"

namespace orris {
namespace {

using Includes = std::vector<IncludeLine>;

bool includes(const Includes& lines, const std::string& target) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const IncludeLine& line) { return line.target == target; });
}

/// Files of the same name, in other folders, are versions of one program.
std::string_view fileName(std::string_view path) { return path.substr(path.rfind('/') + 1); }

// So that a file without any #include left still has models, the nearest in name.
constexpr double kSomeLikeness = 0.01;
// An empty line beside an #include is where one was taken out.
constexpr double kGapBonus = 0.5;

/// How much two files include the same: 0 to 1, more for files of the same name.
double likeness(const std::string& file, const Includes& a, const std::string& other,
                const Includes& b) {
  std::size_t common = 0;
  for (const IncludeLine& line : a) common += includes(b, line.target) ? 1 : 0;
  const double all = static_cast<double>(a.size() + b.size() - common);
  const double bonus = fileName(file) == fileName(other) ? 1 : 0;
  return (all > 0 ? static_cast<double>(common) / all : 0) + bonus + kSomeLikeness;
}

bool isBlank(const FileLines& lines, int line) {
  return line >= 1 && static_cast<std::size_t>(line) <= lines.size() &&
         trim(lines[static_cast<std::size_t>(line) - 1]).empty();
}

bool isBesideInclude(const Includes& includes, int line) {
  return std::any_of(includes.begin(), includes.end(), [line](const IncludeLine& include) {
    return include.line == line - 1 || include.line == line + 1;
  });
}

/// The only blank line between two #include lines, 0 when there is none or more than one.
int onlyGap(const FileLines& lines, const Includes& includes) {
  int found = 0;
  for (std::size_t i = 1; i < includes.size(); ++i) {
    const int line = includes[i].line - 1;
    if (includes[i - 1].line != line - 1 || !isBlank(lines, line)) continue;
    if (found > 0) return 0;
    found = line;
  }
  return found;
}

/// The line of `lines` that reads like `text`, 0 unless there is exactly one.
int lineLike(const FileLines& lines, std::string_view text) {
  int found = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (trim(lines[i]) != text) continue;
    if (found > 0) return 0;
    found = static_cast<int>(i) + 1;
  }
  return found;
}

/// Where the line `wanted` of `model` would stand in `lines`: at its distance from the nearest line
/// above, else below, that both have; 0 when there is none.
int placeLike(const FileLines& lines, const FileLines& model, int wanted) {
  constexpr int kFarthest = 8;
  for (const int step : {-1, 1}) {
    for (int i = 1; i <= kFarthest; ++i) {
      const int neighbour = wanted + step * i;
      if (neighbour < 1 || static_cast<std::size_t>(neighbour) > model.size()) break;
      const std::string_view text = trim(model[static_cast<std::size_t>(neighbour) - 1]);
      const int same = text.size() < 3 ? 0 : lineLike(lines, text);
      if (same > 0) return std::clamp(same - step * i, 1, static_cast<int>(lines.size()));
    }
  }
  return 0;
}

/// The first blank line behind an #include and before the name is needed, else behind the last one.
int placeInGap(const FileLines& lines, const Includes& here, int neededAt) {
  int last = here.empty() ? neededAt - 1 : 0;
  for (const IncludeLine& include : here) {
    if (neededAt > 0 && include.line > neededAt) break;
    if (last > 0 && include.line == last + 2 && isBlank(lines, last + 1)) return last + 1;
    last = include.line;
  }
  return last + 1;
}

class Search {
 public:
  Search(DefinitionIndex& index, const std::vector<std::string>& reached, const Diagnostic& error,
         std::string definer)
      : index_(index), reached_(reached.begin(), reached.end()), definer_(std::move(definer)) {
    neededAt_[error.at.file] = error.at.line;
    for (const SourceLocation& from : error.includedFrom) neededAt_.emplace(from.file, from.line);
  }

  /// The best pair of a file of the stage and one like it that includes the definer.
  std::optional<MissingInclude> byModel() {
    double best = 0;
    std::optional<MissingInclude> result;
    for (const auto& [model, lines] : index_.files()) {
      const Includes& there = index_.includesOf(model);
      for (const IncludeLine& line : there) {
        if (reached_.contains(line.target) || !leadsToDefiner(line.target)) continue;
        for (const std::string& file : reached_) {
          if (file == model || includes(index_.includesOf(file), line.target)) continue;
          const FileLines& own = index_.files().at(file);
          const Includes& here = index_.includesOf(file);
          const int gapLine = onlyGap(own, here);
          const bool useGap = gapLine > 0 && !isTooLate(file, gapLine);
          const int at = useGap ? gapLine : placeLike(own, lines, line.line);
          if (at == 0 || isTooLate(file, at)) continue;
          const double gap = isBlank(own, at) && isBesideInclude(here, at) ? kGapBonus : 0;
          const double score = likeness(file, here, model, there) + gap;
          if (score <= best) continue;
          best = score;
          result = {{file, at, 0}, line.target, {model, line.line, 0}};
        }
      }
    }
    return result;
  }

  MissingInclude byGap(const SourceLocation& user) {
    const auto found = index_.files().find(user.file);
    static const FileLines kNone;
    const FileLines& lines = found == index_.files().end() ? kNone : found->second;
    return {
        {user.file, placeInGap(lines, index_.includesOf(user.file), user.line), 0}, definer_, {}};
  }

 private:
  bool isTooLate(const std::string& file, int line) const {
    const auto needed = neededAt_.find(file);
    return needed != neededAt_.end() && line >= needed->second;
  }

  bool leadsToDefiner(const std::string& target) {
    const auto [known, isNew] = leads_.try_emplace(target);
    if (isNew) known->second = index_.reaches(target, definer_);
    return known->second;
  }

  DefinitionIndex& index_;
  std::set<std::string> reached_;
  std::string definer_;
  std::map<std::string, int> neededAt_;  ///< line by which each file must have it
  std::map<std::string, bool> leads_;
};

}  // namespace

std::optional<MissingInclude> findMissingInclude(DefinitionIndex& index,
                                                 const std::vector<std::string>& reached,
                                                 const Diagnostic& error,
                                                 const std::string& definer) {
  std::vector<std::string> known;
  for (const std::string& file : reached) {
    if (index.files().contains(file)) known.push_back(file);
  }
  if (known.empty()) return std::nullopt;
  Search search(index, known, error, definer);
  if (auto found = search.byModel()) return found;
  return search.byGap(error.at);
}

}  // namespace orris
