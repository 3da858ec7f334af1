#include <orris/world/resources/model_json.h>

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include <orris/core/limits.h>
#include <orris/world/files/json_reader.h>

namespace orris {
namespace {

using Kind = JsonNode::Kind;

// In the order of FaceDirection.
constexpr std::array<std::string_view, 6> kDirectionNames = {"down",  "up",   "north",
                                                             "south", "west", "east"};
constexpr RealRange kUv{-4096, 4096}, kPlace{-16, 32}, kOrigin{-256, 256}, kAngle{-180, 180};
// In the order of DisplayPlace. The rest of "display" is of no use here.
constexpr std::array<const char*, kDisplayPlaces> kPlaceNames = {
    "firstperson_righthand", "firstperson_lefthand", "thirdperson_righthand", "thirdperson_lefthand", "ground", "fixed"};
// The game takes any number and keeps the moves and sizes within these.
constexpr RealRange kPose{-1e6, 1e6};
constexpr float kMostMoved = 80, kMostScaled = 4;

std::optional<FaceDirection> directionNamed(std::string_view name) {
  if (name == "bottom") name = "down";  // the game's older word
  const auto found = std::find(kDirectionNames.begin(), kDirectionNames.end(), name);
  if (found == kDirectionNames.end()) return std::nullopt;
  return FaceDirection(found - kDirectionNames.begin());
}

class ModelReader {
 public:
  explicit ModelReader(JsonReader& reader) : reader_(reader) {}

  bool read(const JsonNode& root, ModelFile& model) {
    if (root.kind != Kind::Object) {
      reader_.expected(root, "the model", "an object");
      return false;
    }
    if (const JsonNode* parent = root.find("parent")) readParent(*parent, model);
    if (const JsonNode* textures = root.find("textures")) readTextures(*textures, model);
    bool ambient = true;
    reader_.optional(root, "ambientocclusion", ambient);
    if (root.find("ambientocclusion")) model.ambientOcclusion = ambient;
    if (const JsonNode* elements = root.find("elements")) readElements(*elements, model);
    if (const JsonNode* display = root.find("display")) readDisplay(*display, model.display);
    return !reader_.failed();
  }

 private:
  void readParent(const JsonNode& node, ModelFile& model) {
    model.parent = reader_.string(node, "\"parent\"").value_or("");
    model.parentAt = reader_.source().error(node.offset, "", "").at;
  }

  void readTextures(const JsonNode& node, ModelFile& model) {
    if (node.kind != Kind::Object) return reader_.expected(node, "\"textures\"", "an object");
    if (node.members.size() > limits::kModelTextures)
      return reader_.error(node.offset,
                           fmt::format("the model has {} texture variables: expected at most {}",
                                       node.members.size(), limits::kModelTextures));
    for (const JsonMember& member : node.members) {
      // Since 26.1 a texture may be an object that names it.
      const JsonNode* sprite = member.value.find("sprite");
      const auto value = reader_.string(sprite ? *sprite : member.value, "a texture");
      if (value) model.textures[member.key] = *value;
    }
  }

  void readElements(const JsonNode& node, ModelFile& model) {
    if (!reader_.array(node, "\"elements\"")) return;
    if (node.items.size() > limits::kModelElements)
      return reader_.error(node.offset,
                           fmt::format("the model has {} elements: expected at most {}",
                                       node.items.size(), limits::kModelElements));
    model.elements.emplace();
    for (const JsonNode& item : node.items) {
      if (item.kind != Kind::Object) {
        reader_.expected(item, "an element", "an object");
        continue;
      }
      model.elements->push_back(readElement(item));
    }
  }

  void readDisplay(const JsonNode& node, DisplayPoses& display) {
    if (node.kind != Kind::Object) return reader_.expected(node, "\"display\"", "an object");
    for (std::size_t i = 0; i < kDisplayPlaces; ++i)
      if (const JsonNode* pose = node.find(kPlaceNames[i])) display[i] = readPose(*pose);
    // The left hand mirrors the right one, before a parent is asked.
    constexpr std::pair<DisplayPlace, DisplayPlace> kHands[] = {{DisplayPlace::FirstLeft, DisplayPlace::FirstRight},
                                                               {DisplayPlace::ThirdLeft, DisplayPlace::ThirdRight}};
    for (const auto& [left, right] : kHands)
      if (!display[std::size_t(left)]) display[std::size_t(left)] = display[std::size_t(right)];
  }

  DisplayPose readPose(const JsonNode& node) {
    DisplayPose pose;
    if (node.kind != Kind::Object) {
      reader_.expected(node, "a place of \"display\"", "an object");
      return pose;
    }
    reader_.optional(node, "rotation", kPose, pose.degrees);
    reader_.optional(node, "translation", kPose, pose.translation);
    reader_.optional(node, "scale", kPose, pose.scale);
    pose.translation = glm::clamp(pose.translation, -kMostMoved, kMostMoved);
    pose.scale = glm::clamp(pose.scale, -kMostScaled, kMostScaled);
    return pose;
  }

