#include <orris/glsl/rewrite/shared_buffer.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "glsl/glsl_test.h"

namespace orris {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string kComputeHead = "#version 430\nlayout(local_size_x = 4) in;\n";

StageText computeOf(const std::string& body) {
  Diagnostics diagnostics;
  TokenStream stream =
      preprocess(test::flatten({{"/a.csh", kComputeHead + body}}, "/a.csh"), {}, diagnostics);
  return {Stage::Compute, print(stream)};
}

std::string compileErrors(const StageText& stage) {
  Diagnostics diagnostics;
  validateWithGlslang({&stage}, [](const std::string&, int) { return ""; }, diagnostics);
  return test::format(diagnostics);
}

TEST(sharedBuffer, an_array_lies_in_a_part_of_a_buffer_for_each_work_group) {
  const auto moved = moveSharedToBuffers(computeOf(
      "shared vec3 a[4][9];\nvoid main() {\n  a[0][1] = vec3(1);\n  barrier();\n}\n"));
  ASSERT_TRUE(moved);
  EXPECT_THAT(moved->blocks, ElementsAre("orris_SharedBlock0"));
  EXPECT_THAT(moved->text.text.text,
              HasSubstr("struct orris_Shared0 { vec3 a[4][9]; }; layout(std430) coherent buffer "
                        "orris_SharedBlock0 { orris_Shared0 orris_shared0[]; };\nvoid main() {\n"
                        "  orris_shared0[orris_group()].a[0][1] = vec3(1);\n"
                        "  orris_bufferBarrier();\n}\n"));
  EXPECT_EQ(compileErrors(moved->text), "");
}

TEST(sharedBuffer, several_declarations_and_names_move_and_single_values_stay) {
  const auto moved = moveSharedToBuffers(computeOf(
      "struct S { vec4 v; };\nshared S[4] s, t;\nshared uint n;\nshared highp float f[gl_WorkGroupSize.x];\n"
      "void add(uint i) { atomicAdd(n, 1u); s[i].v += t[i].v * f[i]; memoryBarrierShared(); }\n"
      "void main() { add(gl_LocalInvocationIndex); barrier(); }\n"));
  ASSERT_TRUE(moved);
  EXPECT_EQ(moved->blocks.size(), 2u);
  EXPECT_THAT(moved->text.text.text, HasSubstr("shared uint n;"));
  EXPECT_EQ(compileErrors(moved->text), "");
}

TEST(sharedBuffer, members_of_the_same_name_stay) {
  const auto moved = moveSharedToBuffers(
      computeOf("shared float a[4];\nvoid main() { vec4 s = vec4(1); a[0] = s.a; }\n"));
  ASSERT_TRUE(moved);
  EXPECT_THAT(moved->text.text.text, HasSubstr("orris_shared0[orris_group()].a[0] = s.a;"));
}

TEST(sharedBuffer, a_name_that_stands_for_something_else_too_is_left_alone) {
  EXPECT_FALSE(moveSharedToBuffers(
      computeOf("shared float a[4];\nfloat f(float a) { return a; }\nvoid main() { a[0] = f(1.0); }\n")));
}

TEST(sharedBuffer, without_arrays_there_is_nothing_to_move) {
  EXPECT_FALSE(moveSharedToBuffers(computeOf("shared uint n;\nvoid main() { n = 1u; }\n")));
}

}  // namespace
}  // namespace orris
