#include <orris/world/blocks/block_data.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cctype>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>

namespace orris {

extern const char* const kBlocksJson;
extern const char* const kShapesJson;

namespace {

using Json = nlohmann::ordered_json;  // variants apply in the order of the file

constexpr std::array<std::string_view, 6> kFaceNames{"down",  "up",   "north",
                                                     "south", "west", "east"};

/// One member of a name list: "oak" and, where the list gives one, "#a2834f".
struct ListEntry {
  std::string key, value;
};
using NameLists = std::map<std::string, std::vector<ListEntry>>;

/// A concrete name and what "$name", "$key", "$value" and "$<list>" (the value of the same key in
/// another list) stand for in its definition.
struct ExpandedName {
  std::string name;
  std::map<std::string, std::string> words;
};

ExpandedName nameWithWords(const std::string& name, const ListEntry& entry,
                           const NameLists& lists) {
  ExpandedName result{name, {{"$name", name}, {"$key", entry.key}, {"$value", entry.value}}};
  for (const auto& [list, entries] : lists) {
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [&](const ListEntry& other) { return other.key == entry.key; });
    if (found != entries.end()) result.words["$" + list] = found->value;
  }
  return result;
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  size_t start = 0;
  while (start <= text.size()) {
    const size_t end = std::min(text.find(separator, start), text.size());
    parts.emplace_back(text.substr(start, end - start));
    start = end + 1;
  }
  return parts;
}

BlockCondition conditionOf(const std::string& text) {
  BlockCondition condition;
  if (text.empty()) return condition;
  for (const std::string& term : split(text, ',')) {
    const size_t equals = term.find('=');
    assert(equals != std::string::npos);
    condition.terms.emplace_back(term.substr(0, equals), split(term.substr(equals + 1), '|'));
  }
  return condition;
}

NameLists listsOf(const Json& lists) {
  NameLists result;
  for (const auto& [name, members] : lists.items()) {
    for (const auto& [key, value] : members.items()) {
      const std::string text = value.get<std::string>();
      result[name].push_back(members.is_array() ? ListEntry{text, ""} : ListEntry{key, text});
    }
  }
  return result;
}

/// The names of a definition: one string or several, separated by spaces.
std::vector<std::string> patternsOf(const Json& names) {
  if (names.is_string()) return split(names.get<std::string>(), ' ');
  std::vector<std::string> result;
  for (const Json& line : names) {
    for (std::string& name : split(line.get<std::string>(), ' ')) result.push_back(std::move(name));
  }
  return result;
}

/// "{wood}_door" becomes oak_door, birch_door...; a name holds at most one list.
std::vector<ExpandedName> expandNames(const Json& names, const NameLists& lists) {
  std::vector<ExpandedName> result;
  for (const std::string& pattern : patternsOf(names)) {
    const size_t open = pattern.find('{'), close = pattern.find('}');
    if (open == std::string::npos) {
      result.push_back(nameWithWords(pattern, {pattern, ""}, lists));
      continue;
    }
    for (const ListEntry& entry : lists.at(pattern.substr(open + 1, close - open - 1))) {
      const std::string name = pattern.substr(0, open) + entry.key + pattern.substr(close + 1);
      result.push_back(nameWithWords(name, entry, lists));
    }
  }
  return result;
}

std::string substitute(std::string text, const ExpandedName& name) {
  for (const auto& [word, replacement] : name.words) {
    for (size_t at = text.find(word); at != std::string::npos; at = text.find(word)) {
      text.replace(at, word.size(), replacement);
    }
  }
  return text;
}

RenderLayer layerOf(const std::string& text) {
  static const std::map<std::string, RenderLayer> kLayers{
      {"solid", RenderLayer::Solid},
      {"cutout", RenderLayer::Cutout},
      {"translucent", RenderLayer::Translucent}};
  return kLayers.at(text);
}

Tint tintOf(const std::string& text) {
  static const std::map<std::string, Tint> kTints{{"none", Tint::None},
                                                  {"grass", Tint::Grass},
                                                  {"foliage", Tint::Foliage},
                                                  {"water", Tint::Water}};
  return kTints.at(text);
}

template <class T>
std::optional<T> optionalOf(const Json& spec, const char* key) {
  const auto found = spec.find(key);
  return found == spec.end() ? std::nullopt : std::optional<T>(found->template get<T>());
}

std::map<std::string, std::string> texturePartsOf(const Json& spec, const ExpandedName& name) {
  const auto found = spec.find("textures");
  if (found == spec.end()) return {};
  if (found->is_string()) return {{"all", substitute(found->get<std::string>(), name)}};
  std::map<std::string, std::string> parts;
  for (const auto& [part, texture] : found->items()) {
    parts[part] = substitute(texture.get<std::string>(), name);
  }
  return parts;
}

FactsPatch patchOf(const Json& spec, const ExpandedName& name) {
  FactsPatch patch;
  patch.shape = optionalOf<std::string>(spec, "shape");
  patch.textures = texturePartsOf(spec, name);
  patch.emission = optionalOf<int>(spec, "emission");
  patch.opacity = optionalOf<int>(spec, "opacity");
  if (const auto layer = optionalOf<std::string>(spec, "layer")) patch.layer = layerOf(*layer);
  if (const auto tint = optionalOf<std::string>(spec, "tint")) patch.tint = tintOf(*tint);
  patch.air = optionalOf<bool>(spec, "air");
  patch.fluid = optionalOf<bool>(spec, "fluid");
  patch.cullsSame = optionalOf<bool>(spec, "cullsSame");
  patch.waterlogged = optionalOf<bool>(spec, "waterlogged");
  patch.blockEntity = optionalOf<bool>(spec, "blockEntity");
  return patch;
}

BlockDefinition blockOf(const Json& spec, const ExpandedName& name) {
  BlockDefinition definition;
  if (const auto defaults = spec.find("defaults"); defaults != spec.end()) {
    definition.defaults = defaults->get<BlockProperties>();
  }
  definition.base = patchOf(spec, name);
  if (definition.base.textures.empty()) definition.base.textures["all"] = name.name;
  if (const auto variants = spec.find("variants"); variants != spec.end()) {
    for (const auto& [when, variant] : variants->items()) {
      definition.variants.emplace_back(conditionOf(when), patchOf(variant, name));
    }
  }
  return definition;
}

int faceIndex(std::string_view name) {
  const auto found = std::find(kFaceNames.begin(), kFaceNames.end(), name);
  assert(found != kFaceNames.end());
  return int(found - kFaceNames.begin());
}

/// "x0 y0 z0 x1 y1 z1", then "-up" (no such face) or "up=end" (another part of the textures).
BoxTemplate boxOf(const std::string& text) {
  std::istringstream words(text);
  BoxTemplate box;
  words >> box.from.x >> box.from.y >> box.from.z >> box.to.x >> box.to.y >> box.to.z;
  assert(words);
  for (std::string word; words >> word;) {
    const size_t equals = word.find('=');
    if (word[0] == '-') {
      box.faces[faceIndex(word.substr(1))] = "-";
    } else if (equals != std::string::npos) {
      box.faces[faceIndex(word.substr(0, equals))] = word.substr(equals + 1);
    } else {
      for (std::string& face : box.faces) face = face.empty() ? word : face;
    }
  }
  return box;
}

ShapePart partOf(const Json& spec) {
  ShapePart part;
  if (spec.is_string()) {
    part.boxes.push_back(boxOf(spec.get<std::string>()));
    return part;
  }
  part.when = conditionOf(spec.value("when", ""));
  if (spec.contains("around")) part.around = split(spec["around"].get<std::string>(), '|');
  for (const Json& box : spec.at("boxes")) part.boxes.push_back(boxOf(box.get<std::string>()));
  return part;
}

ShapeTemplate shapeOf(const Json& spec) {
  ShapeTemplate shape;
  shape.rotate = spec.value("rotate", "");
  shape.stand = spec.value("stand", "");
  if (spec.contains("flip")) shape.flip = conditionOf(spec["flip"].get<std::string>());
  shape.cross = spec.value("cross", false);
  for (const Json& part : spec.at("parts")) shape.parts.push_back(partOf(part));
  return shape;
}

/// "#rrggbb" or "#rrggbbaa".
glm::u8vec4 colourOf(const std::string& text) {
  assert(text.size() == 7 || text.size() == 9);
  glm::u8vec4 colour(255);
  for (size_t i = 0; i * 2 + 2 < text.size(); ++i) {
    colour[int(i)] = std::uint8_t(std::stoi(text.substr(i * 2 + 1, 2), nullptr, 16));
  }
  return colour;
}

TextureDefinition textureNamed(const Json& spec, const ExpandedName& name) {
  TextureDefinition texture;
  texture.recipe = spec.at("recipe").get<std::string>();
  for (const Json& colour : spec.value("colours", Json::array())) {
    texture.colours.push_back(colourOf(substitute(colour.get<std::string>(), name)));
  }
  texture.base = spec.value("base", "");
  texture.art = spec.value("art", std::vector<std::string>{});
  for (const auto& [key, value] : spec.items()) {
    if (value.is_number()) texture.numbers[key] = value.get<float>();
  }
  return texture;
}

BlockData read(const Json& root, const Json& shapes) {
  BlockData data;
  const NameLists lists = listsOf(root.at("lists"));
  for (const auto& [name, shape] : shapes.items()) data.shapes[name] = shapeOf(shape);
  for (const Json& spec : root.at("blocks")) {
    for (const ExpandedName& name : expandNames(spec.at("names"), lists)) {
      data.blocks[name.name] = blockOf(spec, name);
    }
  }
  for (const Json& spec : root.at("textures")) {
    for (const ExpandedName& name : expandNames(spec.at("names"), lists)) {
      data.textures[name.name] = textureNamed(spec, name);
    }
  }
  return data;
}

}  // namespace

bool BlockCondition::holds(const BlockProperties& properties) const {
  return std::all_of(terms.begin(), terms.end(), [&](const auto& term) {
    const auto found = properties.find(term.first);
    const std::string& value = found == properties.end() ? std::string() : found->second;
    return std::find(term.second.begin(), term.second.end(), value) != term.second.end();
  });
}

const BlockData& blockData() {
  static const BlockData data = read(Json::parse(kBlocksJson), Json::parse(kShapesJson));
  return data;
}

const BlockDefinition* definitionOf(const std::string& name) {
  constexpr std::string_view kGame = "minecraft:";
  if (!name.starts_with(kGame)) return nullptr;
  const auto& blocks = blockData().blocks;
  const auto found = blocks.find(name.substr(kGame.size()));
  return found == blocks.end() ? nullptr : &found->second;
}

BlockProperties wholeProperties(const BlockState& state) {
  BlockProperties properties = state.properties;
  if (const BlockDefinition* definition = definitionOf(state.name))
    properties.insert(definition->defaults.begin(), definition->defaults.end());
  return properties;
}

}  // namespace orris
