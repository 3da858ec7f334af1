// Texture formats by the names packs use. Contract: formats.csv.
#pragma once

#include <optional>
#include <string_view>
#include <utility>

namespace orris::gl {

enum class FormatClass { Unorm, Snorm, Float, Int, Uint };

struct TextureFormat {
  std::string_view name;      ///< "R11F_G11F_B10F"
  unsigned internalFormat;    ///< GL enum
  unsigned pixelFormat;       ///< natural transfer format
  unsigned pixelType;         ///< natural transfer type
  int channels;
  int bytesPerPixel;
  FormatClass formatClass;
  bool renderable;
  bool imageLoadStore;
  bool isInteger() const { return formatClass == FormatClass::Int || formatClass == FormatClass::Uint; }
};

/// Case-insensitive; nullptr when the name is unknown.
const TextureFormat* findFormat(std::string_view name);
std::optional<unsigned> findPixelFormat(std::string_view name);
/// GL enum and bytes of one component.
std::optional<std::pair<unsigned, int>> findPixelType(std::string_view name);
int componentsOf(unsigned pixelFormat);

}  // namespace orris::gl
