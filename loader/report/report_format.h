// The formats in which `orris validate` can report; docs/ci.md describes each.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orris/report/findings.h>
#include <orris/report/text_style.h>

namespace orris {

struct ReportFormat {
  std::string_view name;
  std::string (*write)(const ValidateResult& result);
};

/// nullptr: there is no such format.
const ReportFormat* findReportFormat(std::string_view name);
std::vector<std::string> reportFormatNames();

std::string writeText(const ValidateResult& result);    ///< all messages, then the counts
std::string writeJson(const ValidateResult& result);    ///< docs/schema/validate.schema.json
std::string writeSarif(const ValidateResult& result);   ///< SARIF 2.1.0, one run
std::string writeJunit(const ValidateResult& result);   ///< a suite for each folder of a pack
std::string writeGithub(const ValidateResult& result);  ///< workflow commands: "::error file=..."

/// The diagnostic of a finding with a note that says how many follow from it.
Diagnostic withFollows(const Finding& finding);
/// The messages of one pack that `verbosity` asks for, as they go to standard error, and with `strict`
/// all that make the exit status 1; with --verbose, below each what follows from it.
std::string messagesOf(const PackResult& pack, const Verbosity& verbosity, bool strict,
                       const TextStyle& style);
/// The counts of one pack, as they go to standard output.
std::string summaryOf(const PackResult& pack);

}  // namespace orris
