// What a name means: the contract, the pack's options with the value in force, macros and functions.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "app/lsp/contract_rows.h"
#include "app/lsp/features.h"
#include <orris/check/interface/known_names.h>
#include <orris/core/characters.h>
#include <orris/pack/files/text.h>
#include <orris/plan/frame/uniforms.h>
#include <orris/world/blocks/block_data.h>

namespace orris {
namespace {

constexpr std::size_t kMostPlaces = 4;

void addPart(std::string& text, const std::string& part) {
  if (!part.empty()) text += (text.empty() ? "" : "\n\n") + part;
}

std::string stateText(const std::string& state) {
  if (state == "works") return "as in the game";
  if (state == "constant") return "accepted; a constant here";
  return state == "not" ? "not offered by this host" : state;
}

/// The words of expressions ("float", "if") mean other things in a shader.
std::string contractText(const std::string& name, bool shader) {
  std::string text;
  for (const ContractRow* row : contractRowsOf(name))
    if (!shader || row->section != "Custom uniforms")
      addPart(text, fmt::format("*{}*: `{}`, {}{}{}", row->section, row->names, stateText(row->state),
                                row->note.empty() ? "" : "; ", row->note));
  return text;
}

std::string hostNameText(const std::string& name) {
  const auto types = uniformTypes();
  if (const auto found = types.find(name); found != types.end())
    return fmt::format("```glsl\nuniform {} {};\n```", found->second, name);
  for (const NameKind kind : {NameKind::Sampler, NameKind::Image, NameKind::Attribute})
    if (findKnownName(kind, name) != nullptr) return fmt::format("`{}`: {}", name, nameKindWord(kind));
  return "";
}

std::string optionText(PackKnowledge& known, const std::string& name) {
  const ShaderPack& pack = known.pack;
  const Option* option = pack.options.find(name);
  if (option == nullptr) {
    const RejectedOption* rejected = pack.options.rejected(name);
    return rejected == nullptr || rejected->reason.empty()
               ? ""
               : fmt::format("`{}` is no option: {}", name, rejected->reason);
  }
  const std::string value = pack.options.value(pack.values, name);
  const bool chosen = pack.values.contains(name) && value != option->defaultValue;
  std::string text = fmt::format("option `{}` = `{}`{}", name, value,
                                 chosen ? fmt::format(", default `{}` (set in {})", option->defaultValue,
                                                      known.valuesFrom)
                                        : ", the default");
  addPart(text, option->comment);
  if (!option->isBoolean) addPart(text, fmt::format("values: `{}`", fmt::join(option->values, "` `")));
  for (const SourceLocation& at : option->at) addPart(text, "defined at " + formatLocation(at));
  return text;
}

/// The author's lines that define it.
std::string definitionText(EditedPack& pack, PackKnowledge& known, const std::string& name) {
  std::string text;
  std::size_t count = 0;
  const auto& places = known.index.definitionsOf(name);
  for (const SourceLocation& at : places) {
    if (count++ == kMostPlaces) {
      addPart(text, fmt::format("and {} more places", places.size() - kMostPlaces));
      break;
    }
    const std::vector<std::string> lines = splitLines(pack.text(at.file));
    if (at.line > int(lines.size())) continue;
    addPart(text, fmt::format("```glsl\n{}\n```\n{}", trim(lines[std::size_t(at.line - 1)]),
                              formatLocation(at)));
  }
  return text;
}

std::string macroText(PackKnowledge& known, const std::string& name) {
  for (const auto& [macro, value] : known.pack.propertyMacros)
    if (macro == name)
      return fmt::format("```glsl\n#define {} {}\n```\nby the host", macro, value);
  return "";
}

std::string blockText(const std::string& word) {
  std::string name = word.starts_with("minecraft:") ? word.substr(word.find(':') + 1) : word;
  const std::size_t colon = name.find(':');
  const auto found = blockData().blocks.find(name.substr(0, colon));
  if (found == blockData().blocks.end()) return "";
  std::string text = fmt::format("block `minecraft:{}`", found->first);
  std::vector<std::string> properties;
  for (const auto& [key, value] : found->second.defaults) properties.push_back(key + "=" + value);
  if (!properties.empty()) addPart(text, fmt::format("default state: `{}`", fmt::join(properties, "` `")));
  return text;
}

/// The key of a line of a properties file.
std::string propertyKeyOf(std::string_view line) {
  return std::string(trim(line.substr(0, line.find_first_of("=:"))));
}

/// "texture.composite.colortex1" is a row "texture.*": the longest beginning that has one.
std::string propertyText(const std::string& key) {
  for (std::string part = key; !part.empty();) {
    if (const std::string text = contractText(part, false); !text.empty()) return text;
    const std::size_t dot = part.find_last_of('.');
    part = dot == std::string::npos ? "" : part.substr(0, dot);
  }
  return "";
}

std::string textAt(const EditorPlace& at, const LineWord& word) {
  PackKnowledge& known = at.pack.knowledge();
  const PackFileKind kind = kindOfFile(at.file);
  std::string text = optionText(known, word.text);
  if (kind == PackFileKind::Ids) addPart(text, blockText(wordAround(at.line, at.place.at, ":.").text));
  const std::size_t equals = at.line.find('=');
  if (kind == PackFileKind::Properties && at.place.at <= equals) addPart(text, propertyText(propertyKeyOf(at.line)));
  if (kind == PackFileKind::Language && text.empty()) text = optionText(known, optionOfKey(propertyKeyOf(at.line)));
  if (kind != PackFileKind::Shader && kind != PackFileKind::Properties) return text;
  addPart(text, hostNameText(word.text));
  addPart(text, contractText(word.text, kind == PackFileKind::Shader));
  addPart(text, macroText(known, word.text));
  if (known.pack.options.find(word.text) == nullptr) addPart(text, definitionText(at.pack, known, word.text));
  return text;
}

}  // namespace

nlohmann::json hoverAt(const EditorPlace& at) {
  const LineWord word = wordAround(at.line, at.place.at);
  if (word.text.empty()) return nullptr;
  const std::string text = textAt(at, word);
  if (text.empty()) return nullptr;
  return {{"contents", {{"kind", "markdown"}, {"value", text}}},
          {"range", rangeJson(at.place.line, at.units(word.begin), at.units(word.end))}};
}

}  // namespace orris
