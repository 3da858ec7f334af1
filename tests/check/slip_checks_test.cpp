#include <orris/check/pack/slip_checks.h>

#include <orris/check/pack/decimal_conditions.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "frame_fixture.h"

namespace orris {
namespace {

using testing::ElementsAre;

std::vector<std::string> slipsIn(const std::string& final, const std::string& properties = "") {
  Files files = cleanPack();
  files["/final.fsh"] += final;
  if (!properties.empty()) files["/shaders.properties"] = properties;
  return messagesOf(
      [](const FolderInput& input, Diagnostics& diagnostics) {
        checkPropertyNames({&input.pack, 1}, diagnostics);
      },
      files);
}

TEST(Slips, an_option_of_a_condition) {
  EXPECT_THAT(slipsIn("#define BLOOM_ON\n#ifdef BLOOM_ON\n#endif\n",
                      "program.composite2.enabled = BLOMO_ON || IS_IRIS\n"),
              ElementsAre("program-condition /shaders.properties:1:1: warning: the pack has no "
                          "option BLOMO_ON | did you mean BLOOM_ON?"));
}

std::vector<std::string> textSlips(const std::string& final,
                                   void (*check)(std::span<const ShaderPack>, Diagnostics&)) {
  ShaderPack pack;
  pack.files["/final.fsh"] = {};
  for (size_t begin = 0; begin < final.size();) {
    const size_t end = final.find('\n', begin);
    pack.files["/final.fsh"].push_back(final.substr(begin, end - begin));
    begin = end + 1;
  }
  Diagnostics diagnostics;
  check({&pack, 1}, diagnostics);
  std::vector<std::string> found;
  for (const Diagnostic& d : diagnostics)
    found.push_back(std::to_string(d.at.line) + ":" + std::to_string(d.at.column) + " " +
                    d.message);
  return found;
}

TEST(Slips, decimals_in_conditions) {
  EXPECT_THAT(
      textSlips("#if A > 0.25 // 0.1\n#elif A == 1\n  #elif .5 < A\n#endif\n", checkDecimals),
      ElementsAre("1:9 conditions count in whole numbers: Iris takes 0.25 for 0",
                  "3:9 conditions count in whole numbers: Iris takes .5 for 0"));
}

TEST(Slips, a_decimal_condition_names_a_value_that_it_takes_for_another) {
  const std::string lists = "#define A 2.0 // [0.5 1.0 2.0]\n#define B A\n#define C 1.5 * A\n";
  const Files files{{"/final.fsh", kVersion + lists +
                                       "#if A > 0.0 && 1.0 <= B\n#elif A + 1.0 > 1.0\n"
                                       "#elif C > 1.0\n#endif\nvoid main() {}\n"}};
  Diagnostics diagnostics;
  const ShaderPack pack = loadClean(files);
  checkDecimals({&pack, 1}, diagnostics);
  std::vector<std::string> reported;
  for (const Diagnostic& d : diagnostics)
    reported.push_back((d.severity == Severity::Note ? "note " : "") + d.message);
  const std::string counts = "conditions count in whole numbers: ";
  // 0.5, 1.0 and 2.0 are at least 1.0 or not, whether cut or not.
  EXPECT_THAT(
      reported,
      ElementsAre(counts + "with A at 0.5 Iris compares 0 > 0",
                  "note " + counts + "Iris takes 1.0 for 1", counts + "Iris takes 1.0 for 1",
                  counts + "Iris takes 1.0 for 1", counts + "Iris takes 1.0 for 1"));
}

TEST(Slips, a_macro_that_iris_never_defines) {
  EXPECT_THAT(
      textSlips("// MC_GL_VENDOR_MESA\n#ifdef MC_GL_VENDOR_MESA\n#endif\n", checkMacroNames),
      ElementsAre("2:8 Iris never defines MC_GL_VENDOR_MESA: with Mesa it defines "
                  "MC_GL_VENDOR_OTHER"));
}

}  // namespace
}  // namespace orris
