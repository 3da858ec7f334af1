// Where names are defined, and what a file holds.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/lsp/features.h"
#include <orris/core/files/pack_path.h>
#include <orris/glsl/tokens/outline.h>
#include <orris/glsl/tokens/token.h>
#include <orris/core/characters.h>
#include <orris/pack/files/text.h>
#include <orris/pack/options/option_line.h>

namespace orris {
namespace {

using nlohmann::json;

/// Numbers of the protocol.
enum SymbolKind { kNamespace = 3, kStruct = 23, kFunction = 12, kVariable = 13, kConstant = 14, kKey = 20 };

std::string lineInPack(EditedPack& pack, const std::string& file, int line) {
  const std::vector<std::string> lines = splitLines(pack.text(file));
  return line >= 1 && line <= int(lines.size()) ? lines[std::size_t(line - 1)] : "";
}

json locationJson(const EditorPlace& at, const std::string& file, int line, int column, std::size_t length) {
  const std::string text = lineInPack(at.pack, file, line);
  const auto begin = std::size_t(std::max(column - 1, 0));
  return {{"uri", uriOfPath(at.pack.filePath(file))},
          {"range", rangeJson(std::max(line - 1, 0), unitsOf(text, begin, at.utf8),
                              unitsOf(text, begin + length, at.utf8))}};
}

json symbolJson(const std::string& name, SymbolKind kind, int line, std::size_t begin, std::size_t end,
                const std::string& text, bool utf8) {
  const json range = rangeJson(line, unitsOf(text, begin, utf8), unitsOf(text, end, utf8));
  return {{"name", name}, {"kind", int(kind)}, {"range", range}, {"selectionRange", range}};
}

/// #define lines, and what stands at file scope; directives are blanked, for the outline knows none.
json shaderSymbols(const std::vector<std::string>& lines, bool utf8) {
  json symbols = json::array();
  std::string code;
  bool continued = false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& line = lines[i];
    const bool directive = continued || trim(line).starts_with('#');
    continued = directive && line.ends_with('\\');
    code += directive ? "\n" : line + "\n";
    const std::string_view name = trim(line).starts_with('#') ? definedName(line) : std::string_view();
    if (!name.empty()) {
      const std::size_t at = line.find(name);
      symbols.push_back(symbolJson(std::string(name), kConstant, int(i), at, at + name.size(), line, utf8));
    }
  }
  const std::vector<Token> tokens = tokenize(code);
  const auto add = [&](std::size_t token, SymbolKind kind) {
    const Token& name = tokens[token];
    const int line = name.origin.line - 1;
    if (line < 0 || line >= int(lines.size()) || name.kind != TokenKind::Identifier) return;
    const auto begin = std::size_t(std::max(name.origin.column - 1, 0));
    symbols.push_back(symbolJson(name.text, kind, line, begin, begin + name.text.size(),
                                 lines[std::size_t(line)], utf8));
  };
  for (const OutlineItem& item : outline(tokens)) {
    if (item.kind == OutlineItem::Kind::Function) add(item.name, kFunction);
    if (item.kind != OutlineItem::Kind::Declaration) continue;
    const Declaration declaration = parseDeclaration(tokens, item);
    if (declaration.isBlock || !declaration.members.empty()) add(declaration.type, kStruct);
    for (const Declarator& one : declaration.declarators) add(one.name, kVariable);
  }
  return symbols;
}

json keySymbols(const std::vector<std::string>& lines, bool utf8) {
  json symbols = json::array();
  bool continued = false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& line = lines[i];
    const bool begins = !continued;
    continued = line.ends_with('\\');
    const std::string_view text = trim(line);
    const std::size_t end = line.find('=');
    if (!begins || text.empty() || text.front() == '#' || text.front() == '!' || end == std::string::npos)
      continue;
    const std::string key(trim(std::string_view(line).substr(0, end)));
    if (!key.empty()) symbols.push_back(symbolJson(key, kKey, int(i), line.find(key), end, line, utf8));
  }
  return symbols;
}

