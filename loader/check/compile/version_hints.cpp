#include <orris/check/compile/version_hints.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>
#include <string_view>

#include <orris/check/compile/version_features.h>
#include <orris/check/pack/pack_texts.h>
#include <orris/glsl/iris/iris_names.h>

namespace orris {
namespace {

constexpr const char* kLaxDriver =
    "NVIDIA's driver lets it pass; those of AMD, Intel, Apple and Mesa do not";

/// Of its first line; 0 without one.
int versionOf(const StageText& stage) {
  constexpr std::string_view kDirective = "#version ";
  std::string_view text = stage.text.text;
  if (!text.starts_with(kDirective)) return 0;
  text.remove_prefix(kDirective.size());
  int version = 0;
  std::from_chars(text.data(), text.data() + std::min<std::size_t>(text.size(), 4), version);
  return version;
}

/// The stage whose entry file leads to the diagnostic.
const StageText* stageOf(const std::vector<const StageText*>& stages, const Diagnostic& found) {
  const std::string& entry =
      found.includedFrom.empty() ? found.at.file : found.includedFrom.back().file;
  for (const StageText* stage : stages) {
    if (!stage->text.sites.empty() && stage->text.sites.front().file == entry) return stage;
  }
  return stages.empty() ? nullptr : stages.back();
}

/// What the message quotes first: "fma" of "'fma' : no matching overloaded function found".
std::string_view quotedIn(std::string_view message) {
  if (!message.starts_with('\'')) return {};
  const std::size_t end = message.find('\'', 1);
  if (end == std::string_view::npos) return {};
  std::string_view quoted = message.substr(1, end - 1);
  if (quoted.ends_with("(...)")) quoted.remove_suffix(5);
  return quoted;
}

bool says(const Diagnostic& d, std::string_view text) {
  return d.message.find(text) != std::string::npos;
}

/// Of names that a version lacks, not of values that have a wrong type.
bool isAboutVersion(const Diagnostic& d) {
  constexpr std::string_view kWords[] = {"not supported for this version",
                                         "required extension not requested",
                                         "Reserved word",
                                         "no matching overloaded function",
                                         "undeclared identifier",
                                         "no longer supported in core"};
  return std::any_of(std::begin(kWords), std::end(kWords),
                     [&d](std::string_view words) { return says(d, words); });
}

/// What Iris sends a stage as, and what the author writes behind a number that keeps its kind.
struct SentVersion {
  int number = 0;
  std::string_view profile;  ///< " compatibility", " core" or ""
};

SentVersion sentVersion(const StageText& stage, const SourceLines& lines) {
  const SourceLocation at = stage.text.locate(1, 1);
  const std::string line = lines ? lines(at.file, at.line) : "";
  const std::size_t digits = line.find_first_of("0123456789");
  int written = 0;
  if (digits != std::string::npos)
    std::from_chars(line.data() + digits, line.data() + line.size(), written);
  constexpr int kFirstWithProfiles = 150;
  SentVersion version{.number = versionOf(stage)};
  if (stage.stage == Stage::Compute) return version;
  if (line.find("core") != std::string::npos) version.profile = " core";
  if (line.find("compatibility") != std::string::npos || written < kFirstWithProfiles)
    version.profile = " compatibility";
  return version;
}

std::string adviceFor(std::string_view subject, const VersionFeature& feature,
                      const SentVersion& version) {
  const std::string extension =
      feature.extension.empty() ? "" : fmt::format("#extension {} : enable", feature.extension);
  if (feature.since == 0) return fmt::format("write {}", extension);
  const std::string either = extension.empty() ? "" : " or " + extension;
  return fmt::format(
      "GLSL has {} since version {}, and Iris sends this stage as {}: write #version {}{}{}",
      subject, feature.since, version.number, feature.since, version.profile, either);
}

bool saysSignedAndUnsigned(const Diagnostic& d) {
  return (says(d, "'int'") || says(d, "'ivec")) && (says(d, "'uint'") || says(d, "'uvec"));
}

/// int to uint and their vectors, which GLSL converts since 4.00; none converts the other way round.
bool isNewConversion(const Diagnostic& d, int version) {
  if (version >= 400 || !saysSignedAndUnsigned(d)) return false;
  return says(d, "wrong operand types") || says(d, "cannot convert from 'int'") ||
         says(d, "cannot convert from 'ivec");
}

/// A uint where the author wrote int. Iris: SodiumTransformer.replaceMCEntity.
bool isAboutEntity(const Diagnostic& d) {
  return d.sourceLine.find("mc_Entity") != std::string::npos && saysSignedAndUnsigned(d);
}

void explainSyntax(Diagnostic& d, const SentVersion& version) {
  for (const VersionFeature& keyword : newKeywords()) {
    if (keyword.since <= version.number) continue;
    bool named = false;
    forEachWord(d.sourceLine, [&](std::string_view word) { named |= word == keyword.quoted; });
    if (!named) continue;
    d.hint = adviceFor(fmt::format("the keyword '{}'", keyword.quoted), keyword, version);
    return;
  }
}

/// What a compiler says of a kind of stage as a whole stands at its #version.
void moveToVersion(Diagnostic& d, const StageText& stage, const SourceLines& lines) {
  const bool ofStage = d.message.starts_with("#version") ||
                       d.message.starts_with("'compute shaders'") ||
                       d.message.starts_with("'tessellation shaders'");
  if (!ofStage || d.at.line > 0) return;
  d.at = stage.text.locate(1, 1);
  if (lines) d.sourceLine = lines(d.at.file, d.at.line);
}

void explainVersion(Diagnostic& d, const SentVersion& version) {
  const std::string_view quoted = quotedIn(d.message);
  if (says(d, "redefinition") || says(d, "already has a body")) {
    if (quoted == "modelViewMatrix" || quoted == "projectionMatrix")
      d.hint = fmt::format(
          "write uniform mat4 {}; alone: where Sodium draws, Iris takes no other declaration of it "
          "away for its own",
          quoted);
    if (isTakenByIris(quoted))
      d.hint = fmt::format("Iris declares {} itself in this program: choose another name", quoted);
    return;
  }
  if (says(d, "syntax error")) return explainSyntax(d, version);
  if (says(d, "must be qualified as flat") && d.sourceLine.find("mc_Entity") != std::string::npos) {
    d.hint =
        "read mc_Entity in the vertex stage and hand it on as a flat out: Iris makes an integer input "
        "of it here";
    return;
  }
  if (isAboutEntity(d)) {
    d.hint =
        "where Sodium draws, Iris makes a uint of an int mc_Entity: declare it as vec2 or vec4, "
        "whose x is the id";
    return;
  }
  if (isNewConversion(d, version.number)) {
    d.hint = fmt::format(
        "GLSL makes uint of int by itself since version 400, and Iris sends this stage as {}: "
        "write "
        "1u or uint(x)",
        version.number);
    d.notes.emplace_back(kLaxDriver);
    return;
  }
  if (says(d, "global const initializers must be constant")) {
    d.hint = "take const away: what is not known before the program runs is no constant";
    d.notes.emplace_back(kLaxDriver);
    return;
  }
  if (says(d, "compute shaders require")) {
    d.hint = "write #version 430";
    return;
  }
  if (quoted == "mix" && says(d, "no matching overloaded function")) {
    d.hint = "a bool chooses between two scalars or by a bvec only: write c ? b : a";
    d.notes.emplace_back(kLaxDriver);
    return;
  }
  if (quoted.empty() || !isAboutVersion(d)) return;
  if (const RemovedName* removed = findRemovedName(quoted)) {
    d.hint = fmt::format(
        "Iris sends this stage as core GLSL {}, which has no {}, and has nothing of its own for it "
        "in this program: use {}",
        version.number, quoted, removed->advice);
    return;
  }
  const VersionFeature* feature = findVersionFeature(quoted);
  if (!feature || (feature->since > 0 && feature->since <= version.number)) return;
  d.hint = adviceFor("it", *feature, version);
  if (quoted == "non-constant initializer") d.notes.emplace_back(kLaxDriver);
}

}  // namespace

void explainVersions(const std::vector<const StageText*>& stages, const SourceLines& lines,
                     Diagnostics& found) {
  for (Diagnostic& d : found) {
    if (d.hint.empty() && says(d, "conversion on return values"))
      d.hint = "some drivers refuse it: return a value of the function's type, 0.0 for 0";
    if (d.severity != Severity::Error || !d.hint.empty()) continue;
    const StageText* stage = stageOf(stages, d);
    if (!stage) continue;
    moveToVersion(d, *stage, lines);
    explainVersion(d, sentVersion(*stage, lines));
  }
}

}  // namespace orris
