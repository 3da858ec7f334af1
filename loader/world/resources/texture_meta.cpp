#include <orris/world/resources/texture_meta.h>

#include <fmt/core.h>

#include <algorithm>

#include <orris/world/files/json_reader.h>

namespace orris {
namespace {

constexpr IntegerRange kFrameSides{1, 1 << 15}, kFrameNumbers{0, 1 << 15}, kTickRange{1, 1 << 20};

class MetaReader {
 public:
  MetaReader(JsonReader& reader, glm::ivec2 size) : reader_(reader), size_(size) {}

  std::optional<TextureMeta> read(const JsonNode& animation) {
    readFrameSize(animation);
    reader_.optional(animation, "frametime", kTickRange, ticks_);
    reader_.optional(animation, "interpolate", meta_.interpolate);
    const JsonNode* list = animation.find("frames");
    if (list && reader_.array(*list, "\"frames\""))
      for (const JsonNode& node : list->items) readStep(node);
    const int count = (size_.x / meta_.width) * (size_.y / meta_.height);
    if (meta_.steps.empty())
      for (int i = 0; i < count; ++i) meta_.steps.push_back({i, ticks_});
    for (const AnimationStep& step : meta_.steps)
      if (step.frame >= count) return absentFrame(animation, step.frame);
    return meta_.steps.empty() ? absentFrame(animation, 0) : std::optional(meta_);
  }

 private:
  /// The game's: a square unless the file says otherwise.
  void readFrameSize(const JsonNode& animation) {
    const int side = std::min(size_.x, size_.y);
    int width = 0, height = 0;
    reader_.optional(animation, "width", kFrameSides, width);
    reader_.optional(animation, "height", kFrameSides, height);
    meta_.width = width > 0 ? width : height > 0 ? size_.x : side;
    meta_.height = height > 0 ? height : width > 0 ? size_.y : side;
  }

  void readStep(const JsonNode& node) {
    AnimationStep step{0, ticks_};
    const JsonNode* index = node.find("index");
    step.frame = reader_.integer(index ? *index : node, "a frame", kFrameNumbers).value_or(0);
    if (index) reader_.optional(node, "time", kTickRange, step.ticks);
    meta_.steps.push_back(step);
  }

  std::optional<TextureMeta> absentFrame(const JsonNode& animation, int frame) {
    reader_.error(animation.offset,
                  fmt::format("the animation has a frame {} of {}x{} texels, but the texture has {}x{}",
                              frame, meta_.width, meta_.height, size_.x, size_.y));
    return std::nullopt;
  }

  JsonReader& reader_;
  glm::ivec2 size_;
  int ticks_ = 1;
  TextureMeta meta_;
};

}  // namespace

std::optional<TextureMeta> parseTextureMeta(const ResourceFile& file, glm::ivec2 size,
                                            Diagnostics& diagnostics) {
  const JsonText source{file.bytes, file.place, &kResourceJson};
  JsonReader reader(source, diagnostics);
  const auto root = parseLocatedJson(source, diagnostics);
  const JsonNode* animation = root ? root->find("animation") : nullptr;
  if (!animation) return std::nullopt;
  return MetaReader(reader, size).read(*animation);
}

}  // namespace orris
