#include <orris/trace/export/gltf_scene.h>

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

#include <orris/core/add_diagnostic.h>
#include <orris/image/encode_png.h>
#include <orris/plan/frame/frame_state.h>
#include <orris/trace/export/export_mesh.h>
#include <orris/trace/export/gltf_buffer.h>

namespace orris {
namespace {

using Json = nlohmann::json;

constexpr float kGltfPi = std::numbers::pi_v<float>;
constexpr int kGltfNearest = 9728, kGltfClamp = 33071;
constexpr int kSkyColumns = 64, kSkyRows = 180;
// Offsets of a binary file have 32 bits; the rest is for JSON, picture and sky.
constexpr std::size_t kMostQuads = (std::size_t(4) << 30) / 200;

Json jsonOf(const glm::vec3& v) { return {v.x, v.y, v.z}; }

float largest(const glm::vec3& v) { return std::max(v.x, std::max(v.y, v.z)); }

/// Linear light as a 16 bit value of an sRGB picture.
std::uint16_t srgbWord(float linear) {
  const float value =
      linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
  return std::uint16_t(std::lround(glm::clamp(value, 0.0f, 1.0f) * 65535));
}

// The pack makes textures linear by a power, glTF by the sRGB curve: 8 bits would round dark texels by percents.
Image16 srgbAtlas(const TraceTexture& texture) {
  Image16 image(texture.width, texture.height, 4);
  for (std::size_t i = 0; i < texture.levels[0].size(); ++i) {
    const glm::vec4& texel = texture.levels[0][i];
    for (int c = 0; c < 3; ++c) image.pixels[i * 4 + std::size_t(c)] = srgbWord(texel[c]);
    image.pixels[i * 4 + 3] = std::uint16_t(std::lround(texel.a * 65535));
  }
  return image;
}

glm::quat lookingAlong(const glm::vec3& direction) {
  const glm::vec3 up = std::abs(direction.y) < 0.99f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  return glm::quatLookAt(direction, up);
}

Json jsonOf(const glm::quat& q) { return {q.x, q.y, q.z, q.w}; }

class GltfWriter {
 public:
  explicit GltfWriter(const GltfInput& input) : input_(input), scene_(input.scene) {}

  GltfScene write(const std::string& atlasPng) {
    addAtlas(atlasPng);
    addFaces();
    addLights();
    addCameras();
    addSky();
    return finish();
  }

 private:
  void addAtlas(const std::string& png);
  void addFaces();
  Json materialOf(const ExportMaterial& from) const;
  Json extrasOf(const ExportMaterial& from) const;
  void addLights();
  void addLight(Json light, Json node);
  void addCameras();
  void addSky();
  GltfScene finish();

