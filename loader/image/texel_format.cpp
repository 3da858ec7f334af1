#include <orris/image/texel_format.h>

#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <cctype>

namespace orris {
namespace {

constexpr TextureFormat kFormats[] = {
    {"RGBA", GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 4, 4, FormatClass::Unorm, true, true},
    {"R8", GL_R8, GL_RED, GL_UNSIGNED_BYTE, 1, 1, FormatClass::Unorm, true, true},
    {"RG8", GL_RG8, GL_RG, GL_UNSIGNED_BYTE, 2, 2, FormatClass::Unorm, true, true},
    {"RGB8", GL_RGB8, GL_RGB, GL_UNSIGNED_BYTE, 3, 3, FormatClass::Unorm, true, false},
    {"RGBA8", GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 4, 4, FormatClass::Unorm, true, true},
    {"R8_SNORM", GL_R8_SNORM, GL_RED, GL_BYTE, 1, 1, FormatClass::Snorm, true, true},
    {"RG8_SNORM", GL_RG8_SNORM, GL_RG, GL_BYTE, 2, 2, FormatClass::Snorm, true, true},
    {"RGB8_SNORM", GL_RGB8_SNORM, GL_RGB, GL_BYTE, 3, 3, FormatClass::Snorm, true, false},
    {"RGBA8_SNORM", GL_RGBA8_SNORM, GL_RGBA, GL_BYTE, 4, 4, FormatClass::Snorm, true, true},
    {"R16", GL_R16, GL_RED, GL_UNSIGNED_SHORT, 1, 2, FormatClass::Unorm, true, true},
    {"RG16", GL_RG16, GL_RG, GL_UNSIGNED_SHORT, 2, 4, FormatClass::Unorm, true, true},
    {"RGB16", GL_RGB16, GL_RGB, GL_UNSIGNED_SHORT, 3, 6, FormatClass::Unorm, true, false},
    {"RGBA16", GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT, 4, 8, FormatClass::Unorm, true, true},
    {"R16_SNORM", GL_R16_SNORM, GL_RED, GL_SHORT, 1, 2, FormatClass::Snorm, true, true},
    {"RG16_SNORM", GL_RG16_SNORM, GL_RG, GL_SHORT, 2, 4, FormatClass::Snorm, true, true},
    {"RGB16_SNORM", GL_RGB16_SNORM, GL_RGB, GL_SHORT, 3, 6, FormatClass::Snorm, true, false},
    {"RGBA16_SNORM", GL_RGBA16_SNORM, GL_RGBA, GL_SHORT, 4, 8, FormatClass::Snorm, true, true},
    {"R16F", GL_R16F, GL_RED, GL_HALF_FLOAT, 1, 2, FormatClass::Float, true, true},
    {"RG16F", GL_RG16F, GL_RG, GL_HALF_FLOAT, 2, 4, FormatClass::Float, true, true},
    {"RGB16F", GL_RGB16F, GL_RGB, GL_HALF_FLOAT, 3, 6, FormatClass::Float, true, false},
    {"RGBA16F", GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT, 4, 8, FormatClass::Float, true, true},
    {"R32F", GL_R32F, GL_RED, GL_FLOAT, 1, 4, FormatClass::Float, true, true},
    {"RG32F", GL_RG32F, GL_RG, GL_FLOAT, 2, 8, FormatClass::Float, true, true},
    {"RGB32F", GL_RGB32F, GL_RGB, GL_FLOAT, 3, 12, FormatClass::Float, true, false},
    {"RGBA32F", GL_RGBA32F, GL_RGBA, GL_FLOAT, 4, 16, FormatClass::Float, true, true},
    {"R8I", GL_R8I, GL_RED_INTEGER, GL_BYTE, 1, 1, FormatClass::Int, true, true},
    {"RG8I", GL_RG8I, GL_RG_INTEGER, GL_BYTE, 2, 2, FormatClass::Int, true, true},
    {"RGB8I", GL_RGB8I, GL_RGB_INTEGER, GL_BYTE, 3, 3, FormatClass::Int, true, false},
    {"RGBA8I", GL_RGBA8I, GL_RGBA_INTEGER, GL_BYTE, 4, 4, FormatClass::Int, true, true},
    {"R8UI", GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, 1, 1, FormatClass::Uint, true, true},
    {"RG8UI", GL_RG8UI, GL_RG_INTEGER, GL_UNSIGNED_BYTE, 2, 2, FormatClass::Uint, true, true},
    {"RGB8UI", GL_RGB8UI, GL_RGB_INTEGER, GL_UNSIGNED_BYTE, 3, 3, FormatClass::Uint, true, false},
    {"RGBA8UI", GL_RGBA8UI, GL_RGBA_INTEGER, GL_UNSIGNED_BYTE, 4, 4, FormatClass::Uint, true, true},
    {"R16I", GL_R16I, GL_RED_INTEGER, GL_SHORT, 1, 2, FormatClass::Int, true, true},
    {"RG16I", GL_RG16I, GL_RG_INTEGER, GL_SHORT, 2, 4, FormatClass::Int, true, true},
    {"RGB16I", GL_RGB16I, GL_RGB_INTEGER, GL_SHORT, 3, 6, FormatClass::Int, true, false},
    {"RGBA16I", GL_RGBA16I, GL_RGBA_INTEGER, GL_SHORT, 4, 8, FormatClass::Int, true, true},
    {"R16UI", GL_R16UI, GL_RED_INTEGER, GL_UNSIGNED_SHORT, 1, 2, FormatClass::Uint, true, true},
    {"RG16UI", GL_RG16UI, GL_RG_INTEGER, GL_UNSIGNED_SHORT, 2, 4, FormatClass::Uint, true, true},
    {"RGB16UI", GL_RGB16UI, GL_RGB_INTEGER, GL_UNSIGNED_SHORT, 3, 6, FormatClass::Uint, true,
     false},
    {"RGBA16UI", GL_RGBA16UI, GL_RGBA_INTEGER, GL_UNSIGNED_SHORT, 4, 8, FormatClass::Uint, true,
     true},
    {"R32I", GL_R32I, GL_RED_INTEGER, GL_INT, 1, 4, FormatClass::Int, true, true},
    {"RG32I", GL_RG32I, GL_RG_INTEGER, GL_INT, 2, 8, FormatClass::Int, true, true},
    {"RGB32I", GL_RGB32I, GL_RGB_INTEGER, GL_INT, 3, 12, FormatClass::Int, true, false},
    {"RGBA32I", GL_RGBA32I, GL_RGBA_INTEGER, GL_INT, 4, 16, FormatClass::Int, true, true},
    {"R32UI", GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, 1, 4, FormatClass::Uint, true, true},
    {"RG32UI", GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT, 2, 8, FormatClass::Uint, true, true},
    {"RGB32UI", GL_RGB32UI, GL_RGB_INTEGER, GL_UNSIGNED_INT, 3, 12, FormatClass::Uint, true, false},
    {"RGBA32UI", GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT, 4, 16, FormatClass::Uint, true,
     true},
    {"R3_G3_B2", GL_R3_G3_B2, GL_RGB, GL_UNSIGNED_BYTE_2_3_3_REV, 3, 1, FormatClass::Unorm, true,
     false},
    {"RGB5_A1", GL_RGB5_A1, GL_RGBA, GL_UNSIGNED_SHORT_1_5_5_5_REV, 4, 2, FormatClass::Unorm, true,
     false},
    {"RGB10_A2", GL_RGB10_A2, GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV, 4, 4, FormatClass::Unorm,
     true, true},
    {"R11F_G11F_B10F", GL_R11F_G11F_B10F, GL_RGB, GL_UNSIGNED_INT_10F_11F_11F_REV, 3, 4,
     FormatClass::Float, true, true},
    {"RGB9_E5", GL_RGB9_E5, GL_RGB, GL_UNSIGNED_INT_5_9_9_9_REV, 3, 4, FormatClass::Float, false,
     false},
    {"RGBA2", GL_RGBA2, GL_RGBA, GL_UNSIGNED_BYTE, 4, 4, FormatClass::Unorm, true, false},
    {"RGBA4", GL_RGBA4, GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4_REV, 4, 2, FormatClass::Unorm, true,
     false},
    {"RGB565", GL_RGB565, GL_RGB, GL_UNSIGNED_SHORT_5_6_5_REV, 3, 2, FormatClass::Unorm, true,
     false},
    {"RGB10_A2UI", GL_RGB10_A2UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT_2_10_10_10_REV, 4, 4,
     FormatClass::Uint, true, true},
};

struct PixelFormat {
  std::string_view name;
  unsigned value;
  int components;
};
constexpr PixelFormat kPixelFormats[] = {
    {"RED", GL_RED, 1},   {"RED_INTEGER", GL_RED_INTEGER, 1},
    {"RG", GL_RG, 2},     {"RG_INTEGER", GL_RG_INTEGER, 2},
    {"RGB", GL_RGB, 3},   {"RGB_INTEGER", GL_RGB_INTEGER, 3},
    {"BGR", GL_BGR, 3},   {"BGR_INTEGER", GL_BGR_INTEGER, 3},
    {"RGBA", GL_RGBA, 4}, {"RGBA_INTEGER", GL_RGBA_INTEGER, 4},
    {"BGRA", GL_BGRA, 4}, {"BGRA_INTEGER", GL_BGRA_INTEGER, 4},
};

struct PixelType {
  std::string_view name;
  unsigned value;
  int bytes;  // packed types: of the whole pixel
};
constexpr PixelType kPixelTypes[] = {
    {"BYTE", GL_BYTE, 1},
    {"SHORT", GL_SHORT, 2},
    {"INT", GL_INT, 4},
    {"HALF_FLOAT", GL_HALF_FLOAT, 2},
    {"FLOAT", GL_FLOAT, 4},
    {"UNSIGNED_BYTE", GL_UNSIGNED_BYTE, 1},
    {"UNSIGNED_BYTE_3_3_2", GL_UNSIGNED_BYTE_3_3_2, 1},
    {"UNSIGNED_BYTE_2_3_3_REV", GL_UNSIGNED_BYTE_2_3_3_REV, 1},
    {"UNSIGNED_SHORT", GL_UNSIGNED_SHORT, 2},
    {"UNSIGNED_SHORT_5_6_5", GL_UNSIGNED_SHORT_5_6_5, 2},
    {"UNSIGNED_SHORT_5_6_5_REV", GL_UNSIGNED_SHORT_5_6_5_REV, 2},
    {"UNSIGNED_SHORT_4_4_4_4", GL_UNSIGNED_SHORT_4_4_4_4, 2},
    {"UNSIGNED_SHORT_4_4_4_4_REV", GL_UNSIGNED_SHORT_4_4_4_4_REV, 2},
    {"UNSIGNED_SHORT_5_5_5_1", GL_UNSIGNED_SHORT_5_5_5_1, 2},
    {"UNSIGNED_SHORT_1_5_5_5_REV", GL_UNSIGNED_SHORT_1_5_5_5_REV, 2},
    {"UNSIGNED_INT", GL_UNSIGNED_INT, 4},
    {"UNSIGNED_INT_8_8_8_8", GL_UNSIGNED_INT_8_8_8_8, 4},
    {"UNSIGNED_INT_8_8_8_8_REV", GL_UNSIGNED_INT_8_8_8_8_REV, 4},
    {"UNSIGNED_INT_10_10_10_2", GL_UNSIGNED_INT_10_10_10_2, 4},
    {"UNSIGNED_INT_2_10_10_10_REV", GL_UNSIGNED_INT_2_10_10_10_REV, 4},
    {"UNSIGNED_INT_10F_11F_11F_REV", GL_UNSIGNED_INT_10F_11F_11F_REV, 4},
    {"UNSIGNED_INT_5_9_9_9_REV", GL_UNSIGNED_INT_5_9_9_9_REV, 4},
};

bool equalIgnoringCase(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
    return std::toupper(x) == std::toupper(y);
  });
}

