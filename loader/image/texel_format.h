// Texture formats by the names packs use. Contract: formats.csv.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace orris {

enum class FormatClass { Unorm, Snorm, Float, Int, Uint };

struct TextureFormat {
  std::string_view name;    ///< "R11F_G11F_B10F"
  unsigned internalFormat;  ///< GL enum
  unsigned pixelFormat;     ///< natural transfer format
  unsigned pixelType;       ///< natural transfer type
  int channels;
  int bytesPerPixel;
  FormatClass formatClass;
  bool renderable;
  bool imageLoadStore;
  bool isInteger() const {
    return formatClass == FormatClass::Int || formatClass == FormatClass::Uint;
  }
};

/// Every internal format a pack may name, in the contract's order.
std::span<const TextureFormat> textureFormats();
/// Case-insensitive; nullptr when the name is unknown.
const TextureFormat* findFormat(std::string_view name);
/// nullptr for formats no pack can name, such as depth.
const TextureFormat* findFormat(unsigned internalFormat);
/// GL enum; case-insensitive like findPixelType.
std::optional<unsigned> findPixelFormat(std::string_view name);
/// GL enum and bytes of one component; of packed types the bytes of the whole pixel, which a raw
/// file must hold once per component all the same.
std::optional<std::pair<unsigned, int>> findPixelType(std::string_view name);
/// 0 when unknown.
int componentsOf(unsigned pixelFormat);

}  // namespace orris
