#include <orris/glsl/syntax/conditional_balance.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <map>
#include <optional>
#include <string_view>

#include <orris/core/characters.h>
#include <orris/glsl/preprocess/line_code.h>
#include <orris/glsl/syntax/brace_check.h>
#include <orris/glsl/syntax/branch_room.h>
#include <orris/glsl/syntax/directive_slip.h>
#include <orris/glsl/syntax/nesting.h>

namespace orris {
namespace {

using Kind = NestingMark::Kind;
constexpr int kEmptyBranch = 3;
constexpr std::size_t kMostPlaces = 64, kMostRepairs = 128;

/// The name of the directive on a line, "" when it is none.
std::string_view directiveOf(std::string_view line) {
  const auto blanks = [&line] {
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  };
  blanks();
  if (!line.starts_with('#')) return "";
  line.remove_prefix(1);
  blanks();
  return line.substr(
      0, static_cast<std::size_t>(std::ranges::find_if_not(line, isWordCharacter) - line.begin()));
}

std::optional<Kind> kindOf(std::string_view directive) {
  if (directive == "if" || directive == "ifdef" || directive == "ifndef") return Kind::Open;
  if (directive == "else" || directive == "elif") return Kind::Middle;
  if (directive == "endif") return Kind::Close;
  return std::nullopt;
}

/// The conditional that a directive is a slip of, or "".
std::string_view conditionalMeant(std::string_view directive) {
  const std::string_view meant = directiveMeant(directive);
  return kindOf(meant) ? meant : "";
}

/// Equal for directives that read alike but for blanks.
std::size_t conditionOf(std::string code) {
  std::erase_if(code, [](char c) { return c == ' ' || c == '\t' || c == '\r'; });
  return std::hash<std::string>()(code);
}

/// "#ifdef FRAGMENT_SHADER", "#if defined VSH".
bool namesStage(std::string_view code) {
  constexpr std::string_view kWords[] = {"VERT", "FRAG", "GEOM", "COMPUTE", "TESS",
                                         "VSH",  "FSH",  "GSH",  "CSH"};
  std::string upper(code);
  std::ranges::transform(upper, upper.begin(), [](unsigned char c) { return std::toupper(c); });
  return std::ranges::any_of(
      kWords, [&](std::string_view word) { return upper.find(word) != std::string::npos; });
}

/// The conditionals of one file.
class FileConditionals {
 public:
  void read(const FlatLine& line) {
    const std::string code = codeOfLine(line.text, inComment_);
    const std::string_view directive = directiveOf(code);
    const Origin at{line.site, line.line, int(code.find('#')) + 1};
    // The line of an #include is not among those of its file.
    if (line.line > lastLine_ + 1) text_.addDirective(line.line - 1);
    lastLine_ = line.line;
    if (const auto kind = kindOf(directive)) {
      addMark(*kind, directive, code, at);
    } else if (!directive.empty()) {
      text_.addDirective(line.line);
      takeSlip(directive, at);
    } else {
      const bool blank = line.text.find_first_not_of(" \t\r") == std::string::npos;
      if (isFirst_ && !marks_.empty()) marks_.back().airy = blank;
      isFirst_ = false;
      if (code.find("void main") != std::string::npos) addMain(at);
      text_.addLine(code, blank, line.line);
      sawCode_ = sawCode_ || code.find_first_not_of(" \t\r") != std::string::npos;
    }
  }

  std::optional<UnbalancedConditional> unbalanced() const {
    int open = 0;
    for (const NestingMark& mark : marks_) {
      open += mark.kind == Kind::Open ? 1 : mark.kind == Kind::Close ? -1 : 0;
    }
    if (open == 0) return std::nullopt;
    if (slip_.at.line > 0) return slip_;
    const Kind missing = open > 0 ? Kind::Close : Kind::Open;
    std::vector<NestingPlace> places;
    for (std::size_t i = 0; i <= marks_.size(); ++i) places.push_back(placeBefore(i, missing));
    const auto found = findMissingMarks(marks_, places, missing);
    if (found.empty()) return std::nullopt;
    const std::size_t partner = found.front().partner;
    UnbalancedConditional result{
        open > 0 ? UnbalancedConditional::Kind::Unclosed : UnbalancedConditional::Kind::Stray,
        origins_[partner], names_[partner], ""};
    result.place = {origins_[partner].site, places[found.front().place].line, 1};
    for (std::size_t i = 1; i < found.size(); ++i)
      result.others.push_back(origins_[found[i].partner]);
    result.repairs = repairs(places, missing);
    result.stages = stages_;
    return result;
  }

