#include "pack/directives.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "pack/const_line.h"
#include "pack/shader_properties.h"
#include "pack/text.h"
#include "pack/texture_format.h"

namespace orris {
namespace {

/// "colortex4Format" is {"colortex", 4, "Format"}.
struct TargetKey {
  bool shadow = false;
  int index = -1;
  std::string_view suffix;
};

constexpr std::array<std::string_view, 8> kLegacyNames{"gcolor", "gdepth", "gnormal", "composite",
                                                       "gaux1",  "gaux2",  "gaux3",   "gaux4"};

std::optional<TargetKey> parseTargetKey(std::string_view key) {
  for (size_t i = 0; i < kLegacyNames.size(); ++i) {
    if (key.starts_with(kLegacyNames[i])) {
      return TargetKey{false, static_cast<int>(i), key.substr(kLegacyNames[i].size())};
    }
  }
  const bool shadow = key.starts_with("shadowcolor") || key.starts_with("shadowColor");
  if (!shadow && !key.starts_with("colortex")) return std::nullopt;
  const std::string_view rest = key.substr(shadow ? 11 : 8);
  const size_t digits = std::min(rest.find_first_not_of("0123456789"), rest.size());
  const auto index = digits > 0 && digits < 4 ? parseInteger(rest.substr(0, digits)) : std::nullopt;
  if (!index) return std::nullopt;
  return TargetKey{shadow, static_cast<int>(*index), rest.substr(digits)};
}

/// The numbers of "vec4(1.0, 0.0, 0.5, 1.0)"; nullopt unless there are `count`.
std::optional<std::vector<float>> parseVector(std::string_view value, std::string_view type,
                                              size_t count) {
  if (!value.starts_with(type)) return std::nullopt;
  value = trim(value.substr(type.size()));
  if (!value.starts_with('(') || !value.ends_with(')')) return std::nullopt;
  std::vector<float> numbers;
  for (const std::string_view part : splitAt(value.substr(1, value.size() - 2), ',')) {
    const auto number = parseFloat(trim(part));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers.size() == count ? std::optional(numbers) : std::nullopt;
}

/// Reads the const lines of one stage into the settings of the pack.
class PackReader {
 public:
  PackReader(const std::vector<IncludeSite>& sites, PackDirectives& out, Diagnostics& diagnostics)
      : sites_(sites), out_(out), diagnostics_(diagnostics) {}

  void read(const ConstLine& line) {
    if (const auto key = parseTargetKey(line.name)) return readTarget(*key, line);
    if (line.type == "float") return readFloat(line);
    if (line.type == "int") return readInt(line);
    if (line.type == "bool") readBool(line);
  }

 private:
  void report(Severity severity, std::string id, const ConstLine& line, std::string message,
              std::string hint) {
    diagnostics_.push_back({.severity = severity,
                            .id = std::move(id),
                            .at = locate(sites_, line.origin),
                            .message = std::move(message),
                            .includedFrom = includedFrom(sites_, line.origin.site),
                            .sourceLine = line.sourceLine,
                            .hint = std::move(hint)});
  }

  void readTarget(const TargetKey& key, const ConstLine& line) {
    // Packs written for hosts with more buffers still run on this one.
    if (key.index >= (key.shadow ? kShadowColorTargets : kColorTargets)) return;
    auto& target = (key.shadow ? out_.shadowcolor : out_.colortex)[key.index];
    if (key.suffix == "Format" && line.type == "int") {
      readFormat(line, target);
    } else if (key.suffix == "Clear" && line.type == "bool") {
      if (const auto on = parseBoolean(line.value)) target.clear = *on;
    } else if (key.suffix == "ClearColor" && line.type == "vec4") {
      readClearColor(line, target);
    } else if (key.shadow && line.type == "bool") {
      const auto on = parseBoolean(line.value);
      if (on && key.suffix == "Mipmap") target.mipmap = *on;
      if (on && (key.suffix == "Nearest" || key.suffix == "MinMagNearest")) target.nearest = *on;
    }
  }

  void readFormat(const ConstLine& line, TargetSettings& target) {
    const std::string format = knownName(line.value, internalFormatNames());
    if (!format.empty()) {
      target.format = format;
      return;
    }
    const std::string nearest = nearestName(line.value, internalFormatNames());
    report(Severity::Error, "format-unknown", line,
           fmt::format("{} is no texture format; {} keeps {}", line.value,
                       line.name.substr(0, line.name.size() - 6), target.format),
           nearest.empty() ? "see the list of formats, for example RGBA16F"
                           : fmt::format("did you mean {}?", nearest));
  }

  void readClearColor(const ConstLine& line, TargetSettings& target) {
    if (const auto color = parseVector(line.value, "vec4", 4)) {
      target.clearColor = {(*color)[0], (*color)[1], (*color)[2], (*color)[3]};
    } else {
      report(Severity::Warning, "directive-value", line,
             fmt::format("{} is no clear colour", line.value), "write vec4 with four numbers");
    }
  }

  void readFloat(const ConstLine& line) {
    const std::pair<std::string_view, float*> known[] = {
        {"shadowDistance", &out_.shadowDistance},
        {"shadowDistanceRenderMul", &out_.shadowDistanceRenderMul},
        {"entityShadowDistanceMul", &out_.entityShadowDistanceMul},
        {"shadowIntervalSize", &out_.shadowIntervalSize},
        {"shadowNearPlane", &out_.shadowNearPlane},
        {"shadowFarPlane", &out_.shadowFarPlane},
        {"voxelDistance", &out_.voxelDistance},
        {"sunPathRotation", &out_.sunPathRotation},
        {"ambientOcclusionLevel", &out_.ambientOcclusionLevel},
        {"wetnessHalflife", &out_.wetnessHalflife},
        {"drynessHalflife", &out_.drynessHalflife},
        {"eyeBrightnessHalflife", &out_.eyeBrightnessHalflife},
        {"centerDepthHalflife", &out_.centerDepthHalflife}};
    float fov = 0;
    float* target = line.name == "shadowMapFov" ? &fov : nullptr;
    for (const auto& [name, field] : known) target = line.name == name ? field : target;
    if (!target) return;
    const auto value = parseFloat(line.value);
    if (!value) return notLiteral(line);
    *target = *value;
    if (target == &fov) out_.shadowMapFov = fov;
    out_.ambientOcclusionLevel = std::clamp(out_.ambientOcclusionLevel, 0.0f, 1.0f);
  }

  void readInt(const ConstLine& line) {
    if (line.name != "shadowMapResolution" && line.name != "noiseTextureResolution") return;
    const auto value = parseInteger(line.value);
    if (!value) return notLiteral(line);
    constexpr int kLargest = 16384;
    if (*value < 1 || *value > kLargest) {
      report(Severity::Error, "directive-value", line,
             fmt::format("{} is {}, expected 1 to {}", line.name, line.value, kLargest), "");
      return;
    }
    (line.name.front() == 's' ? out_.shadowMapResolution : out_.noiseTextureResolution) =
        static_cast<int>(*value);
  }

  void readBool(const ConstLine& line) {
    struct Switch {
      std::string_view name;
      bool ShadowDepthSettings::*field;
      int first, last;  ///< the shadowtex it applies to
    };
    static constexpr Switch kSwitches[] = {
        {"shadowHardwareFiltering", &ShadowDepthSettings::hardwareFiltering, 0, 1},
        {"shadowHardwareFiltering0", &ShadowDepthSettings::hardwareFiltering, 0, 0},
        {"shadowHardwareFiltering1", &ShadowDepthSettings::hardwareFiltering, 1, 1},
        {"generateShadowMipmap", &ShadowDepthSettings::mipmap, 0, 1},
        {"shadowtexMipmap", &ShadowDepthSettings::mipmap, 0, 0},
        {"shadowtex0Mipmap", &ShadowDepthSettings::mipmap, 0, 0},
        {"shadowtex1Mipmap", &ShadowDepthSettings::mipmap, 1, 1},
        {"shadowtexNearest", &ShadowDepthSettings::nearest, 0, 0},
        {"shadowtex0Nearest", &ShadowDepthSettings::nearest, 0, 0},
        {"shadow0MinMagNearest", &ShadowDepthSettings::nearest, 0, 0},
        {"shadowtex1Nearest", &ShadowDepthSettings::nearest, 1, 1},
        {"shadow1MinMagNearest", &ShadowDepthSettings::nearest, 1, 1}};
    const auto on = parseBoolean(line.value);
    if (!on) return;
    for (const Switch& known : kSwitches) {
      if (line.name != known.name) continue;
      for (int i = known.first; i <= known.last; ++i)
        out_.shadowtex[static_cast<size_t>(i)].*known.field = *on;
    }
    if (line.name == "generateShadowColorMipmap") {
      for (int i = 0; i < kShadowColorTargets; ++i) out_.shadowcolor[i].mipmap = *on;
    }
  }

  void notLiteral(const ConstLine& line) {
    report(Severity::Warning, "directive-value", line,
           fmt::format("{} has the value \"{}\", which is no number; the directive is ignored",
                       line.name, line.value),
           "the host reads literals only, no expressions");
  }

  const std::vector<IncludeSite>& sites_;
  PackDirectives& out_;
  Diagnostics& diagnostics_;
};

/// A drawing directive: where its keyword stands and what follows the colon.
struct TargetComment {
  size_t token = 0;
  size_t offset = 0;
  std::string_view value;  ///< empty optional when the keyword does not open its comment
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
      for (const std::string_view part : splitAt(used.value, ',')) words.emplace_back(trim(part));
    } else {
      for (const char digit : used.value) words.emplace_back(1, digit);
    }
    readIndices(words, used);
  }

