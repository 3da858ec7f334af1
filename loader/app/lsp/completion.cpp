// What can stand at a place: names of the host and of the pack, directives, keys, files, blocks.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "app/lsp/features.h"
#include <orris/check/hints/glsl_functions.h>
#include <orris/check/interface/known_names.h>
#include <orris/core/characters.h>
#include <orris/pack/files/text.h>
#include <orris/pack/programs/directives.h>
#include <orris/pack/programs/program_id.h>
#include <orris/pack/properties/property_keys.h>
#include <orris/plan/frame/uniforms.h>
#include <orris/world/blocks/block_data.h>

namespace orris {
namespace {

using nlohmann::json;

/// Numbers of the protocol.
enum ItemKind { kFunctionItem = 3, kVariableItem = 6, kPropertyItem = 10, kValueItem = 12, kKeywordItem = 14, kFileItem = 17, kConstantItem = 21 };

// An editor asks again while one types.
constexpr std::size_t kMostItems = 2000;

/// Items of one answer; what is typed already decides which, and is replaced.
class Items {
 public:
  Items(const EditorPlace& at, std::size_t begin)
      : at_(at), begin_(begin), typed_(lowerCase(std::string_view(at.line).substr(begin, at.place.at - begin))) {}

  void add(const std::string& label, ItemKind kind, const std::string& detail) {
    if (lowerCase(label).find(typed_) == std::string::npos || list_.size() == kMostItems) return;
    if (!seen_.insert(label).second) return;
    list_.push_back({{"label", label},
                     {"kind", int(kind)},
                     {"detail", detail},
                     {"textEdit",
                      {{"range", rangeJson(at_.place.line, at_.units(begin_), at_.units(at_.place.at))},
                       {"newText", label}}}});
  }
  json take() { return std::move(list_); }

