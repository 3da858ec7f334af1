// What a stage says about its own program.
#include <fmt/format.h>

#include <algorithm>

#include <orris/pack/files/text.h>
#include <orris/pack/programs/directive_values.h>
#include <orris/pack/programs/directives.h>

namespace orris {
namespace {

/// A drawing directive: where its keyword stands and what follows the colon.
struct TargetComment {
  size_t token = 0;
  size_t offset = 0;
  std::string_view value;
  bool valid = false;
};

/// The last occurrence of `keyword`; one that does not open its comment voids the earlier ones.
std::optional<TargetComment> findLast(const std::vector<Token>& tokens, std::string_view keyword) {
  for (size_t i = tokens.size(); i-- > 0;) {
    if (tokens[i].kind != TokenKind::Comment) continue;
    const std::string_view text = tokens[i].text;
    const size_t at = text.rfind(keyword);
    if (at == std::string_view::npos) continue;
    TargetComment found{.token = i, .offset = at};
    const size_t begin = at + keyword.size();
    const size_t end = text.find("*/", begin);
    found.valid = trim(text.substr(0, at)).ends_with("/*") && end != std::string_view::npos;
    if (found.valid) found.value = trim(text.substr(begin, end - begin));
    return found;
  }
  return std::nullopt;
}

class ProgramReader {
 public:
  ProgramReader(const TokenStream& stream, int targets, Diagnostics& diagnostics)
      : stream_(stream), targets_(targets), diagnostics_(diagnostics) {}

  ProgramDirectives read() {
    readTargets();
    for (const ConstLine& line : findConstLines(stream_)) readConst(line);
    return std::move(out_);
  }

 private:
  void readTargets() {
    const auto list = findLast(stream_.tokens, "RENDERTARGETS:");
    const auto digits = findLast(stream_.tokens, "DRAWBUFFERS:");
    const bool useList = list && list->valid;
    const bool useDigits = digits && digits->valid;
    if (!useList && !useDigits) return;
    const bool listIsLater =
        useList && (!useDigits || std::pair(list->token, list->offset) >
                                      std::pair(digits->token, digits->offset));
    const TargetComment& used = listIsLater ? *list : *digits;
    out_.drawBuffersAt = locate(stream_.sites, stream_.tokens[used.token].origin);
    std::vector<std::string> words;
    if (listIsLater) {
      for (const std::string_view part : splitAt(used.value, ',')) words.emplace_back(part);
      while (words.size() > 1 && words.back().empty()) words.pop_back();
    } else {
      for (const char digit : used.value) words.emplace_back(1, digit);
    }
    readIndices(words, used);
  }

  void readIndices(const std::vector<std::string>& words, const TargetComment& comment) {
    std::vector<int> buffers;
    for (const std::string& word : words) {
      const auto index = parseInteger(word);
      if (!index || *index < 0) return reportWord(comment, word);
      if (*index >= targets_) {
        return report(
            comment, "render-target-limit",
            fmt::format("buffer {} does not exist: the last one is {}", *index, targets_ - 1), "");
      }
      if (std::find(buffers.begin(), buffers.end(), *index) != buffers.end()) {
        return report(comment, "render-target-syntax",
                      fmt::format("buffer {} is listed twice", *index),
                      "each output needs a buffer of its own");
      }
      buffers.push_back(static_cast<int>(*index));
    }
    constexpr size_t kMostOutputs = 8;
    if (buffers.size() > kMostOutputs) {
      return report(comment, "render-target-limit",
                    fmt::format("{} buffers are listed, at most {} can be drawn at once",
                                buffers.size(), kMostOutputs),
                    "");
    }
    out_.drawBuffers = std::move(buffers);
  }

  void reportWord(const TargetComment& comment, const std::string& word) {
    if (parseInteger(trim(word))) {
      std::string closed(comment.value);
      std::erase_if(closed, [](char c) { return static_cast<unsigned char>(c) <= ' '; });
      return report(comment, "render-target-syntax",
                    "a blank stands beside a comma of RENDERTARGETS",
                    fmt::format("write /* RENDERTARGETS: {} */", closed), Effect::RefusesPack);
    }
    report(comment, "render-target-syntax", fmt::format("\"{}\" is no buffer index", trim(word)),
           "write /* RENDERTARGETS: 0,3,7 */ or /* DRAWBUFFERS:037 */", Effect::RefusesPack);
  }

