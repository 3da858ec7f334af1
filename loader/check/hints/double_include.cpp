#include <orris/check/hints/double_include.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <string_view>

namespace orris {
namespace {

// The last is how glslang goes on after a function that it has already.
constexpr std::array<std::string_view, 3> kOfSecondCopies = {"redefinition", "function already has a body",
                                                             "void function cannot return a value"};

/// Where each file that is read more than once was read first.
std::map<std::string, SourceLocation> firstIncludes(const std::vector<IncludeSite>& sites) {
  std::map<std::string, SourceLocation> first, doubled;
  for (const IncludeSite& site : sites) {
    if (site.parent < 0) continue;
    const SourceLocation at{sites[std::size_t(site.parent)].file, site.parentLine, 1};
    const auto [known, isNew] = first.try_emplace(site.file, at);
    if (!isNew) doubled.insert(*known);
  }
  return doubled;
}

bool isOfSecondCopy(const Diagnostic& d, std::string_view entry) {
  return d.severity == Severity::Error && d.hint.empty() && !d.includedFrom.empty() &&
         d.includedFrom.back().file == entry &&
         std::ranges::any_of(kOfSecondCopies, [&](std::string_view words) { return d.message.find(words) != d.message.npos; });
}

}  // namespace

void explainDoubleIncludes(const std::vector<const StageText*>& stages, Diagnostics& found) {
  for (const StageText* stage : stages) {
    const std::vector<IncludeSite>& sites = stage->text.sites;
    if (sites.empty()) continue;
    const auto doubled = firstIncludes(sites);
    for (Diagnostic& d : found) {
      const auto first = doubled.find(d.at.file);
      if (first == doubled.end() || !isOfSecondCopy(d, sites.front().file)) continue;
      d.hint = "the stage reads this file twice: take one #include away, or begin the file with #ifndef and #define of a name "
               "of its own and end it with #endif";
      d.related.push_back({first->second, "it is included here first"});
    }
  }
}

}  // namespace orris
