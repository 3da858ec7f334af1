#include <orris/world/items/item_definition.h>

#include <orris/core/limits.h>
#include <orris/world/files/json_reader.h>
#include <orris/world/items/item_tints.h>

namespace orris {
namespace {

/// The first member of the first entry of a list: of "cases", "entries".
const JsonNode* firstModel(const JsonNode& node, const std::string& list) {
  const JsonNode* entries = node.find(list);
  if (!entries || entries->items.empty()) return nullptr;
  return entries->items.front().find("model");
}

/// What a description of a model builds on; nullptr: nothing.
const JsonNode* innerModel(const JsonNode& node) {
  for (const char* key : {"on_false", "fallback"})
    if (const JsonNode* inner = node.find(key)) return inner;
  for (const char* list : {"cases", "entries"})
    if (const JsonNode* inner = firstModel(node, list)) return inner;
  const JsonNode* parts = node.find("models");
  return parts && !parts->items.empty() ? &parts->items.front() : nullptr;
}

std::vector<ItemTint> parseTints(const JsonNode& node, JsonReader& reader) {
  const JsonNode* list = node.find("tints");
  if (!list || !reader.array(*list, "\"tints\"")) return {};
  std::vector<ItemTint> tints;
  for (const JsonNode& entry : list->items) tints.push_back(parseItemTint(entry, reader));
  return tints;
}

}  // namespace

std::optional<ItemDefinition> parseItemDefinition(const ResourceFile& file,
                                                  Diagnostics& diagnostics) {
  const JsonText source{file.bytes, file.place, &kResourceJson};
  JsonReader reader(source, diagnostics);
  const auto root = parseLocatedJson(source, diagnostics);
  if (!root) return std::nullopt;
  const JsonNode* node = root->find("model");
  for (std::size_t depth = 0; node && depth < limits::kModelDepth; ++depth) {
    if (node->kind != JsonNode::Kind::Object) {
      reader.expected(*node, "\"model\"", "an object");
      return std::nullopt;
    }
    if (const JsonNode* name = node->find("model")) {
      const auto model = reader.string(*name, "\"model\"");
      if (!model) return std::nullopt;
      return ItemDefinition{*model, parseTints(*node, reader)};
    }
    node = innerModel(*node);
  }
  return std::nullopt;
}

}  // namespace orris
