#include <orris/world/resources/blockstate_json.h>

#include <fmt/core.h>

#include <algorithm>

#include <orris/core/limits.h>
#include <orris/world/files/json_reader.h>

namespace orris {
namespace {

using Kind = JsonNode::Kind;
using Properties = std::map<std::string, std::string>;

std::vector<std::string> splitAt(std::string_view text, char separator) {
  std::vector<std::string> words;
  while (true) {
    const std::size_t end = text.find(separator);
    words.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos) return words;
    text.remove_prefix(end + 1);
  }
}

/// Packs write values as strings, numbers and booleans.
std::optional<std::string> valueText(const JsonNode& node) {
  if (node.kind == Kind::String) return node.text;
  if (node.kind == Kind::Integer) return fmt::format("{}", node.integer);
  if (node.kind == Kind::Boolean) return node.boolean ? "true" : "false";
  return std::nullopt;
}

class BlockStateReader {
 public:
  explicit BlockStateReader(JsonReader& reader) : reader_(reader) {}

  bool read(const JsonNode& root, BlockStateFile& file) {
    const JsonNode* variants = root.find("variants");
    const JsonNode* parts = root.find("multipart");
    if (!variants && !parts)
      reader_.error(root.offset, "expected an object with \"variants\" or \"multipart\"");
    if (variants) readVariants(*variants, file);
    if (parts) readParts(*parts, file);
    return !reader_.failed();
  }

 private:
  bool counted(std::size_t offset) {
    if (++uses_ <= limits::kStateVariants) return true;
    if (uses_ == limits::kStateVariants + 1)
      reader_.error(offset, fmt::format("more than {} variants and parts up to here",
                                        limits::kStateVariants));
    return false;
  }

  void readVariants(const JsonNode& node, BlockStateFile& file) {
    if (node.kind != Kind::Object) return reader_.expected(node, "\"variants\"", "an object");
    for (const JsonMember& member : node.members) {
      Properties properties;
      if (!counted(member.offset)) return;
      if (!readKey(member, properties)) continue;
      file.variants.emplace_back(std::move(properties), readUses(member.value));
    }
  }

  bool readKey(const JsonMember& member, Properties& properties) {
    if (member.key.empty() || member.key == "normal") return true;
    for (const std::string& term : splitAt(member.key, ',')) {
      const std::size_t equals = term.find('=');
      if (equals == std::string::npos) {
        reader_.error(
            member.offset,
            fmt::format("\"{}\" is no variant: expected NAME=VALUE,... or nothing", member.key));
        return false;
      }
      properties[term.substr(0, equals)] = term.substr(equals + 1);
    }
    return true;
  }

  void readParts(const JsonNode& node, BlockStateFile& file) {
    if (!reader_.array(node, "\"multipart\"")) return;
    file.multipart = true;
    for (const JsonNode& item : node.items) {
      if (!counted(item.offset)) return;
      const JsonNode* apply = reader_.required(item, "apply", "a part");
      if (!apply) continue;
      StateCondition when;
      if (const JsonNode* condition = item.find("when")) when = readCondition(*condition);
      file.parts.emplace_back(std::move(when), readUses(*apply));
    }
  }

  std::vector<StateCondition> readConditions(const JsonNode& node) {
    std::vector<StateCondition> conditions;
    if (!reader_.array(node, "a list of conditions")) return conditions;
    for (const JsonNode& item : node.items) {
      if (!counted(item.offset)) break;
      conditions.push_back(readCondition(item));
    }
    return conditions;
  }

  StateCondition readCondition(const JsonNode& node) {
    StateCondition condition;
    if (node.kind != Kind::Object) {
      reader_.expected(node, "a condition", "an object");
      return condition;
    }
    for (const JsonMember& member : node.members) {
      if (member.key == "OR") {
        condition.any = readConditions(member.value);
      } else if (member.key == "AND") {
        condition.all = readConditions(member.value);
      } else if (const auto text = valueText(member.value)) {
        const bool negated = text->starts_with('!');
        condition.tests.push_back(
            {member.key, splitAt(std::string_view(*text).substr(negated ? 1 : 0), '|'), negated});
      } else {
        reader_.expected(member.value, fmt::format("\"{}\"", member.key),
                         "a value of the property");
      }
    }
    return condition;
  }

  ModelUses readUses(const JsonNode& node) {
    ModelUses uses;
    if (node.kind != Kind::Array) {
      uses.push_back(readUse(node));
      return uses;
    }
    if (node.items.empty()) reader_.error(node.offset, "the list of models is empty");
    for (const JsonNode& item : node.items) {
      if (!counted(item.offset)) break;
      uses.push_back(readUse(item));
    }
    return uses;
  }

  ModelUse readUse(const JsonNode& node) {
    ModelUse use;
    const JsonNode* model = reader_.required(node, "model", "a variant");
    if (!model) return use;
    use.model = reader_.string(*model, "\"model\"").value_or("");
    use.offset = model->offset;
    for (const auto& [key, angle] : {std::pair{"x", &use.x}, std::pair{"y", &use.y}}) {
      reader_.optional(node, key, IntegerRange{-270, 270}, *angle);
      if (*angle % 90 != 0)
        reader_.error(node.find(key)->offset,
                      fmt::format("\"{}\" is 0, 90, 180 or 270 degrees", key));
    }
    reader_.optional(node, "uvlock", use.uvLock);
    reader_.optional(node, "weight", IntegerRange{1, 1 << 16}, use.weight);
    return use;
  }

  JsonReader& reader_;
  std::size_t uses_ = 0;
};

bool testHolds(const PropertyTest& test, const Properties& properties) {
  const auto found = properties.find(test.name);
  if (found == properties.end()) return false;
  const bool has =
      std::find(test.values.begin(), test.values.end(), found->second) != test.values.end();
  return has != test.negated;
}

}  // namespace

bool StateCondition::holds(const Properties& properties) const {
  const auto each = [&](const auto& condition) { return condition.holds(properties); };
  return std::all_of(tests.begin(), tests.end(),
                     [&](const PropertyTest& test) { return testHolds(test, properties); }) &&
         std::all_of(all.begin(), all.end(), each) &&
         (any.empty() || std::any_of(any.begin(), any.end(), each));
}

const ModelUses* BlockStateFile::variantFor(const Properties& properties) const {
  const ModelUses* best = nullptr;
  std::size_t fewest = 0;
  for (const auto& [wanted, uses] : variants) {
    std::size_t unknown = 0;
    const bool fits = std::all_of(wanted.begin(), wanted.end(), [&](const auto& term) {
      const auto found = properties.find(term.first);
      unknown += found == properties.end();
      return found == properties.end() || found->second == term.second;
    });
    if (!fits || (best && unknown >= fewest)) continue;
    best = &uses;
    fewest = unknown;
  }
  return best;
}

std::optional<BlockStateFile> parseBlockStates(ResourceFile file, Diagnostics& diagnostics) {
  const JsonText source{file.bytes, file.place, &kResourceJson};
  JsonReader reader(source, diagnostics);
  const auto root = parseLocatedJson(source, diagnostics);
  BlockStateFile states;
  if (!root || !BlockStateReader(reader).read(*root, states)) return std::nullopt;
  states.place = file.place;
  states.text = std::move(file.bytes);
  return states;
}

}  // namespace orris
