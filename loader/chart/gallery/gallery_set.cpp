#include <orris/chart/gallery/gallery_set.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include <orris/core/limits.h>
#include <orris/pack/files/text.h>
#include <orris/world/files/json_reader.h>

namespace orris {

// Hills by the hour and in rain, under water, a house, a closed room, a cave with lava, and what is no block.
const char* const kDefaultGallerySet = R"({"scenes": [
  {"world": "terrain", "cameras": ["shore"], "times": [1000, 6000, 12800, 18000]},
  {"world": "terrain", "cameras": ["shore"], "times": [6000], "weathers": ["rain"]},
  {"world": "terrain", "cameras": ["water"]},
  {"world": "glazed_house", "cameras": ["ground"]},
  {"world": "cornell"},
  {"world": "lava_cave"},
  {"world": "everything"}
]})";

namespace {

using Kind = JsonNode::Kind;

constexpr int kLastTick = 23'999;

struct WeatherRow {
  const char* name;
  float rain, thunder;
};
constexpr WeatherRow kWeathers[] = {{"clear", 0, 0}, {"rain", 1, 0}, {"thunder", 1, 1}};

/// A value of a list, and where it stands.
struct Listed {
  std::string text;
  std::size_t offset = 0;
};

class SetReader {
 public:
  SetReader(const JsonText& source, const std::vector<std::string>& profiles,
            const std::vector<std::string>& known, Diagnostics& found)
      : source_(source), reader_(source, found), profiles_(profiles), known_(known) {}

  void read(const JsonNode& root, GallerySet& set) {
    const std::string what = "a gallery";
    if (!reader_.object(root, what, {"size", "frames", "scenes"})) return;
    readSize(root, set);
    if (const JsonNode* frames = root.find("frames"))
      set.frames = reader_.integer(*frames, "\"frames\"", {1, kMaxGalleryFrames});
    const JsonNode* scenes = reader_.required(root, "scenes", what);
    if (!scenes || !reader_.array(*scenes, "\"scenes\"")) return;
    if (scenes->items.empty()) reader_.expected(*scenes, "\"scenes\"", "at least one scene");
    for (const JsonNode& scene : scenes->items)
      if (set.shots.size() <= kMaxGalleryPictures) readScene(scene, set);
  }

 private:
  void readSize(const JsonNode& root, GallerySet& set) {
    const JsonNode* node = root.find("size");
    if (!node) return;
    if (const auto text = reader_.string(*node, "\"size\"")) {
      set.size = parseImageSize(*text);
      if (!set.size) reader_.expected(*node, "\"size\"", "WIDTHxHEIGHT such as \"480x270\"");
    }
  }

  /// Texts of a list, each of `allowed` unless that is empty; `absent` where there is no list.
  std::vector<Listed> texts(const JsonNode& scene, const char* key,
                            const std::vector<std::string>* allowed, std::vector<Listed> absent) {
    const JsonNode* node = scene.find(key);
    if (!node) return absent;
    const std::string what = fmt::format("\"{}\"", key);
    std::vector<Listed> found;
    if (!reader_.array(*node, what)) return found;
    if (node->items.empty()) reader_.expected(*node, what, "at least one");
    for (const JsonNode& item : node->items) {
      const auto text = reader_.string(item, what);
      if (text && (allowed == nullptr || isOneOf(item, *text, *allowed, what)))
        found.push_back({*text, item.offset});
    }
    return found;
  }

  bool isOneOf(const JsonNode& node, const std::string& text, const std::vector<std::string>& allowed,
               const std::string& what) {
    if (std::ranges::find(allowed, text) != allowed.end()) return true;
    const std::string meant = suggest(text, allowed);
    const std::string all = allowed.empty() ? "there are none" : "there are " + joinNames(allowed);
    reader_.error(node.offset, fmt::format("{} has no \"{}\"", what, text), meant.empty() ? all : meant);
    return false;
  }

  std::vector<Listed> profiles(const JsonNode& scene) {
    const JsonNode* node = scene.find("profiles");
    const bool all = node ? node->kind == Kind::String && node->text == "all" : profiles_ == std::vector<std::string>{"all"};
    std::vector<Listed> named;
    for (const std::string& name : all ? known_ : profiles_) named.push_back({name, scene.offset});
    if (named.empty()) named.push_back({"", scene.offset});
    return all ? named : texts(scene, "profiles", &known_, named);
  }

  /// "" for the world's own time.
  std::vector<Listed> times(const JsonNode& scene) {
    const JsonNode* node = scene.find("times");
    if (!node) return {{"", scene.offset}};
    std::vector<Listed> found;
    if (!reader_.array(*node, "\"times\"")) return found;
    if (node->items.empty()) reader_.expected(*node, "\"times\"", "at least one");
    for (const JsonNode& item : node->items)
      if (const auto time = reader_.integer(item, "a time", {0, kLastTick}))
        found.push_back({std::to_string(*time), item.offset});
    return found;
  }