template <typename Table>
auto findByName(const Table& table, std::string_view name) {
  return std::find_if(std::begin(table), std::end(table),
                      [name](const auto& row) { return equalIgnoringCase(row.name, name); });
}

}  // namespace

std::span<const TextureFormat> textureFormats() { return kFormats; }

const TextureFormat* findFormat(std::string_view name) {
  const auto found = findByName(kFormats, name);
  return found == std::end(kFormats) ? nullptr : found;
}

const TextureFormat* findFormat(unsigned internalFormat) {
  for (const TextureFormat& format : kFormats) {
    if (format.internalFormat == internalFormat) return &format;
  }
  return nullptr;
}

std::optional<unsigned> findPixelFormat(std::string_view name) {
  const auto found = findByName(kPixelFormats, name);
  if (found == std::end(kPixelFormats)) return std::nullopt;
  return found->value;
}

std::optional<std::pair<unsigned, int>> findPixelType(std::string_view name) {
  const auto found = findByName(kPixelTypes, name);
  if (found == std::end(kPixelTypes)) return std::nullopt;
  return std::pair(found->value, found->bytes);
}

int componentsOf(unsigned pixelFormat) {
  for (const PixelFormat& format : kPixelFormats) {
    if (format.value == pixelFormat) return format.components;
  }
  return 0;
}

}  // namespace orris
