#include <orris/check/logs/log_place.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

#include <orris/check/logs/token_alignment.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

/// The code of a text, comments left out.
std::vector<Token> codeTokens(std::string_view text) {
  std::vector<Token> tokens = tokenize(text);
  std::erase_if(tokens, [](const Token& token) { return token.kind == TokenKind::Comment; });
  return tokens;
}

std::vector<std::string_view> wordsOf(const std::vector<Token>& tokens) {
  std::vector<std::string_view> words;
  for (const Token& token : tokens) words.push_back(token.text);
  return words;
}

// Iris: its own names all start so; a message about one is about the name behind it.
std::string withoutIrisPrefix(std::string name) {
  constexpr std::string_view kPrefix = "iris_";
  return name.starts_with(kPrefix) ? name.substr(kPrefix.size()) : name;
}

bool isName(std::string_view text) {
  return !text.empty() && !std::isdigit(static_cast<unsigned char>(text.front())) &&
         leadingWord(text).size() == text.size();
}

LogPlace placeOf(const StageText& stage, const Token& token, std::string how) {
  return {&stage, token.origin.line, token.origin.column, std::move(how)};
}

/// Index of the token that the message means among those of its line; -1: the line has none.
int meantToken(const std::vector<Token>& tokens, const LogEntry& entry,
               const std::vector<int>& matched) {
  const std::vector<std::string> names = namesInMessage(entry.message);
  int best = -1, bestScore = -1;
  for (int i = 0; i < std::ssize(tokens); ++i) {
    if (tokens[i].origin.line != entry.line || matched[i] < 0) continue;
    const bool named = std::ranges::find(names, withoutIrisPrefix(tokens[i].text)) != names.end();
    const bool atColumn = entry.column > 0 && tokens[i].origin.column == entry.column;
    const int score = (atColumn ? 2 : 0) + (named ? 1 : 0);
    if (score > bestScore) best = i, bestScore = score;
  }
  return best;
}

/// The last token before the line that has a counterpart, for lines that Iris added.
int tokenBefore(const std::vector<Token>& tokens, int line, const std::vector<int>& matched) {
  int best = -1;
  for (int i = 0; i < std::ssize(tokens) && tokens[i].origin.line <= line; ++i) {
    if (matched[i] >= 0) best = i;
  }
  return best;
}

}  // namespace

std::vector<std::string> namesInMessage(const std::string& message) {
  std::vector<std::string> names;
  const auto add = [&](std::string_view text) {
    text = trim(text.substr(0, text.find_first_of("([")));
    if (isName(text)) names.push_back(withoutIrisPrefix(std::string(text)));
  };
  // 'x' (glslang, Apple, Intel), `x' (Mesa), "x" (NVIDIA)
  std::size_t at = 0;
  while ((at = message.find_first_of("'`\"", at)) != std::string::npos) {
    const std::size_t end = message.find(message[at] == '"' ? '"' : '\'', at + 1);
    if (end == std::string::npos) break;
    add(std::string_view(message).substr(at + 1, end - at - 1));
    at = end + 1;
  }
  // AMD: "error(#143) Undeclared identifier: x"
  const std::size_t colon = message.rfind(": ");
  if (names.empty() && colon != std::string::npos) add(std::string_view(message).substr(colon + 2));
  return names;
}

const std::vector<Token>& LogPlacer::tokensOf(const StageText& stage) {
  const auto [place, isNew] = tokens_.try_emplace(&stage);
  if (isNew) place->second = codeTokens(stage.text.text);
  return place->second;
}

const LogPlacer::Alignment& LogPlacer::alignmentOf(const PatchedShader& patched,
                                                   const StageText& stage) {
  const auto [place, isNew] = alignments_.try_emplace({&stage, &patched});
  Alignment& alignment = place->second;
  if (isNew) {
    alignment.theirs = codeTokens(patched.text);
    alignment.matched = alignTokens(wordsOf(alignment.theirs), wordsOf(tokensOf(stage)));
  }
  return alignment;
}

