#include <array>
#include <cstdint>

#include <orris/gl/buffer.h>
#include <orris/gl/functions.h>
#include "gl/gl_test_context.h"
#include <orris/gl/program.h>

namespace orris::gl {
namespace {

using testing::Each;
using testing::ElementsAre;

class BufferTest : public GlTest {};

TEST_F(BufferTest, without_data_holds_zeros) {
  const Buffer buffer = createBuffer(64, nullptr, "bufferObject.0");
  std::array<std::uint8_t, 64> bytes;
  bytes.fill(7);
  read(buffer, 0, bytes.size(), bytes.data());
  EXPECT_THAT(bytes, Each(0));
}

TEST_F(BufferTest, part_can_be_replaced) {
  const std::array<std::uint32_t, 4> values = {1, 2, 3, 4};
  const Buffer buffer = createBuffer(sizeof values, values.data(), "counts");
  const std::uint32_t nine = 9;
  upload(buffer, 8, sizeof nine, &nine);
  std::array<std::uint32_t, 4> result{};
  read(buffer, 0, sizeof result, result.data());
  EXPECT_THAT(result, ElementsAre(1, 2, 9, 4));
  clearToZero(buffer);
  read(buffer, 0, sizeof result, result.data());
  EXPECT_THAT(result, Each(0));
}

TEST_F(BufferTest, may_be_empty) {
  const Buffer buffer = createBuffer(0, nullptr, "empty");
  EXPECT_NE(buffer.id(), 0u);
  EXPECT_EQ(buffer.size, 0u);
}

TEST_F(BufferTest, is_written_by_compute_and_read_back) {
  const Buffer buffer = createBuffer(16, nullptr, "bufferObject.1");
  const Program program = buildProgram({{GL_COMPUTE_SHADER, R"(#version 430
layout(local_size_x = 4) in;
layout(std430, binding = 1) buffer Out { uint values[]; };
void main() { values[gl_GlobalInvocationID.x] = gl_GlobalInvocationID.x * 3u; })"}},
                                       {}, "setup");
  ASSERT_TRUE(program.linked) << program.stageLogs[0];
  UseProgram(program.id());
  BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, buffer.id());
  DispatchCompute(1, 1, 1);
  UseProgram(0);
  std::array<std::uint32_t, 4> result{};
  read(buffer, 0, sizeof result, result.data());
  EXPECT_THAT(result, ElementsAre(0, 3, 6, 9));
}

}  // namespace
}  // namespace orris::gl
