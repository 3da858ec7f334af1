#include "app/lsp/published.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/lsp/features.h"
#include "app/lsp/text_place.h"
#include <orris/core/characters.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

using nlohmann::json;

constexpr int kUnnecessary = 1;  ///< a tag of the protocol: drawn pale
constexpr std::string_view kMeant = "did you mean ";

int severityNumber(const std::string& severity) {
  return severity == "error" ? 1 : severity == "warning" ? 2 : 3;
}

/// A problem of the pack as a whole stands at its properties.
std::string fileOf(const EditedPack& pack, const json& finding) {
  const std::string path = finding.at("uri");
  const bool whole = path.empty() || path == pack.root() || path == pack.root() + "/shaders";
  return whole ? pack.filePath("/shaders.properties") : path;
}

std::string lineNumbered(const std::vector<std::string>& lines, int number) {
  return number >= 0 && number < int(lines.size()) ? lines[std::size_t(number)] : "";
}

json rangeOf(const json& finding, const std::vector<std::string>& lines, bool utf8) {
  const int line = std::max(finding.value("line", 0) - 1, 0), column = finding.value("column", 0);
  const std::string text = lineNumbered(lines, line);
  if (column <= 0) {
    const std::size_t begin = text.size() - std::min(text.size(), trim(text).size());
    return rangeJson(line, unitsOf(text, begin, utf8), unitsOf(text, text.size(), utf8));
  }
  const std::size_t begin = std::min(std::size_t(column - 1), text.size());
  const std::size_t length = leadingWord(std::string_view(text).substr(begin)).size();
  const std::size_t end = std::min(begin + std::max<std::size_t>(length, 1), text.size());
  return rangeJson(line, unitsOf(text, begin, utf8), unitsOf(text, end, utf8));
}

json placeJson(const EditedPack& pack, const json& place, const std::string& message) {
  const int line = std::max(place.value("line", 0) - 1, 0);
  return {{"location", {{"uri", uriOfPath(pack.filePath(place.at("file")))}, {"range", rangeJson(line, 0, 0)}}},
          {"message", message}};
}

std::string shownMessage(const json& finding) {
  std::string text = finding.at("message");
  for (const std::string note : finding.at("notes")) text += "\n" + note;
  if (const std::string hint = finding.at("hint"); !hint.empty()) text += "\nhint: " + hint;
  if (const int follows = finding.value("follows", 0); follows > 0)
    text += fmt::format("\n{} more problem{} of this", follows, follows == 1 ? " comes" : "s come");
  return text;
}

json diagnosticJson(const EditedPack& pack, const json& finding, const std::vector<std::string>& lines,
                    bool utf8) {
  const std::string id = finding.at("id");
  json places = json::array();
  for (const json& place : finding.at("includedFrom")) places.push_back(placeJson(pack, place, "included here"));
  for (const json& place : finding.at("related"))
    places.push_back(placeJson(pack, place, place.at("message")));
  json diagnostic = {{"range", rangeOf(finding, lines, utf8)},
                     {"severity", severityNumber(finding.at("severity"))},
                     {"source", "orris"},
                     {"code", id},
                     {"message", shownMessage(finding)},
                     {"relatedInformation", places}};
  if (id.find("unused") != std::string::npos) diagnostic["tags"] = json::array({kUnnecessary});
  return diagnostic;
}

json editAction(const std::string& title, const std::string& uri, json range, const std::string& text) {
  const json edit = {{"range", std::move(range)}, {"newText", text}};
  json changes = json::object();
  changes[uri] = json::array({edit});
  return {{"title", title}, {"kind", "quickfix"}, {"edit", {{"changes", changes}}}};
}

/// The line edit that a checker states.
json repairAction(EditedPack& pack, const json& repair, bool utf8) {
  const std::string file = repair.at("file"), text = repair.at("text");
  const int line = std::max(repair.at("line").get<int>() - 1, 0);
  const std::string uri = uriOfPath(pack.filePath(file));
  if (!repair.at("replaces").get<bool>())
    return editAction("insert " + text, uri, rangeJson(line, 0, 0), text + "\n");
  const std::string old = lineNumbered(splitLines(pack.text(file)), line);
  return editAction("write " + std::string(trim(text)), uri, rangeJson(line, 0, unitsOf(old, old.size(), utf8)), text);
}

