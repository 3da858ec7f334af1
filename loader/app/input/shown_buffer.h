// What `render --show` and the window's buffers show, as a text:
// "colortex3@composite2:alt:mip1:r:0..4:false".
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include <orris/image/value_picture.h>
#include <orris/render/inspect/buffer_view.h>

namespace orris {

struct ShownBuffer {
  BufferRequest what;
  ValuePaint how;
};

/// Words after the buffer, in any order, separated by colons: main, alt (the side; without, the one that
/// holds the result), mipN, sliceN, atN (bytes, of a bufferObject), rgb, r, g, b, a, LOW..HIGH, false
/// (false colours), signed (negative values are not marked). nullopt and why.
std::optional<ShownBuffer> parseShown(const std::string& text, std::string& problem);

/// The same as a text.
std::string shownText(const ShownBuffer& shown);

/// Place, size, extremes of each channel and numbers of odd texels; or the first words of a bufferObject.
nlohmann::json toJson(const BufferView& view, const ValuePaint& how);

/// The words of a bufferObject as CSV: byte, then the word as each kind of number.
std::string storageTable(const BufferView& view);

}  // namespace orris