 private:
  BranchRoom roomBefore(std::size_t i) const {
    return i == marks_.size() ? text_.room() : rooms_[i];
  }

  /// The likeliest line of each place, then the paragraphs beside them: layout says little of these.
  std::vector<ConditionalRepair> repairs(const std::vector<NestingPlace>& places,
                                         Kind missing) const {
    std::vector<ConditionalRepair> all;
    const auto ranked = rankMissingMarks(marks_, places, missing, kMostPlaces);
    const auto add = [&](const MissingMark& mark, int line) {
      const Origin& partner = origins_[mark.partner];
      if (all.size() < kMostRepairs)
        all.push_back({{partner.site, line, 1}, partner, names_[mark.partner]});
    };
    for (const MissingMark& mark : ranked) add(mark, places[mark.place].line);
    for (const MissingMark& mark : ranked) {
      for (const auto& [first, last] : roomBefore(mark.place).paragraphs) {
        const int line = missing == Kind::Close ? last : first;
        if (line != places[mark.place].line) add(mark, line);
      }
    }
    return all;
  }

  NestingPlace placeBefore(std::size_t i, Kind missing) const {
    const BranchRoom room = roomBefore(i);
    const bool close = missing == Kind::Close;
    const bool wraps = close ? i > 0 && marks_[i - 1].kind == Kind::Close
                             : i < marks_.size() && marks_[i].kind == Kind::Open;
    const int line = close ? room.ends : room.begins;
    const std::size_t neighbour = close ? i - 1 : i;
    const bool behindMain = close && i > 0 && marks_[i - 1].kind == Kind::Main;
    const int nearest = neighbour < marks_.size() ? marks_[neighbour].line : 0;
    // Nobody writes a branch of nothing.
    return {.before = i,
            .line = line > 0 && !behindMain ? line : nearest,
            .cost = line == 0 && !wraps ? kEmptyBranch : 0};
  }

  void addMark(Kind kind, std::string_view directive, const std::string& code, const Origin& at) {
    const BranchRoom room = text_.room();
    const bool isGuard = marks_.empty() && !sawCode_ && kind == Kind::Open &&
                         (directive == "ifndef" || code.find("!defined") != std::string::npos ||
                          code.find("! defined") != std::string::npos);
    marks_.push_back({.kind = kind,
                      .indent = indentWidth(code),
                      .depth = text_.depth(),
                      .line = at.line,
                      .whole = isGuard,
                      .ofStages = kind == Kind::Open && namesStage(code),
                      .last = directive == "else",
                      .condition = kind == Kind::Open ? conditionOf(code) : 0,
                      .airy = kind == Kind::Close ? airy(room) : std::nullopt,
                      .shallowest = room.shallowest});
    if (marks_.back().ofStages && directive == "ifdef") addStage(code);
    rooms_.push_back(room);
    origins_.push_back(at);
    names_.emplace_back(directive);
    text_.addConditional(at.line);
    isFirst_ = kind == Kind::Open;
  }

  void addStage(const std::string& code) {
    const std::size_t name = code.find_first_not_of(" \t", code.find("ifdef") + 5);
    if (name == std::string::npos) return;
    const std::string macro = code.substr(name, code.find_first_of(" \t\r", name) - name);
    if (std::ranges::find(stages_, macro) == stages_.end()) stages_.push_back(macro);
  }

  static std::optional<bool> airy(const BranchRoom& room) {
    const bool text = room.ends > 0 || room.begins > 0 || room.blankBefore;
    return text ? std::optional(room.blankBefore) : std::nullopt;
  }