  void readIndices(const std::vector<std::string>& words, const TargetComment& comment) {
    std::vector<int> buffers;
    for (const std::string& word : words) {
      const auto index = parseInteger(word);
      if (!index || *index < 0) {
        return report(comment, "render-target-syntax",
                      fmt::format("\"{}\" is no buffer index", word),
                      "write /* RENDERTARGETS: 0,3,7 */ or /* DRAWBUFFERS:037 */");
      }
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

  void report(const TargetComment& comment, std::string id, std::string message, std::string hint) {
    const Token& token = stream_.tokens[comment.token];
    diagnostics_.push_back({.severity = Severity::Error,
                            .id = std::move(id),
                            .at = out_.drawBuffersAt,
                            .message = std::move(message),
                            .includedFrom = includedFrom(stream_.sites, token.origin.site),
                            .sourceLine = token.text.substr(0, token.text.find('\n')),
                            .hint = std::move(hint)});
  }

  void readConst(const ConstLine& line) {
    if (line.type == "bool") {
      const auto key = parseTargetKey(line.name);
      const auto on = parseBoolean(line.value);
      if (!key || key->suffix != "MipmapEnabled" || !on || key->index >= targets_) return;
      if (*on) {
        out_.mipmaps.insert(key->index);
      } else {
        out_.mipmaps.erase(key->index);
      }
    } else if (line.name == "workGroups" && line.type == "ivec3") {
      if (const auto groups = parseVector(line.value, "ivec3", 3)) {
        std::array<int, 3> counts;
        for (size_t i = 0; i < 3; ++i)
          counts[i] = static_cast<int>(std::clamp((*groups)[i], 0.0f, 65535.0f));
        out_.workGroups = counts;
      }
    } else if (line.name == "workGroupsRender" && line.type == "vec2") {
      if (const auto scale = parseVector(line.value, "vec2", 2))
        out_.workGroupsRender = {(*scale)[0], (*scale)[1]};
    }
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

void readPackDirectives(const std::vector<ConstLine>& lines, const std::vector<IncludeSite>& sites,
                        PackDirectives& directives, Diagnostics& diagnostics) {
  PackReader reader(sites, directives, diagnostics);
  for (const ConstLine& line : lines) reader.read(line);
}

}  // namespace orris