  void report(const TargetComment& comment, std::string id, std::string message, std::string hint,
              Effect effect = Effect::Unstated) {
    const Token& token = stream_.tokens[comment.token];
    Diagnostic diagnostic{.severity = Severity::Error,
                          .id = std::move(id),
                          .at = out_.drawBuffersAt,
                          .message = std::move(message),
                          .includedFrom = includedFrom(stream_.sites, token.origin.site),
                          .sourceLine = token.text.substr(0, token.text.find('\n')),
                          .hint = std::move(hint)};
    if (effect != Effect::Unstated) diagnostic = withEffect(std::move(diagnostic), effect);
    diagnostics_.push_back(std::move(diagnostic));
  }

  void readConst(const ConstLine& line) {
    if (line.type == "bool") {
      const auto key = parseTargetKey(line.name);
      const auto on = parseConstBoolean(line.value);
      if (!key || key->suffix != "MipmapEnabled" || !on || key->index >= targets_) return;
      if (*on) {
        out_.mipmaps.insert(key->index);
      } else {
        out_.mipmaps.erase(key->index);
      }
    } else if (line.name == "workGroups" && line.type == "ivec3") {
      constexpr float kMostGroups = 65535;
      if (const auto groups = readVector(line, 3); !groups.empty()) {
        if (std::ranges::any_of(groups, [](float count) { return count > kMostGroups; }))
          warnOfConst(line, "OpenGL promises 65535 work groups in a direction; some drivers run more in the "
                            "first one, others run none at all then");
        else if (double(groups[0]) * double(groups[1]) * double(groups[2]) > 4294967295.0)
          warnOfConst(line, "these are more than 4294967295 work groups in all; drivers that count them in 32 "
                            "bits run few of them");
        std::array<int, 3> counts;
        for (size_t i = 0; i < counts.size(); ++i)
          counts[i] = static_cast<int>(std::clamp(groups[i], 0.0f, kMostGroups));
        out_.workGroups = counts;
      }
    } else if (line.name == "workGroupsRender" && line.type == "vec2") {
      if (const auto scale = readVector(line, 2); !scale.empty())
        out_.workGroupsRender = {scale[0], scale[1]};
    }
  }

  void warnOfConst(const ConstLine& line, std::string hint) {
    diagnostics_.push_back({.severity = Severity::Warning,
                            .id = "directive-value",
                            .at = locate(stream_.sites, line.origin),
                            .message = fmt::format("{} is {}", line.name, line.value),
                            .includedFrom = includedFrom(stream_.sites, line.origin.site),
                            .sourceLine = line.sourceLine,
                            .hint = std::move(hint)});
  }

  /// Empty and a diagnostic when Iris does not take it.
  std::vector<float> readVector(const ConstLine& line, size_t count) {
    VectorValue vector = parseVector(line.value, line.type, count);
    if (vector.use == VectorValue::Use::Taken) return std::move(vector.numbers);
    const bool refused = vector.use == VectorValue::Use::Refused;
    diagnostics_.push_back(
        withEffect({.severity = refused ? Severity::Error : Severity::Warning,
                    .id = "directive-value",
                    .at = locate(stream_.sites, line.origin),
                    .message = fmt::format("{} is \"{}\"", line.name, line.value),
                    .includedFrom = includedFrom(stream_.sites, line.origin.site),
                    .sourceLine = line.sourceLine,
                    .hint = fmt::format("write {} with {} numbers", line.type, count)},
                   refused ? Effect::RefusesPack : Effect::IgnoresLine));
    return {};
  }

  const TokenStream& stream_;
  int targets_;
  Diagnostics& diagnostics_;
  ProgramDirectives out_;
};

}  // namespace

ProgramDirectives readProgramDirectives(const TokenStream& stream, int targets,
                                        Diagnostics& diagnostics) {
  return ProgramReader(stream, targets, diagnostics).read();
}

}  // namespace orris
