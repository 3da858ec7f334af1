// Files inside of a page, so that it needs nothing beside it, and a stranger's text in it.
#pragma once

#include <string>
#include <string_view>

namespace orris {

/// "data:image/png;base64,..."; "" for no bytes.
std::string dataUri(std::string_view type, std::string_view bytes);

/// `text` as the content of an element or the value of a quoted attribute: printableLines(), without
/// markup.
std::string htmlText(std::string_view text);

}  // namespace orris
