// Includes and preprocessing.
#include <vector>

#include <orris/check/rules/rule_tables.h>

namespace orris {

std::span<const Rule> textRules() {
  static const std::vector<Rule> kRules = {
      {"byte-order-mark", Severity::Error, "a shader file begins with a byte-order mark"},
      {"comment-nested", Severity::Warning, "a block comment has another \"/*\" in it"},
      {"comment-unclosed", Severity::Error, "a block comment is not closed"},
      {"condition-decimal", Severity::Warning, "a condition compares with a decimal number"},
      {"condition-empty", Severity::Warning, "the condition of #if or #elif is empty"},
      {"condition-malformed", Severity::Warning,
       "the condition of #if or #elif cannot be computed"},
      {"condition-undefined", Severity::Warning, "an #if asks for a name that nothing defines"},
      {"conditional-unbalanced", Severity::Warning, "#if, #else and #endif do not match"},
      {"directive-error", Severity::Error, "an active #error stands in the source"},
      {"directive-malformed", Severity::Warning, "a preprocessor directive is not complete"},
      {"directive-trailing-text", Severity::Warning, "there is text after the end of a directive"},
      {"directive-unknown", Severity::Warning, "a preprocessor directive does not exist"},
      {"include-capitals", Severity::Error, "an include names a file with other capitals"},
      {"include-cycle", Severity::Error, "files include each other in a circle"},
      {"include-escape", Severity::Error, "an include leads out of the shaders folder"},
      {"include-missing", Severity::Error, "an include names a file that is not in the pack"},
      {"include-syntax", Severity::Error, "an include is not one path in quotes"},
      {"include-too-deep", Severity::Error, "includes are nested too deeply"},
      {"include-unused", Severity::Note, "no program includes a file"},
      {"macro-arguments", Severity::Error, "a macro is called with the wrong number of arguments"},
      {"macro-expansion-limit", Severity::Error, "a macro expands without bound"},
      {"macro-never", Severity::Warning, "a condition asks for a macro that Iris never defines"},
      {"macro-unterminated", Severity::Error, "the call of a macro is not closed"},
      {"source-too-large", Severity::Error, "a stage has too much text with its includes in place"},
      {"stage-too-large", Severity::Error, "a stage has a function, array or switch that a driver cannot hold"},
      {"struct-too-large", Severity::Error, "a struct has too many members"},
      {"text-too-large", Severity::Error, "a text file is larger than any pack needs"},
      {"text-utf16", Severity::Error, "a text file is UTF-16"},
      {"version-malformed", Severity::Error, "#version is none of GLSL's"},
      {"version-missing", Severity::Error, "a stage has no active #version"},
      {"version-repeated", Severity::Error, "a stage has a second active #version"},
  };
  return kRules;
}

}  // namespace orris
