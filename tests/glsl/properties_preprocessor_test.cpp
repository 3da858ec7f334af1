#include <gtest/gtest.h>

#include "glsl/glsl_test.h"

namespace orris {
namespace {

std::string properties(const std::string& text, const MacroDefinitions& environment = {}) {
  Diagnostics diagnostics;
  const std::string result =
      preprocessProperties("/shaders.properties", text, environment, diagnostics);
  return diagnostics.empty() ? result : result + "---\n" + test::format(diagnostics);
}

TEST(properties_preprocessor, lines_keep_their_numbers) {
  EXPECT_EQ(properties("a=1\n#ifdef X\nb=2\n#else\nc=3\n#endif\nd=4\n", {{"X", "1"}}),
            "a=1\n\nb=2\n\n\n\nd=4\n");
}

TEST(properties_preprocessor, other_comments_vanish) {
  EXPECT_EQ(properties("# if X\n#note\n! too\n  #ifdef X\na\n#endif\n#line\nb # c\n"),
            "\n\n\n\n\n\n\nb  c\n");
}

TEST(properties_preprocessor, macros_expand_and_other_lines_stay_verbatim) {
  EXPECT_EQ(properties("program.x.enabled = BLOOM && OFF\nsliders = A   B\n", {{"BLOOM", "1"}}),
            "program.x.enabled = 1 && OFF\nsliders = A   B\n");
  EXPECT_EQ(properties("#define WATER 1000\nblock.WATER=minecraft:water[level=0]\n"),
            "\nblock.1000=minecraft:water[level=0]\n");
}

TEST(properties_preprocessor, paths_with_slashes_are_not_cut) {
  EXPECT_EQ(properties("texture.noise=X//tex/noise.png\n", {{"X", "a"}}),
            "texture.noise=a//tex/noise.png\n");
}

TEST(properties_preprocessor, directives_work_inside_a_continued_value) {
  EXPECT_EQ(properties("block.1=\\\n a \\\n#if MC_VERSION >= 11300\n b \\\n#endif\n c\n",
                       {{"MC_VERSION", "11200"}}),
            "block.1=\\\na \\\n\n\n\nc\n");
}

TEST(properties_preprocessor, carriage_returns_vanish) {
  EXPECT_EQ(properties("#if 1\r\na=1\r\n#endif\r\n"), "\na=1\n\n");
}

TEST(properties_preprocessor, problems_are_located_in_the_file) {
  EXPECT_EQ(
      properties("a=1\n  #if (\nb=2\n"),
      "a=1\n\n\n---\n"
      "/shaders.properties:2:7: warning: condition of #if: expected a value at the end of the "
      "expression\n    #if (\n        ^\n"
      "  hint: Iris goes on after this, other hosts refuse the program\n"
      "/shaders.properties:3:1: warning: expected #endif after this line: nothing closes the #if "
      "in line 2\n  b=2\n  ^\n"
      "  note: /shaders.properties:2:3: the #if without #endif\n"
      "  hint: Iris goes on after this, other hosts refuse the program\n");
}

}  // namespace
}  // namespace orris
