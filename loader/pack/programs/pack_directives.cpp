// What a stage says about the frame.
#include <fmt/format.h>

#include <algorithm>

#include <orris/pack/files/text.h>
#include <orris/pack/programs/directive_values.h>
#include <orris/pack/programs/directives.h>
#include <orris/pack/properties/texture_format.h>

namespace orris {
namespace {

template <typename Field>
struct Named {
  std::string_view name;
  Field field;
};
constexpr std::string_view kDryness = "drynessHalflife";
constexpr Named<float PackDirectives::*> kFloats[] = {
    {"shadowDistance", &PackDirectives::shadowDistance},
    {"shadowDistanceRenderMul", &PackDirectives::shadowDistanceRenderMul},
    {"entityShadowDistanceMul", &PackDirectives::entityShadowDistanceMul},
    {"shadowIntervalSize", &PackDirectives::shadowIntervalSize},
    {"shadowNearPlane", &PackDirectives::shadowNearPlane},
    {"shadowFarPlane", &PackDirectives::shadowFarPlane},
    {"voxelDistance", &PackDirectives::voxelDistance},
    {"sunPathRotation", &PackDirectives::sunPathRotation},
    {"ambientOcclusionLevel", &PackDirectives::ambientOcclusionLevel},
    {"wetnessHalflife", &PackDirectives::wetnessHalflife},
    // Iris: PackDirectives, whose dryness half-life is always the default.
    {kDryness, &PackDirectives::wetnessHalflife},
    {"eyeBrightnessHalflife", &PackDirectives::eyeBrightnessHalflife},
    {"centerDepthHalflife", &PackDirectives::centerDepthHalflife}};
constexpr Named<int PackDirectives::*> kInts[] = {
    {"shadowMapResolution", &PackDirectives::shadowMapResolution},
    {"noiseTextureResolution", &PackDirectives::noiseTextureResolution}};

struct Switch {
  std::string_view name;
  bool ShadowDepthSettings::*field;
  int first, last;  ///< the shadowtex it applies to
};
constexpr Switch kSwitches[] = {
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

constexpr std::string_view kShadowMapFov = "shadowMapFov";
constexpr std::string_view kShadowColorMipmap = "generateShadowColorMipmap";

template <typename Row, size_t Count>
const Row* find(const Row (&rows)[Count], std::string_view name) {
  const auto found =
      std::find_if(std::begin(rows), std::end(rows), [&](auto& row) { return row.name == name; });
  return found == std::end(rows) ? nullptr : found;
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
  Diagnostic at(Severity severity, std::string id, const ConstLine& line, std::string message,
                std::string hint) {
    return {.severity = severity,
            .id = std::move(id),
            .at = locate(sites_, line.origin),
            .message = std::move(message),
            .includedFrom = includedFrom(sites_, line.origin.site),
            .sourceLine = line.sourceLine,
            .hint = std::move(hint)};
  }
  void report(Severity severity, std::string id, const ConstLine& line, std::string message,
              std::string hint) {
    diagnostics_.push_back(at(severity, std::move(id), line, std::move(message), std::move(hint)));
  }

  void readTarget(const TargetKey& key, const ConstLine& line) {
    // Packs written for hosts with more buffers still run on this one.
    if (key.index >= (key.shadow ? kShadowColorTargets : kColorTargets)) return;
    auto& target = (key.shadow ? out_.shadowcolor : out_.colortex)[key.index];
    if (key.suffix == "Format" && line.type == "int") {
      readFormat(line, target);
    } else if (key.suffix == "Clear" && line.type == "bool") {
      if (const auto on = parseConstBoolean(line.value)) target.clear = *on;
    } else if (key.suffix == "ClearColor" && line.type == "vec4") {
      readClearColor(line, target);
    } else if (key.shadow && line.type == "bool") {
      const auto on = parseConstBoolean(line.value);
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
    const std::string written =
        line.value.empty() ? "nothing stands after the =," : line.value + " is no texture format;";
    report(Severity::Warning, "format-unknown", line,
           fmt::format("{} {} keeps {}", written, line.name.substr(0, line.name.size() - 6),
                       target.format),
           parseInteger(line.value) ? "write the name of a format, and no #define of that name: Iris "
                                      "would put its value here"
           : nearest.empty()        ? "see the list of formats, for example RGBA16F"
                                    : fmt::format("did you mean {}?", nearest));
  }

  void readClearColor(const ConstLine& line, TargetSettings& target) {
    constexpr size_t kCount = 4;
    const VectorValue color = parseVector(line.value, line.type, kCount);
    if (color.use == VectorValue::Use::Taken) {
      target.clearColor.emplace();
      std::copy(color.numbers.begin(), color.numbers.end(), target.clearColor->begin());
      return;
    }
    const bool refused = color.use == VectorValue::Use::Refused;
    diagnostics_.push_back(withEffect(
        at(refused ? Severity::Error : Severity::Warning, "directive-value", line,
           fmt::format("{} is no clear colour", line.value), "write vec4 with four numbers"),
        refused ? Effect::RefusesPack : Effect::IgnoresLine));
  }

  void readFloat(const ConstLine& line) {
    const bool fov = line.name == kShadowMapFov;
    const auto* known = find(kFloats, line.name);
    if (!known && !fov) return;
    const auto value = parseFloat(line.value);
    if (!value) return notLiteral(line);
    if (fov) {
      out_.shadowMapFov = *value;
    } else {
      out_.*known->field = *value;
    }
    if (line.name == kDryness) warnOfDryness(line);
    out_.ambientOcclusionLevel = std::clamp(out_.ambientOcclusionLevel, 0.0f, 1.0f);
  }

  void warnOfDryness(const ConstLine& line) {
    report(Severity::Warning, "directive-slip", line,
           fmt::format("Iris sets the wetness half-life by {}, and dryness keeps {}", kDryness,
                       PackDirectives().drynessHalflife),
           "a slip of Iris's: leave the line out, or write the line of wetnessHalflife behind it, as the last of both "
           "counts");
  }

  void readInt(const ConstLine& line) {
    const auto* known = find(kInts, line.name);
    if (!known) return;
    const auto value = parseInteger(line.value);
    if (!value) return notLiteral(line);
    constexpr int kLargest = 16384;
    if (*value < 1 || *value > kLargest) {
      report(Severity::Error, "directive-value", line,
             fmt::format("{} is {}, expected 1 to {}", line.name, line.value, kLargest), "");
      return;
    }
    out_.*known->field = static_cast<int>(*value);
  }

  void readBool(const ConstLine& line) {
    const auto on = parseConstBoolean(line.value);
    if (!on) return;
    if (const auto* known = find(kSwitches, line.name)) {
      for (int i = known->first; i <= known->last; ++i)
        out_.shadowtex[static_cast<size_t>(i)].*known->field = *on;
    }
    if (line.name == kShadowColorMipmap) {
      for (int i = 0; i < kShadowColorTargets; ++i) out_.shadowcolor[i].mipmap = *on;
    }
  }

  void notLiteral(const ConstLine& line) {
    diagnostics_.push_back(withEffect(
        at(Severity::Warning, "directive-value", line,
           fmt::format("{} has the value \"{}\", which is no number", line.name, line.value),
           "the host reads literals only, no expressions"),
        Effect::IgnoresLine));
  }

  const std::vector<IncludeSite>& sites_;
  PackDirectives& out_;
  Diagnostics& diagnostics_;
};

}  // namespace

void readPackDirectives(const std::vector<ConstLine>& lines, const std::vector<IncludeSite>& sites,
                        PackDirectives& directives, Diagnostics& diagnostics) {
  PackReader reader(sites, directives, diagnostics);
  for (const ConstLine& line : lines) reader.read(line);
}

std::vector<std::string_view> packDirectiveNames() {
  std::vector<std::string_view> names{kShadowMapFov, kShadowColorMipmap};
  const auto add = [&](const auto& rows) {
    for (const auto& row : rows) names.push_back(row.name);
  };
  add(kFloats);
  add(kInts);
  add(kSwitches);
  return names;
}

}  // namespace orris
