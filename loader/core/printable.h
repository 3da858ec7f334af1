// Text of a stranger as a terminal, a log or a CI runner may show it: nothing in it is obeyed.
#pragma once

#include <string>
#include <string_view>

namespace orris {

/// Every byte sequence that is not UTF-8 replaced by U+FFFD: packs are untrusted, formats are not.
std::string validUtf8(std::string_view text);

/// `text` as one line: valid UTF-8; control characters but the tab, and characters that turn the
/// direction of writing, as "\n", "\x1b" or "\u202e"; what runners of CI services read as a command
/// ("::error::" at the start, "##[group]", "##vso[...]" anywhere) with one character of it as "\x3a" or
/// "\x23".
std::string printable(std::string_view text);

/// The same for text of several lines, whose line feeds stay.
std::string printableLines(std::string_view text);

}  // namespace orris
