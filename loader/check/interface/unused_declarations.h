// Names that a text declares and does not use: where a slip in a declaration shows.
#pragma once

#include <map>
#include <string_view>

#include <orris/check/interface/stage_interface.h>

namespace orris {

/// Names, local ones too, that stand once in a final text: in their declarations. The views point into
/// `text`.
std::map<std::string_view, TextPlace> readUnusedDeclarations(std::string_view text);

}  // namespace orris
