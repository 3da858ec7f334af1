// What a pack can read is its own: nothing that others left in the memory of the process or the driver.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#include <orris/gl/buffer.h>
#include <orris/image/texel_format.h>
#include <orris/gl/functions.h>
#include "gl/gl_test_context.h"
#include <orris/gl/program.h>
#include <orris/gl/texture.h>

namespace orris::gl {
namespace {

constexpr std::uint32_t kSecret = 0x5ec2e75e;
constexpr std::size_t kBytes = std::size_t{1} << 20;
constexpr int kSide = 256;  // of four bytes a pixel: kBytes / 4

std::vector<std::uint32_t> secrets(std::size_t bytes) {
  return std::vector<std::uint32_t>(bytes / sizeof kSecret, kSecret);
}

/// Leaves the secret in memory that the driver, or the process, gives out again.
void leaveSecrets() {
  const std::vector<std::uint32_t> text = secrets(kBytes);
  std::vector<Buffer> buffers;
  std::vector<Texture> textures;
  for (int i = 0; i < 16; ++i) {
    buffers.push_back(createBuffer(kBytes, text.data(), "secret"));
    textures.push_back(createTexture(2, *findFormat("RGBA8"), kSide, kSide, 1, 4, "secret"));
    upload(textures.back(), GL_RGBA, GL_UNSIGNED_BYTE, text.data());
    generateMipmaps(textures.back());
  }
  Finish();
}

/// As gmock's Each(0), in a hundredth of the time.
template <class T>
bool allZero(const std::vector<T>& values) {
  return std::all_of(values.begin(), values.end(), [](T value) { return value == 0; });
}

bool holdsSecret(const std::vector<std::uint32_t>& words) {
  return std::find(words.begin(), words.end(), kSecret) != words.end();
}

class MemoryTest : public GlTest {};

TEST_F(MemoryTest, buffers_of_another_are_not_in_new_ones) {
  leaveSecrets();
  for (int i = 0; i < 32; ++i) {
    const Buffer buffer = createBuffer(kBytes, nullptr, "bufferObject.0");
    std::vector<std::uint32_t> words(kBytes / 4, 1);
    read(buffer, 0, kBytes, words.data());
    EXPECT_FALSE(holdsSecret(words));
    EXPECT_TRUE(allZero(words));
  }
}

TEST_F(MemoryTest, pictures_of_another_are_not_in_new_ones) {
  leaveSecrets();
  for (const char* name : {"RGBA8", "R32UI", "RGBA16F", "RGBA32F", "R32I", "R11F_G11F_B10F"}) {
    const TextureFormat* format = findFormat(name);
    ASSERT_NE(format, nullptr) << name;
    const GLenum pixels = format->isInteger() ? GL_RGBA_INTEGER : GL_RGBA;
    const GLenum type = format->isInteger() ? GL_UNSIGNED_INT : GL_FLOAT;
    for (int i = 0; i < 8; ++i) {
      const Texture texture = createTexture(2, *format, kSide, kSide, 1, 4, "colortex0");
      for (int level = 0, side = kSide; level < 4; ++level, side /= 2) {
        std::vector<std::uint32_t> words(std::size_t(side) * std::size_t(side) * 4, 1);
        GetTextureImage(texture.id(), level, pixels, type, GLsizei(words.size() * 4), words.data());
        // Alpha that a format lacks is read as one.
        for (std::size_t at = 0; at < words.size(); ++at)
          if (at % 4 != 3 && words[at] != 0) FAIL() << name << " level " << level;
      }
    }
  }
}

TEST_F(MemoryTest, depth_of_another_is_not_in_a_new_one) {
  leaveSecrets();
  for (int i = 0; i < 8; ++i) {
    const Texture depth = createDepthTexture(kSide, kSide, 1, "depthtex0");
    std::vector<float> values(std::size_t{kSide} * kSide, 0.5f);
    GetTextureImage(depth.id(), 0, GL_DEPTH_COMPONENT, GL_FLOAT, GLsizei(values.size() * 4),
                    values.data());
    EXPECT_TRUE(allZero(values));
  }
}

/// Runs `body` once for each index, with `values` as its result.
std::vector<std::uint32_t> indexed(const std::string& declarations, const std::string& body) {
  constexpr std::array<std::int32_t, 24> kIndices = {
      -2147483647 - 1, -1000000, -65536, -4097, -1024, -257, -64, -33, -17, -9, -8,        -1,
      4,               5,        7,      8,     16,    63,   64,  256, 1024, 65536, 1000000, 2147483647};
  const Buffer indices = createBuffer(sizeof kIndices, kIndices.data(), "indices");
  const Buffer results = createBuffer(sizeof kIndices, nullptr, "results");
  const std::string text = "#version 430\nlayout(local_size_x = 24) in;\n"
      "layout(std430, binding = 0) buffer Indices { int indices[24]; };\n"
      "layout(std430, binding = 1) buffer Results { uint results[24]; };\n" + declarations +
      "void main() {\nint at = indices[gl_LocalInvocationIndex];\nuint value = 0u;\n" + body +
      "results[gl_LocalInvocationIndex] = value;\n}\n";
  const Program program = buildProgram({{GL_COMPUTE_SHADER, text}}, {}, "index");
  EXPECT_TRUE(program.linked) << program.stageLogs[0] << program.linkLog;
  UseProgram(program.id());
  BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, indices.id());
  BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, results.id());
  DispatchCompute(1, 1, 1);
  UseProgram(0);
  std::vector<std::uint32_t> values(kIndices.size(), 1);
  read(results, 0, sizeof kIndices, values.data());
  return values;
}

const std::string kFill = "for (int i = 0; i < 4; ++i) a[i] = 7u;\n";

TEST_F(MemoryTest, an_index_beyond_a_local_array_reads_nothing_else) {
  leaveSecrets();
  EXPECT_THAT(indexed("", "uint a[4]; " + kFill + "value = a[at];\n"),
              testing::Each(testing::AnyOf(0u, 7u)));
  // Large ones are kept elsewhere.
  EXPECT_THAT(indexed("", "uint a[4000]; for (int i = 0; i < 4000; ++i) a[i] = 7u;\n"
                          "value = at >= 0 && at < 4000 ? 7u : a[at];\n"),
              testing::Each(testing::AnyOf(0u, 7u)));
}

TEST_F(MemoryTest, an_index_beyond_a_local_array_writes_nothing_else) {
  leaveSecrets();
  EXPECT_THAT(indexed("", "uint a[4]; " + kFill + "a[at] = 9u; value = a[0] + a[3];\n"),
              testing::Each(testing::AnyOf(14u, 16u, 18u)));
}

TEST_F(MemoryTest, an_index_beyond_a_buffer_reads_nothing) {
  leaveSecrets();
  const std::vector<std::uint32_t> own(4, 7u);
  const Buffer buffer = createBuffer(own.size() * 4, own.data(), "bufferObject.2");
  BindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, buffer.id());
  EXPECT_THAT(indexed("layout(std430, binding = 2) buffer Own { uint own[]; };\n", "value = own[at];\n"),
              testing::Each(testing::AnyOf(0u, 7u)));
  EXPECT_THAT(indexed("layout(std430, binding = 2) buffer Own { uint own[4]; };\n",
                      "own[at] = 9u; memoryBarrierBuffer(); value = own[at];\n"),
              testing::Each(testing::AnyOf(0u, 7u, 9u)));
}

}  // namespace
}  // namespace orris::gl
