#include "app/output/report_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include <orris/check/rules/rules.h>
#include <orris/pack/files/text.h>
#include <orris/report/report_format.h>

namespace orris {
namespace {

using Words = std::vector<std::string>;

std::string hinted(std::string message, const std::string& hint) {
  return hint.empty() ? message : message + "; " + hint;
}

void requireRule(const std::string& flag, const std::string& id) {
  if (findRule(id) != nullptr) return;
  Words names;
  for (const Rule& rule : ruleTable()) names.emplace_back(rule.id);
  throw CLI::ValidationError(
      flag, hinted(fmt::format("there is no check \"{}\"", id), suggest(id, names)));
}

std::optional<Severity> parseSeverity(const std::string& word, bool& known) {
  known = true;
  for (const Severity severity : {Severity::Error, Severity::Warning, Severity::Note}) {
    if (word == severityName(severity)) return severity;
  }
  known = word == "off";
  return std::nullopt;
}

void parseSeverityFlag(const std::string& text, ReportOptions& options) {
  const std::size_t equals = text.find('=');
  const std::string id = text.substr(0, equals);
  bool known = false;
  const auto severity =
      parseSeverity(equals == std::string::npos ? "" : text.substr(equals + 1), known);
  if (!known) {
    throw CLI::ValidationError("--severity",
                               fmt::format("expected ID=error|warning|note|off, got \"{}\"", text));
  }
  requireRule("--severity", id);
  options.judge.severities[id] = severity;
}

void requireFormat(const std::string& flag, const std::string& format) {
  if (findReportFormat(format) != nullptr) return;
  throw CLI::ValidationError(flag, hinted(fmt::format("there is no format \"{}\"", format),
                                          "formats are " + joinNames(reportFormatNames())));
}

void parseReportFlag(const std::string& text, ReportOptions& options) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals + 1 == text.size()) {
    throw CLI::ValidationError("--report", fmt::format("expected FORMAT=FILE, got \"{}\"", text));
  }
  requireFormat("--report", text.substr(0, equals));
  options.files.push_back({text.substr(0, equals), text.substr(equals + 1)});
}

/// A flag that may be repeated, each word of its lists given to `take`.
void addListFlag(CLI::App& command, const std::string& flag, const std::string& type,
                 const std::string& help, std::function<void(const std::string&)> take) {
  command
      .add_option_function<Words>(
          flag,
          [take = std::move(take)](const Words& words) {
            for (const std::string& word : words) take(word);
          },
          help)
      ->type_name(type)
      ->delimiter(',')
      ->allow_extra_args(false);
}

void addJudgementFlags(CLI::App& command, ReportOptions& options) {
  addListFlag(command, "--ignore", "ID,...", "do not report these checks (docs/checks.md)",
              [&options](const std::string& id) {
                requireRule("--ignore", id);
                options.judge.severities[id] = std::nullopt;
              });
  addListFlag(command, "--severity", "ID=LEVEL,...",
              "report a check as error, warning or note, or turn it off",
              [&options](const std::string& word) { parseSeverityFlag(word, options); });
  command.add_flag("--strict", options.judge.strict, "warnings too make the exit status 1");
  command.add_option("--baseline", options.baseline, "do not report the problems of this file")
      ->type_name("FILE");
  command
      .add_option("--write-baseline", options.writeBaseline,
                  "write the problems found to this file, for --baseline")
      ->type_name("FILE");
}

}  // namespace

void addReportFlags(CLI::App& command, ReportOptions& options) {
  const std::string formats = joinNames(reportFormatNames());
  command
      .add_option_function<std::string>(
          "--format",
          [&options](const std::string& format) {
            requireFormat("--format", format);
            options.format = format;
          },
          "what standard output gets: " + formats)
      ->type_name("FORMAT");
  command
      .add_option("-o,--output", options.output,
                  "write the report of --format to this file; standard output gets the counts")
      ->type_name("FILE");
  addListFlag(command, "--report", "FORMAT=FILE,...", "write a report in one more format",
              [&options](const std::string& word) { parseReportFlag(word, options); });
  command
      .add_option_function<std::string>(
          "--source-root", [&options](const std::string& root) { options.judge.sourceRoot = root; },
          "the pack's shaders folder as the repository names it (default: as seen from here)")
      ->type_name("DIR");
  addJudgementFlags(command, options);
}

void settleReportFlags(ReportOptions& options, bool json) {
  if (json) options.format = "json";
  if (options.output.empty()) return;
  options.files.insert(options.files.begin(), {options.format, options.output});
  options.format = "text";
}

}  // namespace orris