  OptionValues values(const JsonNode& scene) {
    OptionValues found;
    const JsonNode* node = scene.find("set");
    if (!node) return found;
    if (node->kind != Kind::Object) reader_.expected(*node, "\"set\"", "an object {\"OPTION\": \"VALUE\"}");
    for (const JsonMember& member : node->members)
      if (const auto value = reader_.string(member.value, fmt::format("\"{}\"", member.key)))
        found[member.key] = *value;
    return found;
  }

  void readScene(const JsonNode& scene, GallerySet& set) {
    if (!reader_.object(scene, "a scene", {"name", "world", "cameras", "times", "weathers", "profiles", "set"})) return;
    const JsonNode* worldNode = reader_.required(scene, "world", "a scene");
    const auto world = worldNode ? reader_.string(*worldNode, "\"world\"") : std::nullopt;
    std::string name;
    reader_.optional(scene, "name", name);
    const std::vector<std::string> known = galleryWeathers();
    const std::vector<Listed> none = {{"", scene.offset}};
    const auto cameras = texts(scene, "cameras", nullptr, none);
    const auto weathers = texts(scene, "weathers", &known, none);
    const auto hours = times(scene);
    const auto named = profiles(scene);
    const OptionValues options = values(scene);
    if (!world) return;
    const std::size_t count = cameras.size() * hours.size() * weathers.size() * named.size();
    if (cameras.size() > kMaxGalleryPictures || hours.size() > kMaxGalleryPictures ||
        set.shots.size() + count > kMaxGalleryPictures) {
      reader_.error(scene.offset, fmt::format("the set has more than {} pictures with this scene", kMaxGalleryPictures),
                    "name fewer cameras, times, weathers or profiles");
      return;
    }
    for (const Listed& camera : cameras)
      for (const Listed& time : hours)
        for (const Listed& weather : weathers)
          for (const Listed& profile : named) {
            GalleryShot shot;
            shot.world = *world;
            shot.camera = camera.text;
            if (!time.text.empty()) shot.time = std::stoi(time.text);
            shot.weather = weather.text;
            shot.profile = profile.text;
            shot.values = options;
            add(std::move(shot), name, {worldNode->offset, camera, profile}, set);
          }
  }

  struct Places {
    std::size_t world;
    const Listed &camera, &profile;
  };

  /// A message about the picture points at what most often is wrong: its camera, else its world.
  void add(GalleryShot shot, const std::string& name, const Places& places, GallerySet& set) {
    shot.name = name.empty() ? shot.world : name;
    if (name.empty() && !shot.camera.empty()) shot.name += ", " + shot.camera;
    if (shot.time) shot.name += fmt::format(", {}", *shot.time);
    if (!shot.weather.empty()) shot.name += ", " + shot.weather;
    if (!shot.profile.empty()) shot.name += ", " + shot.profile;
    const std::size_t offset = shot.camera.empty() ? places.world : places.camera.offset;
    shot.worldOffset = places.world;
    shot.at = source_.error(offset, "gallery-set", "").at;
    if (!names_.insert(shot.name).second) {
      reader_.error(offset, fmt::format("two pictures are named \"{}\"", shot.name),
                    "give one of the scenes a \"name\" of its own");
      return;
    }
    set.shots.push_back(std::move(shot));
  }

  const JsonText& source_;
  JsonReader reader_;
  const std::vector<std::string>&profiles_, &known_;
  std::set<std::string> names_;
};

}  // namespace

std::vector<std::string> galleryWeathers() {
  std::vector<std::string> names;
  for (const WeatherRow& row : kWeathers) names.emplace_back(row.name);
  return names;
}

bool applyWeather(const std::string& weather, Environment& environment) {
  if (weather.empty()) return true;
  const auto row = std::ranges::find(kWeathers, weather, &WeatherRow::name);
  if (row == std::end(kWeathers)) return false;
  environment.rain = row->rain;
  environment.thunder = row->thunder;
  return true;
}

std::optional<GallerySet> parseGallerySet(const JsonText& source,
                                          const std::vector<std::string>& profiles,
                                          const std::vector<std::string>& known,
                                          Diagnostics& diagnostics) {
  Diagnostics found;
  GallerySet set;
  set.name = source.file;
  if (const auto root = parseLocatedJson(source, found)) SetReader(source, profiles, known, found).read(*root, set);
  const bool good = !hasErrors(found);
  for (Diagnostic& diagnostic : found) {
    diagnostic.id = "gallery-set";
    diagnostics.push_back(std::move(diagnostic));
  }
  return good ? std::optional(std::move(set)) : std::nullopt;
}

}  // namespace orris
