// The members of a world.json that say what is there besides blocks.
#pragma once

#include <orris/world/files/json_reader.h>
#include <orris/world/world.h>

namespace orris {

/// Keys of the root that readContent() reads.
const std::vector<std::string>& contentKeys();

WorldContent readContent(JsonReader& reader, const JsonNode& root, const BlockWorld& blocks);

/// An item's name with its namespace: "torch" is "minecraft:torch".
std::string readItem(JsonReader& reader, const JsonNode& object, const std::string& key);

/// "entity" of an event.
ChangeEntity readEntityChange(JsonReader& reader, const JsonNode& node,
                              const WorldContent& content);
/// "lightning" of an event.
StrikeLightning readLightning(JsonReader& reader, const JsonNode& node);

}  // namespace orris
