#include <orris/report/baseline.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <tuple>

#include <orris/core/characters.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

constexpr std::string_view kHeading = "# orris baseline 1";
constexpr std::size_t kFingerprintDigits = 16;
constexpr long long kMostOfOne = 1000000;

// Messages may name a place ("/a.glsl:12", "in line 12"), and places move.
std::string withoutLineNumbers(std::string_view message) {
  std::string result;
  for (std::size_t i = 0; i < message.size(); ++i) {
    const bool afterPlace = result.ends_with(':') || result.ends_with("line ");
    if (isDigit(message[i]) && afterPlace) {
      while (i + 1 < message.size() && isDigit(message[i + 1])) ++i;
      continue;
    }
    result += message[i];
  }
  return result;
}

std::string singleBlanks(std::string_view line) {
  return fmt::format("{}", fmt::join(splitBlanks(line), " "));
}

std::uint64_t fnv1a(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return hash;
}

bool isFingerprint(std::string_view word) {
  return word.size() == kFingerprintDigits &&
         std::ranges::all_of(word, [](char c) { return isDigit(c) || (c >= 'a' && c <= 'f'); });
}

// A message of a compiler may hold anything; an entry is one line.
std::string oneLine(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
  return text;
}

}  // namespace

std::string fingerprintOf(const Diagnostic& diagnostic) {
  const std::string text =
      fmt::format("{}\n{}\n{}\n{}", diagnostic.id, diagnostic.at.file,
                  withoutLineNumbers(diagnostic.message), singleBlanks(diagnostic.sourceLine));
  return fmt::format("{:016x}", fnv1a(text));
}

std::optional<Baseline> Baseline::parse(const std::string& path, std::string_view text,
                                        Diagnostics& diagnostics) {
  Baseline baseline;
  const auto refuse = [&](int line, std::string message, const std::string& source) {
    diagnostics.push_back({.id = "baseline-syntax",
                           .at = {path, line, 0},
                           .message = std::move(message),
                           .sourceLine = source,
                           .hint = "write the file anew with --write-baseline"});
    return std::nullopt;
  };
  const std::vector<std::string> lines = splitLines(text);
  if (lines.empty() || !lines[0].starts_with(kHeading)) {
    return refuse(1, fmt::format("a baseline starts with \"{}\"", kHeading), "");
  }
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string> words = splitBlanks(lines[i]);
    if (words.empty() || words[0].starts_with('#')) continue;
    const auto count = words.size() > 1 ? parseInteger(words[1]) : std::nullopt;
    if (!isFingerprint(words[0]) || !count || *count < 1 || *count > kMostOfOne) {
      return refuse(static_cast<int>(i) + 1, "expected a fingerprint and how often it may occur",
                    lines[i]);
    }
    baseline.counts_[words[0]] += static_cast<int>(*count);
  }
  return baseline;
}

bool Baseline::take(const std::string& fingerprint) {
  const auto found = counts_.find(fingerprint);
  if (found == counts_.end() || found->second == 0) return false;
  --found->second;
  ++taken_;
  return true;
}

int Baseline::left() const {
  int sum = 0;
  for (const auto& entry : counts_) sum += entry.second;
  return sum;
}

std::string formatBaseline(const std::vector<Diagnostic>& problems) {
  using Key = std::tuple<std::string, std::string, std::string, std::string, Severity>;
  std::map<Key, int> counts;
  for (const Diagnostic& problem : problems) {
    ++counts[{problem.at.file, problem.id, oneLine(problem.message), fingerprintOf(problem),
              problem.severity}];
  }
  std::string text =
      fmt::format("{}: known problems, written by orris validate --write-baseline\n", kHeading);
  for (const auto& [key, count] : counts) {
    const auto& [file, id, message, fingerprint, severity] = key;
    text += fmt::format("{} {} {} {} {}: {}\n", fingerprint, count, severityName(severity), id,
                        file, message);
  }
  return text;
}

}  // namespace orris
