// What a driver lacks, done with other code: the values must be those of the specification.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include <orris/render/gpu_program.h>
#include <orris/gl/context.h>
#include <orris/gl/functions.h>

namespace orris {
namespace {

using ::testing::ElementsAre;

/// Dispatches a compute program that writes uints to the buffer at binding 0.
class LackingDriver : public ::testing::TestWithParam<gl::ContextProfile> {
 protected:
  void SetUp() override {
    gl::ContextRequest request;
    request.backend = gl::Backend::OSMesa;
    request.profile = GetParam();
    Diagnostics diagnostics;
    context_ = gl::createContext(request, diagnostics);
    if (!context_) GTEST_SKIP() << diagnostics.front().message;
  }

  std::vector<std::uint32_t> run(const std::string& body, unsigned groups, std::size_t results) {
    StageText stage{Stage::Compute, {}};
    stage.text.text = body;
    Diagnostics diagnostics;
    GpuProgram program = buildGpuProgram(
        "test", {&stage}, [](const std::string&, int) { return ""; }, diagnostics);
    for (const Diagnostic& d : diagnostics) rules_ += d.message + "\n";
    std::vector<std::uint32_t> values(results);
    if (!program.program.linked) return values;
    const gl::Buffer buffer = gl::createBuffer(results * sizeof(std::uint32_t), nullptr, "results");
    gl::BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffer.id());
    bindSharedBlocks(program, groups);
    gl::UseProgram(program.program.id());
    gl::DispatchCompute(groups, 1, 1);
    gl::MemoryBarrier(GL_ALL_BARRIER_BITS);
    gl::read(buffer, 0, buffer.size, values.data());
    EXPECT_THAT(context_->takeErrors(), ElementsAre());
    return values;
  }

  std::unique_ptr<gl::Context> context_;
  std::string rules_;
};

TEST_P(LackingDriver, shared_memory_beyond_the_limit_is_one_of_each_work_group) {
  const auto values = run(
      "#version 450\nlayout(local_size_x = 256) in;\n"
      "layout(std430, binding = 0) buffer Results { uint results[]; };\n"
      "shared uvec4 a[256][11];\n"
      "void main() {\n  uint i = gl_LocalInvocationIndex;\n"
      "  for (int k = 0; k < 11; ++k) a[i][k] = uvec4(i + 1000u * gl_WorkGroupID.x);\n"
      "  memoryBarrierShared();\n  barrier();\n"
      "  results[gl_GlobalInvocationID.x] = a[255u - i][10].w;\n}\n",
      3, 768);
  EXPECT_THAT(rules_, ::testing::HasSubstr("rule shared-buffer"));
  for (std::uint32_t i = 0; i < 768; ++i) ASSERT_EQ(values[i], 255 - i % 256 + 1000 * (i / 256)) << i;
}

// As packs do it: each subgroup reduces, the first one the rest, in a branch and in a loop.
TEST_P(LackingDriver, a_reduction_by_subgroups_gives_the_sum) {
  const auto values = run(
      "#version 450\n#extension GL_KHR_shader_subgroup_arithmetic : require\n"
      "layout(local_size_x = 256) in;\n"
      "layout(std430, binding = 0) buffer Results { uint results[]; };\n"
      "shared uint parts[8][4];\n"
      "void main() {\n  uint i = gl_LocalInvocationIndex;\n  uint sums[4];\n"
      "  for (uint k = 0u; k < 4u; ++k) {\n    sums[k] = subgroupAdd(i * (k + 1u));\n"
      "    if (subgroupElect()) parts[gl_SubgroupID][k] = sums[k];\n  }\n"
      "  barrier();\n"
      "  if (i < gl_NumSubgroups) {\n"
      "    for (uint k = 0u; k < 4u; ++k) sums[k] = subgroupAdd(parts[i][k]);\n  }\n"
      "  if (i == 0u) for (uint k = 0u; k < 4u; ++k) results[k] = sums[k];\n"
      "  barrier();\n"
      "  if (i == 255u) { results[4] = parts[7][3]; results[5] = gl_SubgroupSize; }\n}\n",
      1, 6);
  EXPECT_THAT(rules_, ::testing::HasSubstr("rule subgroups"));
  const std::uint32_t all = 255 * 256 / 2, last = 4 * (224 + 255) * 16;
  EXPECT_THAT(values, ElementsAre(all, 2 * all, 3 * all, 4 * all, last, 32));
}

TEST_P(LackingDriver, only_invocations_that_take_part_count) {
  const auto values = run(
      "#version 450\n#extension GL_KHR_shader_subgroup_ballot : enable\n"
      "#extension GL_KHR_shader_subgroup_arithmetic : enable\n"
      "layout(local_size_x = 8, local_size_y = 8) in;\n"
      "layout(std430, binding = 0) buffer Results { uint results[]; };\n"
      "void main() {\n  uint i = gl_LocalInvocationIndex, r = 0u;\n"
      "  if (i % 3u == 1u) r = subgroupBallot(i % 2u == 0u).x;\n"
      "  else r = subgroupBroadcastFirst(i) + subgroupInclusiveAdd(1u);\n"
      "  results[i] = r;\n}\n",
      1, 64);
  EXPECT_THAT(rules_, ::testing::HasSubstr("rule subgroups"));
  std::uint32_t counted = 0;
  for (std::uint32_t i = 0; i < 64; ++i) {
    const std::uint32_t first = i & ~31u;
    if (i == first) counted = 0;
    std::uint32_t ballot = 0;
    for (std::uint32_t k = first; k < first + 32; ++k)
      if (k % 3 == 1 && k % 2 == 0) ballot |= 1u << (k - first);
    const std::uint32_t elected = first % 3 == 1 ? first + 1 : first;
    counted += i % 3 == 1 ? 0 : 1;
    EXPECT_EQ(values[i], i % 3 == 1 ? ballot : elected + counted) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Profiles, LackingDriver,
                         ::testing::Values(gl::ContextProfile::Compatibility,
                                           gl::ContextProfile::Core),
                         [](const auto& made) {
                           return made.param == gl::ContextProfile::Core ? "core" : "compatibility";
                         });

}  // namespace
}  // namespace orris