 private:
  const EditorPlace& at_;
  std::size_t begin_;
  std::string typed_;
  std::set<std::string> seen_;
  json list_ = json::array();
};

/// Where the word before the place begins.
std::size_t wordBegin(const EditorPlace& at, std::string_view more) {
  return wordAround(std::string_view(at.line).substr(0, at.place.at), at.place.at, more).begin;
}

json includeItems(const EditorPlace& at, std::size_t quote) {
  Items items(at, quote + 1);
  const auto& source = at.pack.roughKnowledge().pack.source;
  for (const std::string& path : source ? source->files() : std::vector<std::string>())
    if (kindOfFile(path) == PackFileKind::Shader && !parseProgramFile(path)) items.add(path, kFileItem, "");
  return items.take();
}

void addOptionNames(Items& items, const ShaderPack& pack) {
  for (const auto& [name, option] : pack.options.all())
    items.add(name, kConstantItem, fmt::format("option, {}", pack.options.value(pack.values, name)));
}

void addProgramNames(Items& items, const std::string& prefix) {
  for (const GeometryProgram& program : geometryPrograms())
    items.add(prefix + std::string(program.name), kPropertyItem, "program");
  for (const char* name : {"setup", "begin", "shadowcomp", "prepare", "deferred", "composite", "final"})
    items.add(prefix + name, kPropertyItem, "program");
}

json directiveItems(const EditorPlace& at, std::size_t begin) {
  Items items(at, begin);
  for (const char* word : {"include", "define", "undef", "if", "ifdef", "ifndef", "elif", "else", "endif",
                           "version", "extension", "error", "pragma"})
    items.add(word, kKeywordItem, "directive");
  return items.take();
}

/// What follows "const <type>".
void addConstNames(Items& items) {
  for (const std::string_view name : packDirectiveNames()) items.add(std::string(name), kPropertyItem, "directive");
  for (int i = 0; i < kColorTargets; ++i)
    for (const char* suffix : {"Format", "Clear", "ClearColor", "MipmapEnabled"})
      items.add(fmt::format("colortex{}{}", i, suffix), kPropertyItem, "directive");
}

void addHostNames(Items& items) {
  for (const auto& [name, type] : uniformTypes()) items.add(name, kVariableItem, "uniform " + type);
  for (const NameKind kind : {NameKind::Sampler, NameKind::Image, NameKind::Attribute})
    for (const std::string& name : knownNames(kind)) items.add(name, kVariableItem, nameKindWord(kind));
}

/// Names at file scope of the file and of what it includes.
void addPackNames(Items& items, const EditorPlace& at) {
  std::set<std::string> seen{at.file};
  std::vector<std::string> open{at.file};
  while (!open.empty()) {
    const std::string file = open.back();
    open.pop_back();
    for (const json& symbol : symbolsOf(at.pack, file, at.utf8))
      items.add(symbol.at("name").get<std::string>(), symbol.at("kind") == 12 ? kFunctionItem : kConstantItem, file);
    for (const std::string& line : splitLines(at.pack.text(file)))
      if (const std::string target = includeTarget(file, line); !target.empty() && seen.insert(target).second)
        open.push_back(target);
  }
}

json shaderItems(const EditorPlace& at) {
  const std::string_view before = std::string_view(at.line).substr(0, at.place.at);
  const std::string_view text = trim(before);
  if (text.starts_with('#')) {
    const std::size_t quote = before.find('"');
    if (text.find("include") != std::string_view::npos && quote != std::string_view::npos)
      return includeItems(at, quote);
    if (text.substr(1).find(' ') == std::string_view::npos)
      return directiveItems(at, before.find('#') + 1);
  }
  Items items(at, wordBegin(at, ""));
  if (before.find("/*") != std::string_view::npos)
    for (const char* word : {"RENDERTARGETS: ", "DRAWBUFFERS:"}) items.add(word, kKeywordItem, "directive");
  if (text.starts_with("const ")) addConstNames(items);
  addHostNames(items);
  addOptionNames(items, at.pack.roughKnowledge().pack);
  addPackNames(items, at);
  for (const std::string& name : builtInFunctions()) items.add(name, kFunctionItem, "GLSL");
  return items.take();
}

json keyItems(const EditorPlace& at) {
  Items items(at, wordBegin(at, ".-"));
  for (const std::string_view key : settingKeys()) items.add(std::string(key), kPropertyItem, "setting");
  for (const std::string_view prefix : propertyPrefixes()) items.add(std::string(prefix), kPropertyItem, "");
  const std::string_view typed = std::string_view(at.line).substr(0, at.place.at);
  for (const char* prefix : {"blend.", "alphaTest.", "scale.", "size.buffer.", "program."})
    if (trim(typed).starts_with(prefix)) addProgramNames(items, prefix);
  return items.take();
}

json valueItems(const EditorPlace& at) {
  const ShaderPack& pack = at.pack.roughKnowledge().pack;
  const std::string_view key = trim(std::string_view(at.line).substr(0, at.line.find('=')));
  Items items(at, wordBegin(at, "<[*!"));
  const bool screens = key == "screen" || key.starts_with("screen.");
  if (screens)
    for (const char* word : {"<profile>", "<empty>", "*"}) items.add(word, kValueItem, "");
  if (screens)
    for (const Screen& screen : pack.properties.screens)
      if (!screen.name.empty()) items.add("[" + screen.name + "]", kValueItem, "screen");
  if (screens || key == "sliders" || key.starts_with("profile.") || key.starts_with("program."))
    addOptionNames(items, pack);
  for (const char* word : {"true", "false", "off", "on"}) items.add(word, kValueItem, "");
  return items.take();
}

json blockItems(const EditorPlace& at) {
  const std::size_t begin = wordBegin(at, ":");
  Items items(at, begin);
  if (at.line.find('=') >= at.place.at) {
    for (const char* prefix : {"block.", "layer.solid", "layer.cutout", "layer.translucent"})
      items.add(prefix, kPropertyItem, "");
    return items.take();
  }
  const bool named = std::string_view(at.line).substr(begin).starts_with("minecraft:");
  for (const auto& [name, block] : blockData().blocks)
    items.add(named ? "minecraft:" + name : name, kValueItem, "block");
  return items.take();
}

json languageItems(const EditorPlace& at) {
  const ShaderPack& pack = at.pack.roughKnowledge().pack;
  Items items(at, wordBegin(at, ".<>"));
  if (at.line.find('=') < at.place.at) return items.take();
  for (const auto& [name, option] : pack.options.all()) {
    items.add("option." + name, kPropertyItem, "");
    items.add("option." + name + ".comment", kPropertyItem, "tooltip");
    for (const std::string& value : option.values)
      if (!option.isBoolean) items.add("value." + name + "." + value, kPropertyItem, "");
  }
  for (const Screen& screen : pack.properties.screens) {
    if (screen.name.empty()) continue;
    items.add("screen." + screen.name, kPropertyItem, "");
    items.add("screen." + screen.name + ".comment", kPropertyItem, "tooltip");
  }
  for (const Profile& profile : pack.properties.profiles)
    items.add("profile." + profile.name, kPropertyItem, "");
  return items.take();
}

}  // namespace

json completionsAt(const EditorPlace& at) {
  switch (kindOfFile(at.file)) {
    case PackFileKind::Shader:
      return shaderItems(at);
    case PackFileKind::Properties:
      return at.line.find('=') < at.place.at ? valueItems(at) : keyItems(at);
    case PackFileKind::Ids:
      return blockItems(at);
    case PackFileKind::Language:
      return languageItems(at);
    default:
      return json::array();
  }
}

}  // namespace orris
