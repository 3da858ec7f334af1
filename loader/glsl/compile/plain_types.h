// Types as an author writes them, in the messages of glslang, which spells them out.
#pragma once

#include <string>
#include <string_view>

namespace orris {

/// "cannot convert from ' const 3-component vector of float' to ' temp float'" with 'vec3' and 'float'; what
/// is between quotes and no such type stays.
std::string withPlainTypes(std::string_view message);

}  // namespace orris