/// Options that a word of properties or languages names.
std::string optionNamed(const EditorPlace& at, PackFileKind kind) {
  const LineWord word = wordAround(at.line, at.place.at);
  if (kind != PackFileKind::Language) return word.text;
  return optionOfKey(trim(std::string_view(at.line).substr(0, at.line.find('='))));
}

/// A file that a property names: "texture.composite.colortex1 = textures/a.png".
json fileNamed(const EditorPlace& at) {
  const std::string path = wordAround(at.line, at.place.at, "/.-").text;
  const auto target = resolvePackPath("/shaders.properties", path);
  if (!target || at.pack.knowledge().pack.source == nullptr ||
      !at.pack.knowledge().pack.source->contains(*target))
    return json::array();
  return json::array({locationJson(at, *target, 1, 1, 0)});
}

}  // namespace

PackFileKind kindOfFile(std::string_view packPath) {
  if (packPath == "/shaders.properties") return PackFileKind::Properties;
  if (packPath.ends_with(".lang")) return PackFileKind::Language;
  if (packPath.ends_with(".properties")) return PackFileKind::Ids;
  const std::string_view name = packPath.substr(packPath.rfind('/') + 1);
  const bool other = name.ends_with(".png") || name.ends_with(".mcmeta") || name.ends_with(".json") ||
                     name.ends_with(".txt") || name.ends_with(".md");
  return other ? PackFileKind::Other : PackFileKind::Shader;
}

std::string includeTarget(const std::string& file, std::string_view line) {
  line = trim(line);
  if (!line.starts_with('#')) return "";
  line = trim(line.substr(1));
  if (leadingWord(line) != "include") return "";
  const std::size_t begin = line.find('"');
  const std::size_t end = begin == std::string_view::npos ? begin : line.find('"', begin + 1);
  if (end == std::string_view::npos) return "";
  return resolvePackPath(file, line.substr(begin + 1, end - begin - 1)).value_or("");
}

std::string optionOfKey(std::string_view key) {
  for (const std::string_view prefix : {"option.", "value.", "prefix.", "suffix."})
    if (key.starts_with(prefix)) return std::string(leadingWord(key.substr(prefix.size())));
  return "";
}

json definitionsAt(const EditorPlace& at) {
  const PackFileKind kind = kindOfFile(at.file);
  PackKnowledge& known = at.pack.knowledge();
  if (kind == PackFileKind::Shader)
    if (const std::string target = includeTarget(at.file, at.line); !target.empty())
      return json::array({locationJson(at, target, 1, 1, 0)});
  json found = json::array();
  const std::string name = optionNamed(at, kind);
  if (name.empty()) return found;
  if (const Option* option = known.pack.options.find(name)) {
    for (const SourceLocation& place : option->at) {
      const std::string line = lineInPack(at.pack, place.file, place.line);
      const std::size_t column = line.find(name);
      found.push_back(locationJson(at, place.file, place.line,
                                   column == std::string::npos ? 1 : int(column) + 1, name.size()));
    }
    return found;
  }
  if (kind == PackFileKind::Properties)
    if (json file = fileNamed(at); !file.empty()) return file;
  if (kind == PackFileKind::Ids || kind == PackFileKind::Language) return found;
  for (const SourceLocation& place : known.index.definitionsOf(name))
    found.push_back(locationJson(at, place.file, place.line, place.column, name.size()));
  return found;
}

json symbolsOf(EditedPack& pack, const std::string& file, bool utf8) {
  const std::vector<std::string> lines = splitLines(pack.text(file));
  switch (kindOfFile(file)) {
    case PackFileKind::Shader:
      return shaderSymbols(lines, utf8);
    case PackFileKind::Other:
      return json::array();
    default:
      return keySymbols(lines, utf8);
  }
}

}  // namespace orris