  const GltfInput& input_;
  const TraceScene& scene_;
  GltfBuffer buffer_;
  Json root_ = Json::object();
  Json nodes_ = Json::array(), lights_ = Json::array(), extras_ = Json::object();
};

void GltfWriter::addAtlas(const std::string& png) {
  const int view = buffer_.addView(png.data(), png.size(), GltfTarget::None);
  root_["images"] = {{{"bufferView", view}, {"mimeType", "image/png"}, {"name", "atlas"}}};
  root_["samplers"] = {
      {{"magFilter", kGltfNearest}, {"minFilter", kGltfNearest}, {"wrapS", kGltfClamp}, {"wrapT", kGltfClamp}}};
  root_["textures"] = {{{"source", 0}, {"sampler", 0}}};
}

Json GltfWriter::extrasOf(const ExportMaterial& from) const {
  Json extras = {{"state", input_.states.at(from.state)}};
  if (from.emission > 0) extras["lightLevel"] = from.emission;
  if (from.radiance != glm::vec3(0)) extras["radiance"] = jsonOf(from.radiance);
  if (from.thin) extras["thin"] = true;
  if (from.water) extras["water"] = true;
  if (from.filters) extras["filter"] = "face";
  const glm::vec3& filter = scene_.stateFilters.at(from.state);
  if (filter != glm::vec3(1)) {
    extras["filter"] = "depth";
    extras["filterColor"] = jsonOf(filter);
  }
  return extras;
}

Json GltfWriter::materialOf(const ExportMaterial& from) const {
  static constexpr const char* kModes[3] = {"OPAQUE", "MASK", "BLEND"};
  Json material = {
      {"name", input_.states.at(from.state)},
      {"pbrMetallicRoughness",
       {{"baseColorTexture", {{"index", 0}}}, {"metallicFactor", 0}, {"roughnessFactor", 1}}},
      {"extensions", {{"KHR_materials_specular", {{"specularFactor", 0}}}}},
      {"alphaMode", kModes[int(from.alpha)]},
      {"doubleSided", from.doubleSided},
      {"extras", {{"orris", extrasOf(from)}}}};
  if (from.alpha == ExportAlpha::Mask) material["alphaCutoff"] = kAlphaTest;
  if (from.emission == 0) return material;
  material["emissiveTexture"] = {{"index", 0}};
  material["emissiveFactor"] = jsonOf(from.emissionTint);
  material["extensions"]["KHR_materials_emissive_strength"] = {
      {"emissiveStrength", scene_.emissionScale.at(from.emission)}};
  return material;
}

void GltfWriter::addFaces() {
  Json primitives = Json::array(), materials = Json::array();
  for (const ExportPart& part : exportParts(scene_)) {
    Json attributes = {{"POSITION", buffer_.add(part.positions, GltfTarget::Vertices)},
                       {"NORMAL", buffer_.add(part.normals, GltfTarget::Vertices)},
                       {"TEXCOORD_0", buffer_.add(part.uvs, GltfTarget::Vertices)}};
    if (!part.tints.empty()) attributes["COLOR_0"] = buffer_.add(part.tints, GltfTarget::Vertices);
    primitives.push_back({{"attributes", attributes},
                          {"indices", buffer_.add(part.indices, GltfTarget::Indices)},
                          {"material", materials.size()}});
    materials.push_back(materialOf(part.material));
  }
  if (primitives.empty()) return;  // the format has no empty lists
  root_["materials"] = std::move(materials);
  root_["meshes"] = {{{"name", "blocks"}, {"primitives", std::move(primitives)}}};
  nodes_.push_back({{"name", "blocks"}, {"mesh", 0}, {"translation", jsonOf(scene_.origin)}});
}

void GltfWriter::addLight(Json light, Json node) {
  node["name"] = light["name"];
  node["extensions"] = {{"KHR_lights_punctual", {{"light", lights_.size()}}}};
  lights_.push_back(std::move(light));
  nodes_.push_back(std::move(node));
}

void GltfWriter::addLights() {
  const glm::vec3 sun = scene_.lighting->lightIrradiance();
  if (largest(sun) > 0) {
    addLight({{"name", "sun or moon"},
              {"type", "directional"},
              {"intensity", largest(sun)},
              {"color", jsonOf(sun / largest(sun))}},
             {{"rotation", jsonOf(lookingAlong(-scene_.lighting->lightDirection()))}});
  }
  for (const LampFace& lamp : scene_.lamps.faces()) {
    const float strength = largest(lamp.radiance);
    if (lamp.radius <= 0 || strength <= 0) continue;
    addLight({{"name", "lamp"},
              {"type", "point"},
              {"intensity", strength * kGltfPi * lamp.radius * lamp.radius},
              {"color", jsonOf(lamp.radiance / strength)},
              {"extras", {{"orris", {{"radius", lamp.radius}}}}}},
             {{"translation", jsonOf(lamp.corner + glm::vec3(scene_.origin))}});
  }
}

void GltfWriter::addCameras() {
  Json cameras = Json::array();
  for (const Camera& camera : input_.cameras) {
    const FrameState frame =
        nextFrameState({.width = 16, .height = 9, .camera = camera}, {}, nullptr);
    nodes_.push_back(
        {{"name", camera.name},
         {"camera", cameras.size()},
         {"translation", {camera.position.x, camera.position.y, camera.position.z}},
         {"rotation", jsonOf(glm::quat_cast(glm::mat3(frame.gbufferModelViewInverse)))}});
    cameras.push_back({{"name", camera.name},
                       {"type", "perspective"},
                       {"perspective", {{"yfov", glm::radians(camera.fov)}, {"znear", 0.05}}}});
  }
  if (!cameras.empty()) root_["cameras"] = std::move(cameras);
}

// No extension for an environment is ratified; numbers in the buffer keep its range.
void GltfWriter::addSky() {
  std::vector<glm::vec3> radiance;
  for (int row = 0; row < kSkyRows; ++row) {
    const float polar = (float(row) + 0.5f) / kSkyRows * kGltfPi;
    for (int column = 0; column < kSkyColumns; ++column) {
      const float around = (float(column) + 0.5f) / kSkyColumns * 2 * kGltfPi;
      radiance.push_back(scene_.lighting->skyRadiance({std::sin(polar) * std::cos(around),
                                                       std::cos(polar),
                                                       std::sin(polar) * std::sin(around)}));
    }
  }
  extras_["sky"] = {{"accessor", buffer_.add(radiance, GltfTarget::None)},
                    {"columns", kSkyColumns},
                    {"rows", kSkyRows}};
}

GltfScene GltfWriter::finish() {
  root_["asset"] = {{"version", "2.0"}, {"generator", "orris"}};
  Json used = {"KHR_materials_emissive_strength", "KHR_materials_specular"};
  if (!lights_.empty()) {
    used.push_back("KHR_lights_punctual");
    root_["extensions"] = {{"KHR_lights_punctual", {{"lights", std::move(lights_)}}}};
  }
  root_["extensionsUsed"] = std::move(used);
  Json indices = Json::array();
  for (std::size_t i = 0; i < nodes_.size(); ++i) indices.push_back(i);
  root_["scenes"] = {{{"name", input_.name}, {"extras", {{"orris", extras_}}}}};
  if (!nodes_.empty()) {
    root_["scenes"][0]["nodes"] = std::move(indices);
    root_["nodes"] = std::move(nodes_);
  }
  root_["scene"] = 0;
  root_["buffers"] = {{{"byteLength", buffer_.bytes.size()}}};
  root_["bufferViews"] = std::move(buffer_.views);
  root_["accessors"] = std::move(buffer_.accessors);
  // A name that is no UTF-8 is still a name.
  return {root_.dump(-1, ' ', false, Json::error_handler_t::replace), std::move(buffer_.bytes)};
}

}  // namespace

std::optional<GltfScene> makeGltf(const GltfInput& input, const std::string& file,
                                  Diagnostics& diagnostics) {
  if (input.scene.grid.quads().size() > kMostQuads) {
    addError(diagnostics, "export-size", {file},
             "the world has more faces than a glTF file can hold: " +
                 std::to_string(input.scene.grid.quads().size()) + ", at most " +
                 std::to_string(kMostQuads),
             "export a part of it: --at and --radius");
    return std::nullopt;
  }
  const auto png = encodePng(srgbAtlas(input.scene.grid.texture()), file, diagnostics);
  if (!png) return std::nullopt;
  return GltfWriter(input).write(*png);
}

}  // namespace orris
