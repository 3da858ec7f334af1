// Helpers of the tests in this folder: sources from strings, results as strings.
#pragma once

#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <orris/glsl/compile/validate.h>
#include <orris/glsl/preprocess/preprocessor.h>
#include <orris/glsl/rewrite/rewrite.h>

namespace orris::test {

using Files = std::map<std::string, std::string>;

inline std::vector<std::string> splitLines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

inline void flattenInto(FlatSource& source, const Files& files, const std::string& path, int parent,
                        int parentLine) {
  const int site = static_cast<int>(source.sites.size());
  source.sites.push_back({path, parent, parentLine});
  int number = 0;
  for (const std::string& line : splitLines(files.at(path))) {
    ++number;
    const std::string directive = "#include \"";
    if (line.rfind(directive, 0) == 0) {
      const std::string target = line.substr(directive.size(), line.rfind('"') - directive.size());
      flattenInto(source, files, target, site, number);
    } else {
      source.own(line, site, number);
    }
  }
}

/// Expands `#include "/path"` lines; as the pack layer does, but for valid input only.
inline FlatSource flatten(const Files& files, const std::string& entry) {
  FlatSource source;
  flattenInto(source, files, entry, -1, 0);
  return source;
}

inline FlatSource source(const std::string& text) { return flatten({{"/a.fsh", text}}, "/a.fsh"); }

inline SourceLines linesOf(const Files& files) {
  return [files](const std::string& file, int line) -> std::string {
    const auto found = files.find(file);
    if (found == files.end() || line < 1) return "";
    const std::vector<std::string> lines = splitLines(found->second);
    return static_cast<std::size_t>(line) <= lines.size()
               ? lines[static_cast<std::size_t>(line) - 1]
               : "";
  };
}

inline std::string format(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& d : diagnostics) text += formatDiagnostic(d) + "\n";
  return text;
}

/// Printed text of a preprocessed source; diagnostics are appended after "---".
inline std::string preprocessed(const std::string& text, const MacroDefinitions& environment = {}) {
  Diagnostics diagnostics;
  const std::string printed = print(preprocess(source(text), environment, diagnostics)).text;
  return diagnostics.empty() ? printed : printed + "---\n" + format(diagnostics);
}

/// Printed text after rewriting, without the version line when it is the usual one.
inline std::string rewritten(const std::string& text, Stage stage = Stage::Fragment,
                             RewriteResult* result = nullptr) {
  Diagnostics diagnostics;
  TokenStream stream = preprocess(source(text), {}, diagnostics);
  const RewriteResult applied = rewrite(stream, stage);
  if (result) *result = applied;
  const std::string printed = print(stream).text;
  const std::string usual = "#version 450 compatibility\n";
  return printed.rfind(usual, 0) == 0 ? printed.substr(usual.size()) : printed;
}

inline std::vector<const StageText*> pointersTo(const std::vector<StageText>& stages) {
  std::vector<const StageText*> pointers;
  for (const StageText& stage : stages) pointers.push_back(&stage);
  return pointers;
}

inline std::string ruleNames(const RewriteResult& result) {
  std::string names;
  for (const AppliedRule& rule : result.rules) {
    if (rule.rule == "version") continue;
    names += (names.empty() ? "" : " ") + rule.rule + "*" + std::to_string(rule.count) + "@" +
             std::to_string(rule.first.line) + ":" + std::to_string(rule.first.column);
  }
  return names;
}

}  // namespace orris::test