/// "did you mean fogColor?", "did you mean fog, declared at /a.fsh:6?" at a word.
std::string meantWord(const std::string& hint) {
  if (!hint.starts_with(kMeant)) return "";
  const std::string word(leadingWord(std::string_view(hint).substr(kMeant.size())));
  const char next = hint.size() > kMeant.size() + word.size() ? hint[kMeant.size() + word.size()] : ' ';
  return next == '?' || next == ',' ? word : "";
}

/// "it must be declared: uniform float frameTimeCounter;", before the first line that is no directive.
std::string declarationIn(const std::string& hint) {
  for (const std::string_view begin : {"it must be declared: ", "declare it: "})
    if (hint.starts_with(begin) && hint.ends_with(";")) return hint.substr(begin.size());
  return "";
}

int lineForDeclaration(const std::vector<std::string>& lines) {
  int after = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string_view line = trim(lines[i]);
    if (line.starts_with("#version") || line.starts_with("#extension")) after = int(i) + 1;
  }
  return after;
}

/// A comment that silences the finding. Contract: docs/checks.md.
json ignoreAction(const std::string& uri, const std::string& path, const std::string& id, int line,
                  const std::string& text) {
  const bool keys = path.ends_with(".properties") || path.ends_with(".lang");
  const std::string indent = text.substr(0, text.size() - std::min(text.size(), trim(text).size()));
  return editAction("ignore " + id + " here", uri, rangeJson(line, 0, 0),
                    fmt::format("{}{} orris: ignore({})\n", indent, keys ? "#" : "//", id));
}

}  // namespace

void Published::show(EditedPack& pack, json findings, bool utf8, const Send& send) {
  findings_ = std::move(findings);
  this->send(pack, utf8, send);
}

void Published::showErrors(EditedPack& pack, const std::set<std::string>& stages, const json& findings,
                           bool utf8, const Send& send) {
  std::set<std::string> programs;
  for (const std::string& stage : stages) programs.insert(stage.substr(0, stage.rfind('.')));
  const auto concerns = [&](const json& finding) {
    const auto& of = finding.at("programs");
    // What is gone from one program is most likely gone from those that are checked later, too.
    return finding.at("severity") == "error" &&
           std::ranges::any_of(of, [&](const json& program) { return programs.contains(program); });
  };
  json kept = json::array();
  for (json& finding : findings_)
    if (!concerns(finding)) kept.push_back(std::move(finding));
  for (const json& finding : findings)
    if (concerns(finding)) kept.push_back(finding);
  findings_ = std::move(kept);
  this->send(pack, utf8, send);
}

void Published::send(EditedPack& pack, bool utf8, const Send& send) {
  std::map<std::string, json> all;
  std::map<std::string, std::vector<std::string>> lines;
  for (const json& finding : findings_) {
    const std::string path = fileOf(pack, finding);
    const auto [text, isNew] = lines.try_emplace(path);
    if (isNew) text->second = splitLines(pack.text(pack.packPath(path)));
    json& list = all.try_emplace(uriOfPath(path), json::array()).first->second;
    list.push_back(diagnosticJson(pack, finding, text->second, utf8));
  }
  for (const auto& [uri, list] : shown_)
    if (!all.contains(uri)) send(uri, json::array());
  for (const auto& [uri, list] : all) {
    const auto before = shown_.find(uri);
    if (before == shown_.end() || before->second != list) send(uri, list);
  }
  shown_ = std::move(all);
}

json Published::actions(EditedPack& pack, const std::string& path, int first, int last, bool utf8) const {
  json actions = json::array();
  const std::vector<std::string> lines = splitLines(pack.text(pack.packPath(path)));
  const std::string uri = uriOfPath(path);
  for (const json& finding : findings_) {
    const json range = rangeOf(finding, lines, utf8);
    const int line = range.at("start").at("line");
    if (fileOf(pack, finding) != path || line < first || line > last) continue;
    const std::string hint = finding.at("hint"), id = finding.at("id");
    if (finding.contains("repair")) actions.push_back(repairAction(pack, finding.at("repair"), utf8));
    if (const std::string word = meantWord(hint); !word.empty() && finding.value("column", 0) > 0)
      actions.push_back(editAction("write " + word, uri, range, word));
    if (const std::string declaration = declarationIn(hint); !declaration.empty())
      actions.push_back(editAction("declare: " + declaration, uri,
                                   rangeJson(lineForDeclaration(lines), 0, 0), declaration + "\n"));
    if (finding.value("line", 0) > 0)
      actions.push_back(ignoreAction(uri, path, id, line, lineNumbered(lines, line)));
  }
  return actions;
}

}  // namespace orris
