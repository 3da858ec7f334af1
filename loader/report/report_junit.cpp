// JUnit XML, as GitLab, Jenkins and others read it: a suite for each program folder of a pack, a case
// for each program; and one for what concerns the pack as a whole.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include <orris/core/files/pack_path.h>
#include <orris/core/printable.h>
#include <orris/report/report_format.h>

namespace orris {
namespace {

/// U+FFFE and U+FFFF, which XML 1.0 forbids, become U+FFFD.
std::string withoutNoncharacters(std::string text) {
  for (std::size_t at = 0; (at = text.find("\xEF\xBF", at)) != std::string::npos; at += 3) {
    if (text[at + 2] == '\xBE' || text[at + 2] == '\xBF') text[at + 2] = '\xBD';
  }
  return text;
}

/// XML 1.0 has no way to write most control characters, not even as an entity.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : withoutNoncharacters(validUtf8(text))) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\n':
      case '\t':
      case '\r':
        result += fmt::format("&#{};", int(c));
        break;
      case '#':
        // Standard output may be a CI service's log: "##[command]".
        result += result.ends_with('#') ? "&#35;" : "#";
        break;
      default:
        result += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? '?' : c;
    }
  }
  return result;
}

struct Case {
  std::string name, file;
  std::vector<const Finding*> failures, remarks;
  bool failed = false;  ///< by the verdict; its errors may stand at a program of equal text
};

struct Suite {
  std::string name;
  std::vector<Case> cases;
};

class SuiteBuilder {
 public:
  SuiteBuilder(const PackResult& pack, const ValidateResult& result)
      : pack_(pack), strict_(result.strict), verbose_(result.verbose) {}

  std::vector<Suite> build() {
    std::vector<Suite> suites{{pack_.verdict.path, {{.name = "pack", .file = pack_.root}}}};
    std::map<std::string, Suite> folders;
    addPrograms(pack_.verdict.programs, folders);
    for (const auto& mod : pack_.verdict.modPrograms) addPrograms(mod.second, folders);
    for (auto& entry : folders) suites.push_back(std::move(entry.second));
    for (Suite& suite : suites) {
      for (Case& one : suite.cases) attach(one, &suite == &suites.front());
    }
    return suites;
  }

 private:
  void addPrograms(const ProgramVerdicts& programs, std::map<std::string, Suite>& folders) const {
    for (const std::string& program : programs.all) {
      const std::string folder(packPathParent(program));
      Suite& suite = folders[folder];
      suite.name = pack_.verdict.path + " " + folder;
      suite.cases.push_back({.name = program, .failed = programs.failed.contains(program)});
    }
  }

  void attach(Case& one, bool wholePack) const {
    for (const Finding& finding : pack_.findings) {
      const bool shown = finding.diagnostic.severity != Severity::Note || verbose_;
      const bool mine =
          wholePack ? !belongsToProgram(finding) : finding.programs.contains(one.name);
      if (!mine || !shown || finding.silence != Silence::None) continue;
      const bool fails = countsAsFailure(finding, strict_);
      (fails ? one.failures : one.remarks).push_back(&finding);
    }
  }

  bool belongsToProgram(const Finding& finding) const {
    const PackVerdict& verdict = pack_.verdict;
    return std::ranges::any_of(finding.programs, [&](const std::string& program) {
      return verdict.programs.all.contains(program) ||
             std::ranges::any_of(verdict.modPrograms,
                                 [&](const auto& mod) { return mod.second.all.contains(program); });
    });
  }

  const PackResult& pack_;
  bool strict_, verbose_;
};

std::string caseXml(const Suite& suite, const Case& one) {
  std::string text = fmt::format("    <testcase classname=\"{}\" name=\"{}\"", escaped(suite.name),
                                 escaped(one.name));
  if (!one.file.empty()) text += fmt::format(" file=\"{}\"", escaped(one.file));
  text += ">\n";
  for (const Finding* finding : one.failures) {
    text += fmt::format("      <failure type=\"{}\" message=\"{}\">{}</failure>\n",
                        escaped(finding->diagnostic.id), escaped(finding->diagnostic.message),
                        escaped(styledText(withFollows(*finding), {})));
  }
  if (one.failures.empty() && one.failed) {
    text +=
        "      <failure type=\"program\" message=\"fails as a program of the same text "
        "does\"></failure>\n";
  }
  std::string remarks;
  for (const Finding* finding : one.remarks) remarks += styledText(finding->diagnostic, {}) + '\n';
  if (!remarks.empty())
    text += fmt::format("      <system-out>{}</system-out>\n", escaped(remarks));
  return text + "    </testcase>\n";
}

bool isFailure(const Case& one) { return one.failed || !one.failures.empty(); }

}  // namespace

std::string writeJunit(const ValidateResult& result) {
  std::string body;
  std::size_t tests = 0, failures = 0;
  for (const PackResult& pack : result.packs) {
    for (const Suite& suite : SuiteBuilder(pack, result).build()) {
      const auto failed = static_cast<std::size_t>(std::ranges::count_if(suite.cases, isFailure));
      body += fmt::format(
          "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"0\">\n",
          escaped(suite.name), suite.cases.size(), failed);
      for (const Case& one : suite.cases) body += caseXml(suite, one);
      body += "  </testsuite>\n";
      tests += suite.cases.size();
      failures += failed;
    }
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuites name=\"orris validate\" tests=\"{}\" failures=\"{}\" errors=\"0\">\n{}"
      "</testsuites>\n",
      tests, failures, body);
}

}  // namespace orris
