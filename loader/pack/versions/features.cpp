#include <orris/pack/versions/features.h>

#include <fmt/format.h>

#include <algorithm>

#include <orris/pack/files/text.h>

namespace orris {
namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void requireFlag(const ShaderProperties& properties, const std::string& flag, std::string_view what,
                 const SourceLocation& at, Diagnostics& diagnostics) {
  if (properties.feature(flag)) return;
  diagnostics.push_back(
      withEffect({.severity = Severity::Error,
                  .id = "feature-undeclared",
                  .at = at,
                  .message = fmt::format("{} without the feature flag {}", what, flag),
                  .hint = fmt::format("add iris.features.required={}", flag)},
                 Effect::RefusesPack));
}

}  // namespace

std::vector<std::string> supportedFeatures(const Version& iris) {
  static const std::vector<std::string> kNames{"SEPARATE_HARDWARE_SAMPLERS",
                                               "HIGHER_SHADOWCOLOR",
                                               "CUSTOM_IMAGES",
                                               "PER_BUFFER_BLENDING",
                                               "COMPUTE_SHADERS",
                                               "TESSELLATION_SHADERS",
                                               "ENTITY_TRANSLUCENT",
                                               "REVERSED_CULLING",
                                               "BLOCK_EMISSION_ATTRIBUTE",
                                               "SSBO",
                                               "CAN_DISABLE_WEATHER",
                                               "FADE_VARIABLE",
                                               "TEXTURE_FILTERING"};
  std::vector<std::string> names = kNames;
  std::erase_if(names, [&](auto& name) { return !offers(iris, Offer::Feature, name); });
  return names;
}

const std::vector<std::string>& supportedOrrisFeatures() {
  static const std::vector<std::string> kNames{kShadowVolumes, kAutoOptions};
  return kNames;
}

void requireFeatures(const PropertyContext& context, const std::vector<std::string>& supported) {
  for (const std::string& flag : splitBlanks(context.entry.value)) {
    if (contains(supported, upperCase(flag))) continue;
    if (const OfferRow* newer = findOffer(Offer::Feature, upperCase(flag))) {
      context.refuse(
          "feature-unsupported",
          fmt::format("Iris {} does not offer the feature {}", versionText(context.iris), flag),
          fmt::format("Iris {} is the first one that does; iris.features.optional lets older ones "
                      "load the pack",
                      versionText(newer->iris)),
          flag);
      continue;
    }
    const std::string hint = suggest(flag, supported);
    const bool ofIris = context.entry.key.starts_with("iris.");
    (context.*(ofIris ? &PropertyContext::refuse : &PropertyContext::fail))(
        "feature-unsupported", fmt::format("this host does not offer the feature {}", flag),
        !hint.empty()       ? hint
        : supported.empty() ? "make the feature optional"
                            : "offered are " + joinNames(supported),
        flag);
  }
}

void warnOfFlagCase(const PropertyContext& context) {
  for (const std::string& flag : splitBlanks(context.entry.value)) {
    if (flag == upperCase(flag) || !contains(supportedFeatures(), upperCase(flag))) continue;
    context.warn("feature-case",
                 fmt::format("Iris defines the macro IRIS_FEATURE_{}, as it is written here", flag),
                 fmt::format("write {}", upperCase(flag)), flag);
  }
}

void checkDeclared(const ShaderProperties& properties, Diagnostics& diagnostics) {
  if (!properties.bufferObjects.empty()) {
    requireFlag(properties, "SSBO", "buffer objects", properties.bufferObjects.front().at,
                diagnostics);
  }
  if (!properties.images.empty()) {
    requireFlag(properties, "CUSTOM_IMAGES", "custom images", properties.images.front().at,
                diagnostics);
  }
}

// Iris: ShadowRenderTargets.
void checkShadowColors(const ProgramList& programs, const ShaderProperties& properties,
                       Diagnostics& diagnostics) {
  constexpr int kWithoutFlag = 2;
  for (const ProgramSource& program : programs) {
    if (program.group != ProgramGroup::Shadow && program.group != ProgramGroup::ShadowComp)
      continue;
    for (const int buffer : program.drawBuffers) {
      if (buffer < kWithoutFlag) continue;
      requireFlag(properties, "HIGHER_SHADOWCOLOR", "shadow colours above shadowcolor1",
                  program.directives.drawBuffersAt, diagnostics);
      break;
    }
  }
}

MacroDefinitions propertyFeatureMacros(const Version& iris) {
  MacroDefinitions macros;
  for (const std::string& flag : supportedFeatures(iris))
    macros.emplace_back("IRIS_FEATURE_" + flag, "");
  for (const std::string& flag : supportedOrrisFeatures())
    macros.emplace_back("ORRIS_FEATURE_" + flag, "");
  return macros;
}

MacroDefinitions shaderFeatureMacros(const ShaderProperties& properties, const Version& iris) {
  MacroDefinitions macros;
  // Iris: ShaderPack, which takes the name as it is written.
  const std::vector<std::string> offered = supportedFeatures(iris);
  for (const std::string& flag : properties.optionalAsWritten) {
    if (contains(offered, upperCase(flag))) macros.emplace_back("IRIS_FEATURE_" + flag, "");
  }
  // Our own extension has one rule for both lists: what is there has its macro.
  for (const auto* list : {&properties.orrisRequiredFeatures, &properties.orrisOptionalFeatures}) {
    for (const std::string& flag : *list) {
      if (contains(supportedOrrisFeatures(), flag))
        macros.emplace_back("ORRIS_FEATURE_" + flag, "");
    }
  }
  constexpr const char* kColorSpaces[] = {"SRGB", "DCI_P3", "DISPLAY_P3", "REC2020", "ADOBE_RGB"};
  if (properties.flag("supportsColorCorrection", false)) {
    for (int i = 0; i < 5; ++i) {
      macros.emplace_back(std::string("COLOR_SPACE_") + kColorSpaces[i], std::to_string(i));
    }
  }
  return macros;
}

}  // namespace orris
