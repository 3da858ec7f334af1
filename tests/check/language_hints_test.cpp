#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <orris/check/compile/program_check.h>

#include "frame_fixture.h"

namespace orris {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// The first error of a pack with this fragment stage, as "place: message | hint | place: message".
std::string errorOf(const std::string& body, Files more = {}) {
  more["/composite.vsh"] = kVertexStage;
  more["/composite.fsh"] = kVersion + body;
  const ShaderPack pack = loadClean(more);
  Verdicts verdicts;
  Diagnostics found;
  checkWithGlslang(pack, 1, verdicts, found);
  if (found.empty()) return "";
  const Diagnostic& d = found.front();
  std::string text = formatLocation(d.at) + ": " + d.message + " | " + d.hint;
  for (const RelatedPlace& place : d.related)
    text += " | " + formatLocation(place.at) + ": " + place.message;
  return text;
}

std::string errorIn(const std::string& statement) {
  return errorOf(
      "void main() {\n  vec2 a = vec2(0.5), b = a;\n  bvec2 c = bvec2(true), d = c;\n  " +
      statement + "\n  gl_FragData[0] = vec4(1.0);\n}\n");
}

TEST(LanguageHints, parameters_have_no_default_values) {
  EXPECT_THAT(errorOf("float shade(float x, float y = 1.0) { return x * y; }\n"
                      "void main() { gl_FragData[0] = vec4(shade(1.0)); }\n"),
              AllOf(HasSubstr("/composite.fsh:2:30: syntax error"),
                    HasSubstr(" | GLSL has no default values of parameters")));
}

TEST(LanguageHints, what_vectors_have_for_an_operator_of_scalars) {
  EXPECT_THAT(errorIn("bool e = c || d;"), HasSubstr("any(a) || any(b)"));
  EXPECT_THAT(errorIn("bool e = c && d;"), HasSubstr("all(a) && all(b)"));
  EXPECT_THAT(errorIn("bvec2 e = !c;"), HasSubstr("not(v)"));
  EXPECT_THAT(errorIn("if (a < b) discard;"), HasSubstr("lessThan(a, b)"));
  EXPECT_THAT(errorIn("if (a > b) discard;"), HasSubstr("greaterThan(a, b)"));
  EXPECT_THAT(errorIn("if (a <= b) discard;"), HasSubstr("lessThanEqual(a, b)"));
  EXPECT_THAT(errorIn("if (a >= b) discard;"), HasSubstr("greaterThanEqual(a, b)"));
  EXPECT_THAT(errorIn("float e = a.x % 2.0;"), HasSubstr("mod(a, b)"));
  EXPECT_THAT(errorIn("vec2 e = a % 2.0;"), HasSubstr("mod(a, b)"));
  EXPECT_THAT(errorIn("vec2 e = a & 2;"), Not(HasSubstr("mod(")));
}

TEST(LanguageHints, a_name_that_a_macro_replaces_by_nothing) {
  EXPECT_THAT(errorOf("#include \"/lib/options.glsl\"\nvoid main() {\n  float noise = 1.0;\n  "
                      "gl_FragData[0] = vec4(1.0);\n}\n",
                      {{"/lib/options.glsl", "#define noise // [on]\n"}}),
              AllOf(HasSubstr("/composite.fsh:4:15: syntax error"),
                    HasSubstr(" | 'noise' is a macro that stands for nothing here"),
                    HasSubstr("/lib/options.glsl:1:1: 'noise' is defined here")));
}

TEST(LanguageHints, of_a_macro_that_is_not_beside_the_error_nothing_is_said) {
  EXPECT_THAT(errorOf("#define INLINE\nINLINE float one( { return 1.0; }\nvoid main() { "
                      "gl_FragData[0] = vec4(one()); }\n"),
              Not(HasSubstr("macro")));
  EXPECT_THAT(errorOf("#define noise\n#undef noise\nvoid main() {\n  float noise 1.0;\n  "
                      "gl_FragData[0] = vec4(noise);\n}\n"),
              Not(HasSubstr("macro")));
}

}  // namespace
}  // namespace orris
