// shaders.properties.
#include <vector>

#include <orris/check/rules/rule_tables.h>

namespace orris {

std::span<const Rule> propertyRules() {
  static const std::vector<Rule> kRules = {
      {"alpha-test", Severity::Warning, "an alphaTest cannot be read"},
      {"auto-option", Severity::Warning, "what a value of an AUTO option costs cannot be read"},
      {"blend-factor", Severity::Error, "a blend factor does not exist"},
      {"blend-syntax", Severity::Error, "a blend mode is neither off nor four factors"},
      {"buffer-file-long", Severity::Error, "the file of a bufferObject is larger than the buffer"},
      {"buffer-file-missing", Severity::Warning, "the file of a bufferObject is not in the pack"},
      {"buffer-object-syntax", Severity::Warning, "a bufferObject cannot be read"},
      {"buffer-size", Severity::Error, "a bufferObject cannot be made"},
      {"buffer-unknown", Severity::Warning, "a property names a buffer that does not exist"},
      {"counter-warning", Severity::Warning, "a warn line names no counter of the pack"},
      {"dimension-folder", Severity::Warning,
       "a key of dimension.properties names no folder of the pack"},
      {"expression-slip", Severity::Warning,
       "a function of a custom uniform works otherwise in Iris than documented"},
      {"feature-case", Severity::Warning, "an optional feature flag is not in capitals"},
      {"feature-undeclared", Severity::Error,
       "something is used without the feature flag it needs"},
      {"feature-unsupported", Severity::Error, "a required feature flag is not offered"},
      {"image-format", Severity::Error, "a custom image has a format that images cannot have"},
      {"image-limit", Severity::Warning, "there are more custom images than the host has"},
      {"image-size", Severity::Error, "a custom image is too large"},
      {"image-syntax", Severity::Warning, "a custom image cannot be read"},
      {"program-condition", Severity::Warning,
       "the condition of program.NAME.enabled cannot be read"},
      {"program-unknown", Severity::Warning, "a property names a program that does not exist"},
      {"properties-character", Severity::Warning,
       "Iris stops reading a properties file at a letter"},
      {"property-comment", Severity::Note, "a line of a properties file begins with //"},
      {"property-limit", Severity::Error,
       "more keys, words or options of a kind than a pack may have"},
      {"property-stray-line", Severity::Warning,
       "a line of a list in shaders.properties is a key of its own"},
      {"property-twice", Severity::Warning,
       "a key of shaders.properties is given twice with different values"},
      {"property-unknown", Severity::Warning, "a key of shaders.properties is unknown"},
      {"property-value", Severity::Warning, "a property has a value that it cannot have"},
      {"texture-format", Severity::Warning, "a raw texture has unknown formats"},
      {"texture-missing", Severity::Warning, "a custom texture's file is not in the pack"},
      {"texture-path", Severity::Error, "the path of a texture leads out of the pack"},
      {"texture-short", Severity::Error, "the file of a raw texture has too few bytes"},
      {"texture-size", Severity::Warning, "the declared size of a raw texture is wrong"},
      {"texture-stage", Severity::Warning,
       "customTexture or texture names a stage that does not exist"},
      {"texture-syntax", Severity::Warning, "a custom texture cannot be read"},
      {"uniform-cycle", Severity::Error, "custom uniforms depend on each other in a circle"},
      {"uniform-dropped", Severity::Warning, "the expression of a custom uniform is wrong"},
      {"uniform-duplicate", Severity::Warning, "a custom uniform is defined twice"},
      {"uniform-syntax", Severity::Warning, "a custom uniform cannot be read"},
  };
  return kRules;
}

}  // namespace orris