const Diagnostics& LogPlacer::problemsOf(const StageText& stage) {
  const auto [place, isNew] = problems_.try_emplace(&stage);
  if (isNew) validateWithGlslang({&stage}, {}, place->second);
  return place->second;
}

/// The first token of each line of the author's that has the name.
std::vector<LogPlacer::Occurrence> LogPlacer::occurrencesOf(const std::string& name,
                                                            const Stages& stages) {
  std::vector<Occurrence> found;
  std::set<std::pair<std::string, int>> lines;
  for (const StageText* stage : stages) {
    for (const Token& token : tokensOf(*stage)) {
      if (token.text != name) continue;
      const SourceLocation at = stage->text.locate(token.origin.line, token.origin.column);
      if (at.file.empty() || !lines.emplace(at.file, at.line).second) continue;
      found.push_back({stage, &token, at});
    }
  }
  return found;
}

std::string LogPlacer::listed(const std::vector<Occurrence>& occurrences) {
  constexpr std::size_t kMost = 6;
  std::vector<std::string> places;
  for (const Occurrence& one : occurrences) {
    if (places.size() == kMost) {
      places.emplace_back("...");
      break;
    }
    places.push_back(fmt::format("{}:{}", one.at.file, one.at.line));
  }
  return joinNames(places);
}

std::optional<LogPlace> LogPlacer::byPatchedText(const LogEntry& entry,
                                                 const PatchedShader& patched,
                                                 const StageText& stage) {
  if (entry.line <= 0) return std::nullopt;
  const auto& [theirs, matched] = alignmentOf(patched, stage);
  const std::vector<Token>& ours = tokensOf(stage);
  if (const int token = meantToken(theirs, entry, matched); token >= 0) {
    return placeOf(stage, ours[matched[token]],
                   fmt::format("exact: by line {} of {}", entry.line, patched.file));
  }
  const int before = tokenBefore(theirs, entry.line, matched);
  if (before < 0) return std::nullopt;
  return placeOf(stage, ours[matched[before]],
                 fmt::format("near: line {} of {} is text that Iris added after this", entry.line,
                             patched.file));
}

std::optional<LogPlace> LogPlacer::byOwnText(const LogEntry& entry, const StageText& stage) {
  const std::vector<std::string> names = namesInMessage(entry.message);
  for (const Token& token : tokensOf(stage)) {
    if (token.origin.line != entry.line) continue;
    if (std::ranges::find(names, token.text) != names.end()) {
      return placeOf(stage, token, "exact: the log counts the lines of this host's text");
    }
  }
  return std::nullopt;
}

std::optional<LogPlace> LogPlacer::byOwnProblem(const LogEntry& entry, const Stages& stages) {
  const std::vector<std::string> names = namesInMessage(entry.message);
  for (const StageText* stage : stages) {
    for (const Diagnostic& problem : problemsOf(*stage)) {
      const std::vector<std::string> theirs = namesInMessage(problem.message);
      const auto shared = std::ranges::find_first_of(names, theirs);
      if (problem.severity != Severity::Error || shared == names.end()) continue;
      for (const Occurrence& one : occurrencesOf(*shared, {stage})) {
        if (one.at.file == problem.at.file && one.at.line == problem.at.line) {
          return placeOf(*stage, *one.token, "exact: this host finds the same here");
        }
      }
    }
  }
  return std::nullopt;
}

std::optional<LogPlace> LogPlacer::byName(const LogEntry& entry, const Stages& stages) {
  for (const std::string& name : namesInMessage(entry.message)) {
    const std::vector<Occurrence> found = occurrencesOf(name, stages);
    if (found.empty()) continue;
    const std::string how =
        found.size() == 1 ? fmt::format("by name: the only line of this program with {}", name)
                          : fmt::format("a guess: {} stands in {} lines of this program, {}", name,
                                        found.size(), listed(found));
    return placeOf(*found.front().stage, *found.front().token, how);
  }
  return std::nullopt;
}

}  // namespace orris
