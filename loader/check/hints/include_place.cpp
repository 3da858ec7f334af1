#include <orris/check/hints/include_place.h>

#include <algorithm>
#include <map>

#include <orris/core/files/pack_path.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

using Includes = std::vector<IncludeLine>;

// Packs are untrusted: more models would tell nothing new.
constexpr std::size_t kMostModels = 128;
// So that a file without any #include left still has models, the nearest in name.
constexpr double kSomeLikeness = 0.01;
constexpr double kSameName = 1, kAlikeNames = 0.6;
// A blank line where a line should be is where it was taken out.
constexpr double kGapFactor = 1.5;
// What a model says for a gap, as a share of what it says for a line like its own.
constexpr double kShareOfOne = 0.3, kShareOfMore = 0.175, kShareBetween = 1;
constexpr double kLongestShare = 0.2, kSureShare = 0.5, kShareApart = 0.25;
constexpr int kLongGap = 3;

std::string_view fileName(std::string_view path) { return path.substr(path.rfind('/') + 1); }

bool includes(const Includes& lines, const std::string& target) {
  return std::ranges::any_of(lines, [&](const auto& line) { return line.target == target; });
}

bool isBlank(const FileLines& lines, int line) {
  return line >= 1 && static_cast<std::size_t>(line) <= lines.size() &&
         trim(lines[static_cast<std::size_t>(line) - 1]).empty();
}

/// A run of blank lines; the line where an #include may have been taken out of it.
struct Gap {
  int line = 0;
  double share = 0;  ///< of what a line of text like that of a model would count
};

/// How much a run of blank lines looks as if a line was taken out: long, and beside an #include or
/// below the #version.
Gap gapOf(int first, int last, const FileLines& lines, const Includes& includes) {
  const auto has = [&](int line) {
    return std::ranges::any_of(includes, [&](const auto& include) { return include.line == line; });
  };
  const int length = std::min(last - first + 1, kLongGap);
  const bool head = first > 1 && trim(lines[std::size_t(first) - 2]).starts_with("#version");
  const bool above = head || has(first - 1), below = has(last + 1);
  if (has(first - 1) && below) return {first, kShareBetween};
  if (above || below)
    return {above ? first : last, kShareOfOne + kShareOfMore * double(length - 1)};
  // Of three or more the second.
  return {length < kLongGap ? last : first + (last - first + 1) / 2,
          length < kLongGap ? 0 : kShareApart};
}

/// The gaps before the line `before` (0: all); the longest stands out if there is but one.
std::vector<Gap> gapsOf(const FileLines& lines, const Includes& includes, int before) {
  std::vector<Gap> gaps;
  int longest = 1, run = 0;
  std::size_t only = 0, of = 0;
  const int last = before > 0 ? before - 1 : static_cast<int>(lines.size());
  for (int line = 1; line <= last; ++line) {
    run = isBlank(lines, line) ? run + 1 : 0;
    if (run == 0 || (line < last && isBlank(lines, line + 1))) continue;
    gaps.push_back(gapOf(line - run + 1, line, lines, includes));
    if (run > longest) only = gaps.size() - 1;
    of = run > longest ? 1 : of + (run == longest ? 1 : 0);
    longest = std::max(longest, run);
  }
  if (longest > 1 && of == 1) gaps[only].share += kLongestShare;
  std::erase_if(gaps, [](const Gap& gap) { return gap.share <= 0; });
  return gaps;
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

std::vector<IncludePlace> placesByModels(DefinitionIndex& index, const std::string& file,
                                         const std::string& target, int before, std::size_t most) {
  const FileLines& lines = linesOf(index, file);
  const Includes& here = index.includesOf(file);
  struct Vote {
    double weight = 0, best = 0;
    SourceLocation model;
  };
  std::map<int, Vote> votes;
  const std::vector<Gap> gaps = gapsOf(lines, here, before);
  // Also where no file includes the target any more.
  for (const Gap& gap : gaps) votes[gap.line].weight = gap.share * kSomeLikeness;
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
    for (const Gap& gap : gaps) vote(gap.line, gap.share);
  }
  std::vector<std::pair<double, IncludePlace>> places;
  for (const auto& [line, vote] : votes) {
    const bool isOut = isBlank(lines, line);
    places.push_back({vote.weight * (isOut ? kGapFactor : 1), {line, vote.model, isOut}});
  }
  std::ranges::stable_sort(places, std::ranges::greater(), [](const auto& p) { return p.first; });
  std::vector<IncludePlace> likeliest;
  for (std::size_t i = 0; i < std::min(most, places.size()); ++i) {
    likeliest.push_back(places[i].second);
    likeliest.back().share = places.front().first > 0 ? places[i].first / places.front().first : 1;
  }
  return likeliest;
}

int placeBehindIncludes(DefinitionIndex& index, const std::string& file, int before) {
  const FileLines& lines = linesOf(index, file);
  const Includes& here = index.includesOf(file);
  const std::vector<Gap> gaps = gapsOf(lines, here, before);
  const auto best = std::ranges::max_element(gaps, {}, &Gap::share);
  if (best != gaps.end() && best->share >= kSureShare) return best->line;
  int last = here.empty() ? before - 1 : 0;
  for (const IncludeLine& include : here) {
    if (before > 0 && include.line > before) break;
    if (last > 0 && include.line == last + 2 && isBlank(lines, last + 1)) return last + 1;
    last = include.line;
  }
  return std::clamp(last + 1, 1, std::max(1, static_cast<int>(lines.size())));
}

}  // namespace orris
