#include <orris/check/rules/rules.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

#include "text_fixture.h"

namespace orris {
namespace {

namespace fs = std::filesystem;
using Ids = std::set<std::string>;

void collect(const std::string& text, const std::regex& pattern, Ids& ids) {
  for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) {
    ids.insert((*it)[1]);
  }
}

// Rewrite rules have names of the same form, in files of their own.
bool holdsOtherNames(const fs::path& path) {
  const std::string name = path.filename();
  return name.starts_with("rules_") || name.starts_with("rewrite") || name == "plot_scripts.cpp";
}

/// Every string of the sources that looks like an id.
Ids idsInSources() {
  static const std::regex kId(R"re("([a-z][a-z0-9]*(?:-[a-z0-9]+)+)")re");
  static const Ids kOtherStrings = {"built-in", "world-1", "refuses-pack", "refuses-program",
                                    "ignores-line", "utf-8", "utf-16", "recent-worlds"};
  Ids ids;
  for (const auto& entry : fs::recursive_directory_iterator(ORRIS_SOURCE_DIR "/loader")) {
    const fs::path& path = entry.path();
    if (path.extension() == ".cpp" && !holdsOtherNames(path)) collect(textOf(path), kId, ids);
  }
  for (const std::string& other : kOtherStrings) ids.erase(other);
  return ids;
}

Ids idsInTable() {
  Ids ids;
  for (const Rule& rule : ruleTable()) ids.emplace(rule.id);
  return ids;
}

Ids idsInDocs() {
  static const std::regex kHeading(R"re((?:^|\n)## ([^\n]+))re");
  Ids ids;
  collect(textOf(ORRIS_SOURCE_DIR "/docs/checks.md"), kHeading, ids);
  return ids;
}

Ids idsWithout(Ids ids, const Ids& others) {
  for (const std::string& id : others) ids.erase(id);
  return ids;
}

TEST(Rules, everyIdOfTheSourcesHasARow) {
  EXPECT_THAT(idsWithout(idsInSources(), idsInTable()), testing::IsEmpty())
      << "add rows to loader/check/rules/";
}

TEST(Rules, everyRowIsUsedInTheSources) {
  EXPECT_THAT(idsWithout(idsInTable(), idsInSources()), testing::IsEmpty());
}

TEST(Rules, everyRowHasASectionInDocs) {
  EXPECT_THAT(idsWithout(idsInTable(), idsInDocs()), testing::IsEmpty())
      << "add sections to docs/checks.md";
}

TEST(Rules, everySectionInDocsHasARow) {
  EXPECT_THAT(idsWithout(idsInDocs(), idsInTable()), testing::IsEmpty());
}

TEST(Rules, eachSectionSaysSeverityAndSummaryOfItsRow) {
  const std::string docs = textOf(ORRIS_SOURCE_DIR "/docs/checks.md");
  for (const Rule& rule : ruleTable()) {
    const std::string section = std::string("\n## ") + std::string(rule.id) + "\n\n**" +
                                severityName(rule.severity) + "**: " + std::string(rule.summary) +
                                ".\n";
    EXPECT_THAT(docs, testing::HasSubstr(section));
  }
}

TEST(Rules, idsAreSortedAndUnique) {
  const auto rules = ruleTable();
  for (std::size_t i = 1; i < rules.size(); ++i) EXPECT_LT(rules[i - 1].id, rules[i].id);
}

TEST(Rules, findRuleFindsEachAndNothingElse) {
  for (const Rule& rule : ruleTable()) EXPECT_EQ(findRule(rule.id), &rule);
  EXPECT_EQ(findRule("no-such-rule"), nullptr);
  EXPECT_EQ(findRule(""), nullptr);
}

TEST(Rules, theWorstCauseIsTheStatus) {
  Diagnostics diagnostics{{.severity = Severity::Warning, .id = "option-unknown"}};
  EXPECT_EQ(statusOf(diagnostics), kClean);
  diagnostics.push_back({.id = "glsl-compile"});
  EXPECT_EQ(statusOf(diagnostics), kProblems);
  diagnostics.push_back({.id = "file-unreadable"});
  EXPECT_EQ(statusOf(diagnostics), kUsage);
}

}  // namespace
}  // namespace orris
