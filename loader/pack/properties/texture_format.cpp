#include <orris/pack/properties/texture_format.h>

#include <algorithm>

#include <orris/pack/files/text.h>

namespace orris {

const std::vector<std::string>& internalFormatNames() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names{"RGBA",       "R3_G3_B2",       "RGB5_A1", "RGB10_A2",
                                   "RGB10_A2UI", "R11F_G11F_B10F", "RGB9_E5", "RGBA2",
                                   "RGBA4",      "RGB565"};
    for (const char* channels : {"R", "RG", "RGB", "RGBA"}) {
      for (const char* kind : {"8", "8_SNORM", "16", "16_SNORM", "16F", "32F", "8I", "8UI", "16I",
                               "16UI", "32I", "32UI"}) {
        names.push_back(std::string(channels) + kind);
      }
    }
    return names;
  }();
  return kNames;
}

const std::vector<std::string>& pixelFormatNames() {
  static const std::vector<std::string> kNames{
      "RED",         "RG",         "RGB",         "BGR",         "RGBA",         "BGRA",
      "RED_INTEGER", "RG_INTEGER", "RGB_INTEGER", "BGR_INTEGER", "RGBA_INTEGER", "BGRA_INTEGER"};
  return kNames;
}

const std::vector<std::string>& pixelTypeNames() {
  static const std::vector<std::string> kNames{"BYTE",
                                               "SHORT",
                                               "INT",
                                               "HALF_FLOAT",
                                               "FLOAT",
                                               "UNSIGNED_BYTE",
                                               "UNSIGNED_BYTE_3_3_2",
                                               "UNSIGNED_BYTE_2_3_3_REV",
                                               "UNSIGNED_SHORT",
                                               "UNSIGNED_SHORT_5_6_5",
                                               "UNSIGNED_SHORT_5_6_5_REV",
                                               "UNSIGNED_SHORT_4_4_4_4",
                                               "UNSIGNED_SHORT_4_4_4_4_REV",
                                               "UNSIGNED_SHORT_5_5_5_1",
                                               "UNSIGNED_SHORT_1_5_5_5_REV",
                                               "UNSIGNED_INT",
                                               "UNSIGNED_INT_8_8_8_8",
                                               "UNSIGNED_INT_8_8_8_8_REV",
                                               "UNSIGNED_INT_10_10_10_2",
                                               "UNSIGNED_INT_2_10_10_10_REV",
                                               "UNSIGNED_INT_10F_11F_11F_REV",
                                               "UNSIGNED_INT_5_9_9_9_REV"};
  return kNames;
}

const std::vector<std::string>& textureTypeNames() {
  static const std::vector<std::string> kNames{"TEXTURE_1D", "TEXTURE_2D", "TEXTURE_3D",
                                               "TEXTURE_RECTANGLE"};
  return kNames;
}

std::string knownName(std::string_view name, const std::vector<std::string>& names) {
  std::string upper = upperCase(name);
  return std::find(names.begin(), names.end(), upper) == names.end() ? "" : upper;
}

int rawTexelBytes(std::string_view pixelFormat, std::string_view pixelType) {
  const std::string_view channels = pixelFormat.substr(0, pixelFormat.find('_'));
  const int components = channels == "RED" ? 1 : static_cast<int>(channels.size());
  if (pixelType.ends_with("BYTE") || pixelType.starts_with("UNSIGNED_BYTE")) return components;
  const bool isShort =
      pixelType == "HALF_FLOAT" || pixelType.find("SHORT") != std::string_view::npos;
  return components * (isShort ? 2 : 4);
}

}  // namespace orris
