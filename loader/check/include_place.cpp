#include "check/include_place.h"

#include <algorithm>
#include <map>

#include "core/pack_path.h"
#include "pack/text.h"

namespace orris {
namespace {

using Includes = std::vector<IncludeLine>;

// Packs are untrusted: more models would tell nothing new.
constexpr std::size_t kMostModels = 128;
// So that a file without any #include left still has models, the nearest in name.
constexpr double kSomeLikeness = 0.01;
constexpr double kSameName = 1, kAlikeNames = 0.6;
// A blank line beside an #include is where one was taken out.
constexpr double kGapFactor = 1.5;
// What every model says for the one line that looks as if something was taken out.
constexpr double kGapShare = 0.8;

std::string_view fileName(std::string_view path) { return path.substr(path.rfind('/') + 1); }

bool includes(const Includes& lines, const std::string& target) {
  return std::ranges::any_of(lines, [&](const auto& line) { return line.target == target; });
}

bool isBlank(const FileLines& lines, int line) {
  return line >= 1 && static_cast<std::size_t>(line) <= lines.size() &&
         trim(lines[static_cast<std::size_t>(line) - 1]).empty();
}

bool isGap(const FileLines& lines, const Includes& includes, int line) {
  const auto beside = [line](const IncludeLine& include) {
    return include.line == line - 1 || include.line == line + 1;
  };
  return isBlank(lines, line) && std::ranges::any_of(includes, beside);
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

/// Where a line was taken out: in the longest run of blank lines, 0 unless there is exactly one.
int onlyScar(const FileLines& lines, int before) {
  int longest = 1, found = 0, run = 0;
  const int last = before > 0 ? before - 1 : static_cast<int>(lines.size());
  for (int line = 1; line <= last; ++line) {
    if (!isBlank(lines, line)) {
      run = 0;
      continue;
    }
    if (++run < longest) continue;
    // Of three the one between, of two the second.
    found = run > longest ? line : 0;
    longest = run;
  }
  return found == 0 ? 0 : longest > 2 ? found - longest / 2 : found;
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
  for (int i = 1; i <= kFarthest; ++i) {
    for (const int step : {-1, 1}) {
      const int neighbour = wanted + step * i;
      if (neighbour < 1 || static_cast<std::size_t>(neighbour) > model.size()) continue;
      const std::string_view text = trim(model[static_cast<std::size_t>(neighbour) - 1]);
      const int same = text.size() < 3 ? 0 : lineLike(lines, text);
      if (same > 0) return std::clamp(same - step * i, 1, static_cast<int>(lines.size()));
    }
  }
  return 0;
}

const FileLines& linesOf(DefinitionIndex& index, const std::string& file) {
  static const FileLines kNone;
  const auto found = index.files().find(file);
  return found == index.files().end() ? kNone : found->second;
}

/// 0 to 1 for files beside each other whose names begin alike.
double nameLikeness(std::string_view a, std::string_view b) {
  constexpr std::size_t kShortest = 4;
  if (packPathParent(a) != packPathParent(b)) return 0;
  a = fileName(a).substr(0, fileName(a).rfind('.'));
  b = fileName(b).substr(0, fileName(b).rfind('.'));
  const auto same = static_cast<std::size_t>(std::ranges::mismatch(a, b).in1 - a.begin());
  return same < kShortest ? 0 : static_cast<double>(same) / double(std::max(a.size(), b.size()));
}

}  // namespace

double likeness(DefinitionIndex& index, const std::string& file, const std::string& other) {
  const Includes& a = index.includesOf(file);
  const Includes& b = index.includesOf(other);
  std::size_t common = 0;
  for (const IncludeLine& line : a) common += includes(b, line.target) ? 1 : 0;
  const double all = static_cast<double>(a.size() + b.size() - common);
  const double bonus = fileName(file) == fileName(other) ? kSameName : 0;
  return (all > 0 ? static_cast<double>(common) / all : 0) + bonus + kSomeLikeness +
         kAlikeNames * nameLikeness(file, other);
}

IncludePlace placeByModels(DefinitionIndex& index, const std::string& file,
                           const std::string& target, int before) {
  const FileLines& lines = linesOf(index, file);
  const Includes& here = index.includesOf(file);
  struct Vote {
    double weight = 0, best = 0;
    SourceLocation model;
  };
  std::map<int, Vote> votes;
  const int gap = onlyGap(lines, here);
  const int only = gap > 0 ? gap : onlyScar(lines, before);
  const auto& includers = index.includersOf(target);
  for (std::size_t i = 0; i < std::min(includers.size(), kMostModels); ++i) {
    const SourceLocation& model = includers[i];
    if (model.file == file) continue;
    const double weight = likeness(index, file, model.file);
    const auto vote = [&](int line, double share) {
      if (line == 0 || (before > 0 && line >= before)) return;
      Vote& votesOfLine = votes[line];
      votesOfLine.weight += share * weight;
      if (weight <= votesOfLine.best) return;
      votesOfLine.best = weight;
      votesOfLine.model = model;
    };
    vote(placeLike(lines, linesOf(index, model.file), model.line), 1);
    vote(only, kGapShare);
  }
  IncludePlace place;
  double most = 0;
  for (const auto& [line, vote] : votes) {
    const bool isOut = line == only || isGap(lines, here, line);
    const double weight = vote.weight * (isOut ? kGapFactor : 1);
    if (weight <= most) continue;
    most = weight;
    place = {line, vote.model, isOut};
  }
  return place;
}

int placeBehindIncludes(DefinitionIndex& index, const std::string& file, int before) {
  const FileLines& lines = linesOf(index, file);
  const Includes& here = index.includesOf(file);
  if (const int scar = onlyScar(lines, before); scar > 0) return scar;
  int last = here.empty() ? before - 1 : 0;
  for (const IncludeLine& include : here) {
    if (before > 0 && include.line > before) break;
    if (last > 0 && include.line == last + 2 && isBlank(lines, last + 1)) return last + 1;
    last = include.line;
  }
  return std::clamp(last + 1, 1, std::max(1, static_cast<int>(lines.size())));
}

}  // namespace orris
