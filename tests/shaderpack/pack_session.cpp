#include "pack_session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <regex>
#include <stdexcept>

#include <orris/world/files/world_json.h>

namespace orris::test {
namespace {

void expectClean(Diagnostics& diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics) ADD_FAILURE() << formatDiagnostic(diagnostic);
  diagnostics.clear();
}

/// One context for all sessions, and each program built once.
struct Shared {
  std::unique_ptr<gl::Context> context;
  std::shared_ptr<ProgramPool> pool = std::make_shared<ProgramPool>();
};

Shared& shared() {
  static Shared it = [] {
    Diagnostics diagnostics;
    Shared made{gl::createContext({}, diagnostics)};
    expectClean(diagnostics);
    return made;
  }();
  return it;
}

World parseWorld(const std::string& text) {
  Diagnostics diagnostics;
  std::optional<World> world = parseWorldJson({.text = text, .file = "world.json"}, diagnostics);
  expectClean(diagnostics);
  return world.value_or(World{});
}

std::shared_ptr<const FileSource> openReferencePack(const std::function<void(PackTexts&)>& change,
                                                    Diagnostics& problems) {
  const char* const other = std::getenv("ORRIS_REFERENCE_PACK");
  std::shared_ptr<const FileSource> pack =
      openPack(other ? other : ORRIS_SOURCE_DIR "/shaderpack", problems);
  if (!pack || !change) return pack;
  PackTexts files;
  for (const std::string& path : pack->files()) files[path] = pack->read(path).value_or("");
  change(files);
  return memorySource(std::move(files));
}

}  // namespace

void edit(std::string& text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from;
  ASSERT_EQ(text.find(from, at + 1), std::string::npos) << from;
  text.replace(at, from.size(), to);
}

void setSamples(PackTexts& files, const std::string& value) {
  edit(files["/program/gi/rays.glsl"], "vec4(min(dithered_half(radiance, next_random().x), vec3(65504.0)), 1.0)", value);
}

void setDefault(PackTexts& files, const std::string& option, const std::string& value) {
  std::string& text = files["/settings.glsl"];
  const std::regex line("(#define " + option + ") [^ ]+");
  ASSERT_TRUE(std::regex_search(text, line)) << option;
  text = std::regex_replace(text, line, "$1 " + value);
}

std::array<float, 4> CellField::at(glm::ivec3 cell) const {
  const int x = cell.y % layout_.columns * layout_.volume + cell.x;
  const int y = cell.y / layout_.columns * layout_.volume + cell.z;
  const float* texel = atlas_.at(x, atlas_.height - 1 - y);  // images have their top row first
  std::array<float, 4> channels{};
  for (int i = 0; i < atlas_.channels && i < 4; ++i) channels[i] = texel[i];
  return channels;
}

CellField CellField::ofSlices(const ImageF& slices, AtlasLayout layout, int height,
                              const std::function<glm::ivec3(glm::ivec3)>& texelOf) {
  const int n = layout.volume, rows = (n + layout.columns - 1) / layout.columns;
  ImageF atlas(n * layout.columns, n * rows, slices.channels);
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) {
        const glm::ivec3 texel = texelOf({x, y, z});
        std::copy_n(
            slices.at(texel.x, slices.height - 1 - (texel.z * height + texel.y)), slices.channels,
            atlas.at(y % layout.columns * n + x, atlas.height - 1 - (y / layout.columns * n + z)));
      }
  return {std::move(atlas), layout};
}

int CellField::countLit() const {
  int lit = 0;
  for (size_t i = 0; i < atlas_.pixels.size(); i += atlas_.channels) lit += atlas_.pixels[i] != 0;
  return lit;
}

float CellField::brightest() const {
  float largest = 0;
  for (size_t i = 0; i < atlas_.pixels.size(); i += atlas_.channels)
    largest = std::max(largest, atlas_.pixels[i]);
  return largest;
}

PackSession::PackSession(World world, const SessionSetup& setup, std::size_t camera)
    : options_(setup.options) {
  // What AtlasLayout says, whatever the world's size.
  options_.emplace("VOXEL_SIZE", "64");
  // To the reference water is flat, and tests read radiance.
  for (const char* option : {"WATER_WAVES", "AUTO_EXPOSURE"}) options_.emplace(option, "false");
  Diagnostics diagnostics;
  SessionRequest request;
  request.openPack = [change = setup.change](Diagnostics& problems) {
    return openReferencePack(change, problems);
  };
  request.load.values = options_;
  request.renderer.width = setup.width;
  request.renderer.height = setup.height;
  request.renderer.pool = shared().pool;
  request.camera = world.cameras.at(camera);
  session_ =
      RenderSession::create(*shared().context, std::move(request), std::move(world), diagnostics);
  expectClean(diagnostics);
  // Ends the test, whose next line would ask it for pictures.
  if (!session_) throw std::runtime_error("the pack does not start");
}

