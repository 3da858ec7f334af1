// libFuzzer target: all of validate, over packs by a grammar (pack_grammar.h); set ORRIS_FUZZ_SHOW to see the pack.
// Each finding has a place that is there, and is of a length that a person reads.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <string>

#include <orris/report/report_format.h>
#include <orris/validate/validate_pack.h>
#include "pack_grammar.h"
#include "pack_text.h"

namespace orris {
namespace {

constexpr std::ptrdiff_t kLongestMessage = 100;  // lines

void require(bool holds, const Diagnostic& d) {
  if (holds) return;
  std::cerr << formatDiagnostic(d) << "\n";
  std::abort();
}

void checkFinding(const Finding& finding, const FileSource& files) {
  const Diagnostic& d = finding.diagnostic;
  require(std::ranges::count(d.message, '\n') < kLongestMessage, d);
  if (const auto text = files.read(d.at.file)) {
    // A line behind the last one is where something is missing.
    require(d.at.line >= 0 && d.at.line <= std::ranges::count(*text, '\n') + 2, d);
  } else {
    require(d.at.line == 0 || d.at.file.starts_with('('), d);  // "(default vertex shader)"
  }
  for (const Finding& follower : finding.follows) checkFinding(follower, files);
}

}  // namespace
}  // namespace orris

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace orris;
  const std::string text = PackGrammar({data, size}).make();
  static const bool kShow = std::getenv("ORRIS_FUZZ_SHOW") != nullptr;
  if (kShow) std::cerr << text << "\n";

  ValidateOptions options;
  options.jobs = 0;  // in this process
  Diagnostics diagnostics;
  auto checker = makeChecker(options, 1, diagnostics);
  ProblemList problems;
  const std::shared_ptr<const FileSource> files = memorySource(filesOfText(text));
  PackVerdict verdict = validateFiles("pack", files, options, *checker, problems);
  ValidateResult result;
  addPack(result, std::move(verdict), problems, options.judge);
  for (const Finding& finding : result.packs.front().findings) checkFinding(finding, *files);
  constexpr std::array kWriters = {writeText, writeJson, writeSarif, writeJunit, writeGithub};
  kWriters[size % kWriters.size()](result);  // all take a fifth of the time
  return 0;
}
