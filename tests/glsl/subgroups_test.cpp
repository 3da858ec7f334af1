#include <orris/glsl/rewrite/subgroups.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "glsl/glsl_test.h"

namespace orris {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::string kAsked = "#version 450\n#extension GL_KHR_shader_subgroup_arithmetic : enable\n";

StageText subgroupStage(Stage stage, const std::string& text) {
  Diagnostics diagnostics;
  const std::string file = std::string("/a.") + stageExtension(stage);
  TokenStream stream = preprocess(test::flatten({{file, text}}, file), {}, diagnostics);
  return {stage, print(stream)};
}

std::string subgroupErrors(const StageText& stage) {
  Diagnostics diagnostics;
  validateWithGlslang({&stage}, [](const std::string&, int) { return ""; }, diagnostics);
  return test::format(diagnostics);
}

TEST(subgroups, operations_of_a_compute_stage_exchange_values) {
  const auto text = emulateSubgroups(subgroupStage(
      Stage::Compute, kAsked + "layout(local_size_x = 64) in;\nshared uint n[gl_NumSubgroups];\n"
                               "void main() {\n  n[gl_SubgroupID] = subgroupAdd(gl_SubgroupInvocationID);\n"
                               "  barrier();\n}\n"));
  ASSERT_TRUE(text);
  EXPECT_THAT(text->text.text, Not(HasSubstr("#extension")));
  EXPECT_THAT(text->text.text,
              HasSubstr("n[(gl_LocalInvocationIndex / 32u)] = orris_subgroupAdd("
                        "(gl_LocalInvocationIndex & 31u));\n  orris_barrier();\n}\n"
                        " void main() { orris_begin(); orris_main(); orris_barrier(); }"));
  EXPECT_EQ(subgroupErrors(*text), "");
}

TEST(subgroups, every_operation_compiles_for_its_types) {
  const std::string calls =
      "  float f = subgroupAdd(1.0) + subgroupMul(2.0) + subgroupMin(1.0) + subgroupMax(1.0);\n"
      "  f += subgroupInclusiveAdd(1.0) + subgroupExclusiveAdd(1.0) + subgroupClusteredMax(1.0, 4);\n"
      "  uint u = subgroupAnd(1u) | subgroupOr(2u) ^ subgroupXor(3u) + subgroupExclusiveXor(1u);\n"
      "  vec3 v = subgroupShuffle(vec3(1), 3u) + subgroupShuffleXor(vec3(1), 1u);\n"
      "  v += subgroupShuffleUp(vec3(1), 1u) + subgroupShuffleDown(vec3(1), 1u);\n"
      "  ivec2 i = subgroupQuadBroadcast(ivec2(1), 2u) + subgroupQuadSwapHorizontal(ivec2(1));\n"
      "  i += subgroupQuadSwapVertical(ivec2(1)) + subgroupQuadSwapDiagonal(ivec2(1));\n"
      "  uvec4 b = subgroupBallot(true) + subgroupBroadcast(uvec4(1), 0u) + gl_SubgroupLtMask;\n"
      "  bool c = subgroupElect() && subgroupAll(true) && subgroupAny(false);\n"
      "  c = c && subgroupAllEqual(f) && subgroupInverseBallot(b) && subgroupBroadcastFirst(c);\n"
      "  u += subgroupBallotBitCount(b) + subgroupBallotInclusiveBitCount(b);\n"
      "  u += subgroupBallotExclusiveBitCount(b) + subgroupBallotFindLSB(b) + subgroupBallotFindMSB(b);\n"
      "  c = subgroupBallotBitExtract(b, gl_SubgroupSize - 1u);\n"
      "  subgroupBarrier(); subgroupMemoryBarrier(); subgroupMemoryBarrierBuffer();\n"
      "  subgroupMemoryBarrierImage(); subgroupMemoryBarrierShared();\n}\n";
  const auto text = emulateSubgroups(subgroupStage(
      Stage::Compute, "#version 450\nlayout(local_size_x = 8, local_size_y = 4) in;\nvoid main() {\n" + calls));
  ASSERT_TRUE(text);
  EXPECT_EQ(subgroupErrors(*text), "");
}

TEST(subgroups, an_invocation_of_another_stage_is_alone) {
  const auto text = emulateSubgroups(subgroupStage(
      Stage::Fragment,
      kAsked + "out vec4 color;\nvoid main() {\n  color = subgroupAdd(vec4(1)) * float(gl_SubgroupSize);\n"
               "  if (subgroupAny(color.x > 0.5) && subgroupElect()) color = subgroupExclusiveAdd(color);\n}\n"));
  ASSERT_TRUE(text);
  EXPECT_THAT(text->text.text, HasSubstr("orris_subgroupAdd(vec4(1)) * float(1u)"));
  EXPECT_THAT(text->text.text, Not(HasSubstr("barrier")));
  EXPECT_EQ(subgroupErrors(*text), "");
}

TEST(subgroups, a_text_without_them_stays) {
  EXPECT_FALSE(emulateSubgroups(subgroupStage(
      Stage::Compute, "#version 450\nlayout(local_size_x = 4) in;\nvoid main() { barrier(); }\n")));
}

}  // namespace
}  // namespace orris
