// Names of texture formats as packs write them; what they mean to GL is image/texel_format.h's business.
// Contract: formats.csv.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace orris {

/// All names, upper case.
const std::vector<std::string>& internalFormatNames();
const std::vector<std::string>& pixelFormatNames();
const std::vector<std::string>& pixelTypeNames();
const std::vector<std::string>& textureTypeNames();

/// The name in upper case, "" when `names` lacks it. Case does not matter.
std::string knownName(std::string_view name, const std::vector<std::string>& names);

/// Bytes of one texel as the raw file is checked: components times bytes of the pixel type.
int rawTexelBytes(std::string_view pixelFormat, std::string_view pixelType);

}  // namespace orris