  void addMain(const Origin& at) {
    marks_.push_back({.kind = Kind::Main, .line = at.line});
    rooms_.push_back(text_.room());
    origins_.push_back(at);
    names_.emplace_back("main");
  }

  void takeSlip(std::string_view directive, const Origin& at) {
    if (slip_.at.line > 0 || conditionalMeant(directive).empty()) return;
    slip_ = {UnbalancedConditional::Kind::Misspelt, at, std::string(directive),
             std::string(conditionalMeant(directive))};
  }

  std::vector<NestingMark> marks_;
  std::vector<Origin> origins_;
  std::vector<std::string> names_;
  std::vector<std::string> stages_;
  UnbalancedConditional slip_;
  std::vector<BranchRoom> rooms_;  ///< of each mark: the text before it
  BranchText text_;
  int lastLine_ = 0;
  bool isFirst_ = false;  ///< is the next line the first of a block?
  bool inComment_ = false, sawCode_ = false;
};

/// Do as many conditionals of a file open as end? Nearly all files pair, and this is quickly seen.
class FileBalance {
 public:
  void read(std::string_view line) {
    if (!inComment_ && line.find_first_of("#/") == std::string_view::npos) return;
    const std::string code = codeOfLine(line, inComment_);
    const auto kind = kindOf(directiveOf(code));
    open_ += kind == Kind::Open ? 1 : kind == Kind::Close ? -1 : 0;
  }
  bool isEven() const { return open_ == 0; }

 private:
  int open_ = 0;
  bool inComment_ = false;
};

/// Calls `take` with the lines of each file, those of the first of its sites.
template <typename Take>
void forEachLineOnce(const FlatSource& source, Take take) {
  constexpr int kUnknown = -1;
  std::map<std::string_view, int> firstOfFile;
  std::vector<int> first(source.sites.size(), kUnknown);
  for (const FlatLine& line : source.lines) {
    if (line.site < 0 || std::size_t(line.site) >= source.sites.size()) continue;
    int& known = first[std::size_t(line.site)];
    if (known == kUnknown)
      known = firstOfFile.try_emplace(source.sites[std::size_t(line.site)].file, line.site).first->second;
    if (known == line.site) take(line);
  }
}

}  // namespace

std::vector<UnbalancedConditional> findUnbalancedConditionals(const FlatSource& source) {
  std::vector<FileBalance> balances(source.sites.size());
  forEachLineOnce(source, [&](const FlatLine& line) { balances[std::size_t(line.site)].read(line.text); });
  std::map<int, FileConditionals> files;
  if (std::ranges::all_of(balances, &FileBalance::isEven)) return {};
  forEachLineOnce(source, [&](const FlatLine& line) {
    if (!balances[std::size_t(line.site)].isEven()) files[line.site].read(line);
  });
  std::vector<UnbalancedConditional> found;
  for (const auto& [site, file] : files) {
    if (const auto unbalanced = file.unbalanced()) found.push_back(*unbalanced);
  }
  return found;
}

Diagnostic describeUnbalanced(const UnbalancedConditional& found, const std::string& file) {
  const bool open = found.kind == UnbalancedConditional::Kind::Unclosed;
  const std::string_view does = open ? "closes" : "opens";
  const auto in = [&](const Origin& at) { return SourceLocation{file, at.line, at.column}; };
  Diagnostic d{.severity = Severity::Warning, .id = "conditional-unbalanced"};
  if (open) {
    d.at = in(found.place);
    d.message = fmt::format("expected #endif after this line: nothing closes the #{} in line {}",
                            found.directive, found.at.line);
    d.related.push_back({in(found.at), fmt::format("the #{} without #endif", found.directive)});
    d.repair = LineEdit{file, found.place.line + 1, "#endif"};
  } else {
    d.at = in(found.at);
    d.message = "#endif without #if";
    d.related.push_back({in(found.place), "or an #if is missing before this line"});
    d.repair = LineEdit{file, found.at.line, "#if 1"};
  }
  // Which of two blocks lacks its other end only the author knows.
  for (const Origin& other : found.others) {
    d.related.push_back(
        {in(other), fmt::format("or nothing {} this one instead of line {}", does, found.at.line)});
  }
  return d;
}

}  // namespace orris