PackSession::PackSession(const SessionSetup& setup) : PackSession(parseWorld(setup.world), setup) {}

PackSession PackSession::ofWorld(const std::string& name, const OptionValues& options, int width,
                                 int height, std::size_t camera) {
  Diagnostics diagnostics;
  std::optional<World> world = loadWorld(ORRIS_SOURCE_DIR "/worlds/" + name, 0, diagnostics);
  expectClean(diagnostics);
  return PackSession(std::move(world).value(), {"", options, width, height, {}}, camera);
}

void PackSession::look(glm::dvec3 from, glm::dvec3 to) {
  const glm::dvec3 direction = to - from;
  Camera camera;
  camera.name = "test";
  camera.position = from;
  camera.yaw = static_cast<float>(glm::degrees(std::atan2(-direction.x, direction.z)));
  camera.pitch = static_cast<float>(
      glm::degrees(std::atan2(-direction.y, std::hypot(direction.x, direction.z))));
  camera.fov = 8;
  session_->setCamera(camera);
}

glm::dvec3 PackSession::meanRadiance() {
  const ImageF image = dump("colortex0");
  glm::dvec3 sum(0);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      sum += glm::dvec3(image.at(x, y)[0], image.at(x, y)[1], image.at(x, y)[2]);
  return sum / static_cast<double>(image.width * image.height);
}

void PackSession::renderFrames(int count) {
  Diagnostics diagnostics;
  for (int i = 0; i < count; ++i) session_->renderFrame(diagnostics);
  frames_ += count;
  expectClean(diagnostics);
  for (const std::string& error : shared().context->takeErrors()) ADD_FAILURE() << error;
}

namespace {

/// Sizes of the image flood_light (include/floodfill/flood_image.glsl).
struct FloodImage {
  int width, height, slices;
  explicit FloodImage(int volume) : width(volume + 8), height(volume + 4), slices(2 * volume) {}
};

/// Light from the codes of I^gamma.
ImageF decodedLight(const std::vector<std::uint32_t>& words, const FloodImage& size, float gamma) {
  ImageF light(size.width, size.height * size.slices, 3);
  for (int row = 0; row < light.height; ++row)
    for (int x = 0; x < size.width; ++x) {
      const std::uint32_t* texel = &words.at((size_t(row) * size.width + x) * 2);
      const std::uint32_t codes[] = {texel[0] & 0xFFFF, texel[0] >> 16, texel[1] & 0xFFFF};
      for (int i = 0; i < 3; ++i) {
        const float power =
            std::ldexp(1 + (codes[i] & 511) / 512.0f, static_cast<int>(codes[i] >> 9) - 64);
        light.at(x, light.height - 1 - row)[i] =
            codes[i] == 0 ? 0 : 65504 * std::pow(std::ldexp(power, -63), 1 / gamma);
      }
    }
  return light;
}

}  // namespace

CellField PackSession::light(AtlasLayout layout) {
  std::optional<ImageF> slices = session_->renderer().dump("flood_light");
  if (!slices) return {dump("colortex4"), layout};
  const auto option = [&](const char* name, const char* otherwise) {
    const auto it = options_.find(name);
    return it == options_.end() ? std::string(otherwise) : it->second;
  };
  const int n = layout.volume;
  const FloodImage size(n);
  if (option("FLOODFILL_RULE", "PUBLISHED") != "CONSERVING")
    slices = decodedLight(session_->renderer().dumpWords("flood_light"), size,
                          std::stof(option("FLOODFILL_GAMMA", "2.2")));
  const glm::ivec3 origin = glm::ivec3(glm::floor(session_->camera().position)) - n / 2;
  const int step = (frames_ - 1) / std::stoi(option("FLOODFILL_INTERVAL", "3")) + 1;
  return CellField::ofSlices(*slices, layout, size.height, [&](glm::ivec3 cell) {
    const glm::ivec3 place = ((origin + cell) % n + n) % n;
    return place + glm::ivec3(0, 0, step % 2 * n);
  });
}

ImageF PackSession::dump(const std::string& buffer) {
  std::optional<ImageF> image = session_->renderer().dump(buffer);
  EXPECT_TRUE(image) << buffer << " does not exist";
  return image.value_or(ImageF(1, 1, 4));
}

glm::ivec3 cellOf(glm::ivec3 block, glm::ivec3 eye, int volume) { return block - eye + volume / 2; }

}  // namespace orris::test