  ElementTemplate readElement(const JsonNode& node) {
    ElementTemplate element;
    readPoint(node, "from", kPlace, element.from);
    readPoint(node, "to", kPlace, element.to);
    if (const JsonNode* turn = node.find("rotation")) element.turn = readTurn(*turn);
    reader_.optional(node, "shade", element.shade);
    const JsonNode* faces = reader_.required(node, "faces", "an element");
    if (faces && faces->kind != Kind::Object) {
      reader_.expected(*faces, "\"faces\"", "an object");
    } else if (faces) {
      for (const JsonMember& member : faces->members) readFace(member, element);
    }
    return element;
  }

  void readPoint(const JsonNode& node, const char* key, RealRange range, glm::vec3& point) {
    const JsonNode* member = reader_.required(node, key, "an element");
    const auto value =
        member ? reader_.vector(*member, fmt::format("\"{}\"", key), range) : std::nullopt;
    if (value) point = glm::vec3(*value);
  }

  std::optional<ElementTurn> readTurn(const JsonNode& node) {
    if (node.kind != Kind::Object) {
      reader_.expected(node, "\"rotation\"", "an object");
      return std::nullopt;
    }
    ElementTurn turn;
    if (const JsonNode* origin = node.find("origin")) {
      const auto value = reader_.vector(*origin, "\"origin\"", kOrigin);
      if (value) turn.origin = glm::vec3(*value);
    }
    reader_.optional(node, "rescale", turn.rescale);
    // Since 1.21.11 the angles may stand by axis.
    for (const int axis : {0, 1, 2}) {
      const JsonNode* angle = node.find(std::string(1, char('x' + axis)));
      const auto degrees = angle ? reader_.number(*angle, "an angle", kAngle) : std::nullopt;
      turn.degrees[axis] = float(degrees.value_or(0));
    }
    const JsonNode* axis = node.find("axis");
    if (!axis) return turn;
    const std::string name = reader_.string(*axis, "\"axis\"").value_or("");
    if (name != "x" && name != "y" && name != "z") reader_.expected(*axis, "\"axis\"", "x, y or z");
    const JsonNode* angle = reader_.required(node, "angle", "\"rotation\"");
    const auto degrees = angle ? reader_.number(*angle, "\"angle\"", kAngle) : std::nullopt;
    turn.degrees = glm::vec3(0);
    turn.degrees[name.empty() ? 0 : std::clamp(name[0] - 'x', 0, 2)] = float(degrees.value_or(0));
    return turn;
  }

  void readFace(const JsonMember& member, ElementTemplate& element) {
    const auto direction = directionNamed(member.key);
    if (!direction || member.value.kind != Kind::Object)
      return reader_.error(
          member.offset, fmt::format("\"{}\" is no face: expected an object named down, up, north, "
                                     "south, west or east",
                                     member.key));
    FaceTemplate face;
    const JsonNode* texture = reader_.required(member.value, "texture", "a face");
    if (texture) face.texture = reader_.string(*texture, "\"texture\"").value_or("");
    if (const JsonNode* uv = member.value.find("uv")) face.uv = readUv(*uv);
    reader_.optional(member.value, "rotation", IntegerRange{-270, 270}, face.rotation);
    if (face.rotation % 90 != 0) {
      reader_.error(member.value.find("rotation")->offset,
                    "\"rotation\" of a texture is 0, 90, 180 or 270 degrees");
    }
    reader_.optional(member.value, "tintindex", IntegerRange{-1, 1 << 24}, face.tintIndex);
    std::string cull;
    reader_.optional(member.value, "cullface", cull);
    face.cull = directionNamed(cull);
    element.faces[std::size_t(*direction)] = std::move(face);
  }

  std::optional<std::array<float, 4>> readUv(const JsonNode& node) {
    if (node.kind != Kind::Array || node.items.size() != 4) {
      reader_.expected(node, "\"uv\"", "four numbers");
      return std::nullopt;
    }
    std::array<float, 4> uv{};
    for (std::size_t i = 0; i < 4; ++i)
      uv[i] = float(reader_.number(node.items[i], "a texture coordinate", kUv).value_or(0));
    return uv;
  }

  JsonReader& reader_;
};

}  // namespace

std::optional<ModelFile> parseModel(const ResourceFile& file, Diagnostics& diagnostics) {
  const JsonText source{file.bytes, file.place, &kResourceJson};
  JsonReader reader(source, diagnostics);
  const auto root = parseLocatedJson(source, diagnostics);
  ModelFile model;
  model.place = file.place;
  if (!root || !ModelReader(reader).read(*root, model)) return std::nullopt;
  return model;
}

}  // namespace orris
