// What an editor asks about a place in a file of a pack: hover, definition, completion, symbols.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "app/lsp/edited_pack.h"
#include "app/lsp/text_place.h"

namespace orris {

enum class PackFileKind { Shader, Properties, Ids, Language, Other };
PackFileKind kindOfFile(std::string_view packPath);

struct EditorPlace {
  EditedPack& pack;
  std::string file;  ///< pack path
  std::string line;  ///< the whole line
  TextPlace place;
  bool utf8 = false;  ///< the editor counts bytes

  std::size_t units(std::size_t bytes) const { return unitsOf(line, bytes, utf8); }
};

/// null where there is nothing to say.
nlohmann::json hoverAt(const EditorPlace& at);
/// A list of locations.
nlohmann::json definitionsAt(const EditorPlace& at);
/// A list of completion items.
nlohmann::json completionsAt(const EditorPlace& at);
/// The outline of a file.
nlohmann::json symbolsOf(EditedPack& pack, const std::string& file, bool utf8);

/// The target of an #include line, "" for other lines.
std::string includeTarget(const std::string& file, std::string_view line);
/// The option that a key of a language file is about: "option.FOG.comment" -> "FOG"; else "".
std::string optionOfKey(std::string_view key);

}  // namespace orris
