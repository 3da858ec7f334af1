#include "check/slip_checks.h"

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

}  // namespace
}  // namespace orris
