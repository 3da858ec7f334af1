#include <orris/check/pack/pack_texts.h>

#include <algorithm>

#include <orris/core/characters.h>
#include <orris/core/files/text_file.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

/// Is it "colorte1x" for "colortex1": a digit and a letter beside it exchanged?
bool movesDigit(std::string_view name, std::string_view meant) {
  const size_t at = static_cast<size_t>(
      std::mismatch(name.begin(), name.end(), meant.begin(), meant.end()).first - name.begin());
  return name.size() == meant.size() && at + 1 < name.size() && name[at] == meant[at + 1] &&
         name[at + 1] == meant[at] && name.substr(at + 2) == meant.substr(at + 2) &&
         isDigit(name[at]) != isDigit(name[at + 1]);
}

}  // namespace

std::vector<PropertyEntry> originalProperties(const ShaderPack& pack) {
  constexpr const char* kFile = "/shaders.properties";
  const auto text = pack.source ? readText(*pack.source, kFile) : std::nullopt;
  return text ? lastValues(parseProperties(kFile, *text, Continuation::Java))
              : std::vector<PropertyEntry>();
}

const FileLines& AuthorLines::file(const std::string& path) {
  const auto [found, isNew] = files_.try_emplace(path);
  if (isNew && pack_.source) found->second = splitLines(readText(*pack_.source, path).value_or(""));
  return found->second;
}

const std::string& AuthorLines::at(const SourceLocation& place) {
  static const std::string kNone;
  const FileLines& lines = file(place.file);
  const bool exists = place.line > 0 && static_cast<size_t>(place.line) <= lines.size();
  return exists ? lines[static_cast<size_t>(place.line) - 1] : kNone;
}

Branches::Branches(std::string_view text) : parents_{-1} {
  int current = 0;
  const auto open = [&](int parent) {
    parents_.push_back(parent);
    return static_cast<int>(parents_.size()) - 1;
  };
  for (const std::string& line : splitLines(text)) {
    const std::string_view start = trim(line);
    const int parent = parents_[static_cast<size_t>(current)];
    if (start.starts_with("#if")) {
      current = open(current);
    } else if (start.starts_with("#el") && parent >= 0) {
      current = open(parent);
    } else if (start.starts_with("#endif") && parent >= 0) {
      current = parent;
    }
    branches_.push_back(current);
  }
}

int Branches::at(int line) const {
  const size_t index = static_cast<size_t>(std::max(line, 1)) - 1;
  return index < branches_.size() ? branches_[index] : 0;
}

bool Branches::implies(int b, int a) const {
  const int outer = at(a);
  int branch = at(b);
  // A branch is opened after the one it stands in.
  while (branch > outer) branch = parents_[static_cast<size_t>(branch)];
  return branch == outer;
}

bool isScreenKey(std::string_view key) {
  return key == "screen" ||
         (key.starts_with("screen.") && !key.ends_with(".columns") && key != "screen.columns");
}

void forEachWord(std::string_view text, const std::function<void(std::string_view)>& visit) {
  for (size_t at = 0; at < text.size();) {
    const std::string_view word = leadingWord(text.substr(at));
    if (!word.empty()) visit(word);
    at += std::max<size_t>(word.size(), 1);
  }
}

std::string likelyMeant(std::string_view name, const std::vector<std::string>& names) {
  const std::string nearest = nearestName(name, names);
  // The first letter of a name is seldom wrong, too.
  const bool alike = !nearest.empty() && lowerCase(nearest)[0] == lowerCase(name)[0];
  const size_t most = name.size() < 5 || !alike ? 1 : 2;
  // "colortex4" is no slip of "colortex5".
  const auto withoutDigits = [&](std::string text) {
    std::erase_if(text, isDigit);
    return text;
  };
  // "STEPS_H" is a sibling of "STEPS", or what it was called before.
  const auto extends = [](std::string_view longer, std::string_view shorter) {
    return longer.starts_with(shorter) && longer.substr(shorter.size()).starts_with('_');
  };
  if (extends(name, nearest) || extends(nearest, name)) return "";
  const bool sibling = withoutDigits(nearest) == withoutDigits(std::string(name));
  if (nearest.empty() || (sibling && !movesDigit(name, nearest))) return "";
  return editDistance(lowerCase(name), lowerCase(nearest)) <= most ? nearest : "";
}

bool occursAsWord(std::string_view text, std::string_view word) {
  for (std::size_t at = text.find(word); at != std::string_view::npos;
       at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !isWordCharacter(text[at - 1])) &&
        (end >= text.size() || !isWordCharacter(text[end])))
      return true;
  }
  return false;
}

bool assigns(std::string_view line, std::string_view name) {
  for (std::size_t at = line.find(name); at != std::string_view::npos;
       at = line.find(name, at + 1)) {
    if (at > 0 && isWordCharacter(line[at - 1])) continue;
    std::string_view rest = line.substr(at + name.size());
    if (!rest.empty() && isWordCharacter(rest[0])) continue;
    const std::size_t sign = rest.find('=');
    if (sign == std::string_view::npos || rest.substr(sign).starts_with("==")) continue;
    if (rest.substr(0, sign).find_first_of(";(){}!<>") == std::string_view::npos) return true;
  }
  return false;
}

bool isArgument(std::string_view line, std::string_view name) {
  for (std::size_t at = line.find(name); at != std::string_view::npos; at = line.find(name, at + 1)) {
    const std::string_view before = trim(line.substr(0, at)), after = trim(line.substr(at + name.size()));
    const bool begins = before.ends_with('(') || before.ends_with(',');
    if (begins && (after.starts_with(')') || after.starts_with(','))) return true;
  }
  return false;
}

}  // namespace orris
