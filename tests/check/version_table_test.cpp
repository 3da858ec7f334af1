// The table of mistakes in tests/check/glsl_versions.tsv: each is an error at its line, with its hint,
// and docs/glsl-versions.md shows the same table.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include <orris/check/compile/program_check.h>
#include "pack_fixture.h"

namespace orris {
namespace {

/// A row. `scope` is "decl" (file scope), "main", "version" (main, and #version is the mistake) or "both": the code before '|' at file scope.
struct Mistake {
  std::string program, stage, version, scope, code, compilesAs, hint;
};

std::string readPage(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<Mistake> mistakes() {
  std::vector<Mistake> rows;
  std::istringstream file(readPage(ORRIS_TEST_DIR "/check/glsl_versions.tsv"));
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    std::vector<std::string> cells(1);
    for (const char c : line) {
      if (c == '\t') {
        cells.emplace_back();
      } else {
        cells.back() += c;
      }
    }
    cells.resize(7);
    rows.push_back({cells[0], cells[1], cells[2], cells[3], cells[4], cells[5], cells[6]});
  }
  return rows;
}

constexpr int kDeclarationLine = 3, kStatementLine = 5;
int lineOf(const Mistake& row) {
  if (row.scope == "version") return 1;
  return row.scope == "decl" ? kDeclarationLine : kStatementLine;
}

std::string sourceOf(const Mistake& row, const std::string& version) {
  const std::size_t bar = row.code.find('|');
  const std::string first = row.code.substr(0, bar);
  const std::string rest = bar == std::string::npos ? "" : row.code.substr(bar + 1);
  const bool inMain = row.scope == "main" || row.scope == "version";
  const std::string head =
      row.stage == "csh"   ? "layout(local_size_x = 8) in; const ivec3 workGroups = ivec3(1, 1, 1);"
      : row.stage == "gsh" ? "layout(triangles) in; layout(triangle_strip, max_vertices = 3) out;"
                           : "";
  return "#version " + version + "\n" + head + "\n" + (inMain ? "" : first) + "\nvoid main() {\n" +
         (inMain ? first : rest) + "\n}\n";
}

/// What validation says of the program that has the mistake, its stages in `version`.
Diagnostics judged(const Mistake& row, const std::string& version) {
  std::map<std::string, std::string> files;
  if (row.stage != "csh") {
    files["/" + row.program + ".vsh"] =
        "#version " + version + "\nvoid main() { gl_Position = vec4(0.0); }\n";
    files["/" + row.program + ".fsh"] = "#version " + version + "\nvoid main() {}\n";
  }
  files["/" + row.program + "." + row.stage] = sourceOf(row, version);
  Diagnostics diagnostics;
  const LoadRequest request{.environment = standardMacros({}), .irisTexts = true};
  const auto pack =
      loadShaderPack(std::shared_ptr<const FileSource>(memorySource(files)), request, diagnostics);
  Verdicts verdicts;
  if (pack) checkWithGlslang(*pack, 1, verdicts, diagnostics);
  return diagnostics;
}

TEST(VersionTable, has_many_rows) { EXPECT_GE(mistakes().size(), 60u); }

TEST(VersionTable, each_mistake_is_an_error_at_its_line_with_its_hint) {
  for (const Mistake& row : mistakes()) {
    SCOPED_TRACE(row.program + "." + row.stage + " " + row.version + ": " + row.code);
    const Diagnostics found = judged(row, row.version);
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found.front().severity, Severity::Error) << formatDiagnostic(found.front());
    EXPECT_EQ(found.front().at.file, "/" + row.program + "." + row.stage);
    EXPECT_EQ(found.front().at.line, lineOf(row)) << formatDiagnostic(found.front());
    EXPECT_THAT(found.front().hint, ::testing::HasSubstr(row.hint))
        << formatDiagnostic(found.front());
  }
}

TEST(VersionTable, the_version_that_the_hint_names_compiles) {
  for (const Mistake& row : mistakes()) {
    if (row.compilesAs.empty()) continue;
    SCOPED_TRACE(row.program + "." + row.stage + " " + row.compilesAs + ": " + row.code);
    const Diagnostics found = judged(row, row.compilesAs);
    EXPECT_FALSE(hasErrors(found)) << formatDiagnostic(found.front());
  }
}

std::string shown(const Mistake& row) {
  std::string code = row.code;
  std::string bar;
  for (const char c : code) bar += c == '|' ? std::string(" ... ") : std::string(1, c);
  const Diagnostics found = judged(row, row.version);
  const std::string hint = found.empty() ? "" : found.front().hint;
  return "| `" + row.program + "." + row.stage + "` | " + row.version + " | `" + bar + "` | " +
         (row.compilesAs.empty() ? "-" : row.compilesAs) + " | " + hint + " |\n";
}

// ORRIS_UPDATE=1 writes the table into the page.
TEST(VersionTable, stands_in_the_docs) {
  const std::string path = ORRIS_SOURCE_DIR "/docs/glsl-versions.md";
  const std::string begin = "| program | #version | mistake | compiles as | what to do |\n";
  std::string table = begin + "| --- | --- | --- | --- | --- |\n";
  for (const Mistake& row : mistakes()) table += shown(row);
  std::string page = readPage(path);
  const std::size_t from = page.find(begin);
  ASSERT_NE(from, std::string::npos);
  const std::size_t to = std::min(page.find("\n\n", from), page.size());
  if (std::getenv("ORRIS_UPDATE")) {
    page.replace(from, to - from, table.substr(0, table.size() - (to == page.size() ? 0 : 1)));
    std::ofstream(path) << page;
    return;
  }
  EXPECT_EQ(page.substr(from, to - from) + (to == page.size() ? "" : "\n"), table);
}

}  // namespace
}  // namespace orris
