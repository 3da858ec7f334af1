// What of a stage can decide whether it compiles: its tokens, of most numbers only their kind. Two
// texts of one shape compile alike, or fail alike.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include <orris/glsl/rewrite/rewrite.h>
#include <orris/glsl/tokens/token.h>

namespace orris {

/// Kind of a plain number: 'f' ("0.5"), 'F' ("0.5f"), 'i' ("12"), 'u' ("12u"), 'z' and 'Z' for the
/// integers 0 and 0u, which must not divide. nullopt for other numbers and for what is none.
std::optional<char> numberKind(std::string_view text);

/// Hash of the shape of a preprocessed stage. A number counts with its value where a constant
/// expression may need it: in a declaration with `const`, in brackets, in `layout` and `case`, before
/// a `?`, in arguments of functions that want constants, and where it runs together with its
/// neighbour. Everywhere else only its kind counts.
std::uint64_t shapeOf(const TokenStream& stream, Stage stage);

}  // namespace orris
