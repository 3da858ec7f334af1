#include <orris/render/scene/gpu_scene.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <orris/core/parallel.h>
#include <orris/gl/clear_stack.h>
#include <orris/gl/functions.h>
#include <orris/plan/scene/shapes.h>
#include <orris/plan/scene/snow_sheet.h>
#include <orris/plan/scene/vertex_packer.h>
#include <orris/world/atlas/atlas_levels.h>
#include <orris/world/dimension_look.h>

namespace orris {
namespace {

gl::Texture uploadImage(const Image8& image, int levels, const std::string& label) {
  gl::Texture texture =
      gl::createTexture(2, *findFormat("RGBA8"), image.width, image.height, 1, levels, label);
  gl::upload(texture, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
  return texture;
}

// Box-filtered levels: tiles are powers of two, so no tile bleeds into another.
gl::Texture uploadColors(const Image8& image, const std::string& label) {
  gl::Texture texture = uploadImage(image, kAtlasLevels, label);
  const std::vector<Image8> levels = atlasLevels(image, kAtlasLevels);
  for (std::size_t i = 1; i < levels.size(); ++i)
    gl::TextureSubImage2D(texture.id(), GLint(i), 0, 0, levels[i].width, levels[i].height, GL_RGBA,
                          GL_UNSIGNED_BYTE, levels[i].pixels.data());
  gl::setParameters(texture, {.linear = false, .repeat = false, .mipmaps = true});
  return texture;
}

// The same for data, as they are stored.
gl::Texture uploadData(const Image8& image, const std::string& label) {
  gl::Texture texture = uploadImage(image, kAtlasLevels, label);
  gl::generateMipmaps(texture);
  gl::setParameters(texture, {.linear = false, .repeat = false, .mipmaps = true});
  return texture;
}

// Mesa's software rasteriser takes less than four gigabytes; a driver that keeps its memory in pieces
// finds a place for one.
constexpr std::size_t kMostPartBytes = std::size_t(1) << 30;

/// Calls `write` with the driver's memory of the buffer, which any threads may write; what was in it is lost.
template <class Write>
void fillInPlace(const gl::Buffer& buffer, const Write& write) {
  void* memory = gl::MapNamedBufferRange(buffer.id(), 0, GLsizeiptr(buffer.size),
                                         GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
  if (memory == nullptr) return;  // the driver has said why
  write(static_cast<GpuVertex*>(memory));
  gl::UnmapNamedBuffer(buffer.id());
}

void appendQuad(std::uint32_t first, std::vector<std::uint32_t>& indices) {
  for (const std::uint32_t corner : {0u, 1u, 2u, 2u, 3u, 0u}) indices.push_back(first + corner);
}

// The game's brightness curve of a light level 0..15; `ambient` is where it begins.
float levelBrightness(int level, float ambient) {
  const float f = static_cast<float>(level) / 15;
  return glm::mix(f / (4 - 3 * f), 1.0f, ambient);
}

// The game: LightTexture. The End is never dark.
glm::vec3 brightened(glm::vec3 color, const Environment& environment) {
  constexpr glm::vec3 kEnd(0.99f, 1.12f, 1.0f);
  constexpr float kShare = 0.25f;
  return environment.dimension == "minecraft:the_end" ? glm::mix(color, kEnd, kShare) : color;
}

}  // namespace

GpuScene::GpuScene(const SceneData& scene, const std::vector<int>& blockIds,
                   const VertexStyle& style) {
  atlas_ = uploadColors(scene.atlas.albedo, "atlas");
  normals_ = uploadData(scene.atlas.normal, "normals");
  specular_ = uploadData(scene.atlas.specular, "specular");
  animated_ = AnimatedTiles(scene.atlas.animations);
  lightmap_ = gl::createTexture(2, *findFormat("RGBA8"), 16, 16, 1, 1, "lightmap");
  Image8 white(1, 1, 4);
  std::fill(white.pixels.begin(), white.pixels.end(), std::uint8_t{255});
  white_ = uploadImage(white, 1, "white");
  celestial_ = uploadImage(celestialImage(), 1, "celestial");
  gl::setParameters(celestial_, {.linear = false});
  if (scene.contents().endSky) endSky_ = uploadImage(endSkyImage(), 1, "sky of the End");
  buildShapes();
  buildContent(scene.content, scene.contents().content);
  uploadMesh(scene, blockIds, style);
}

void GpuScene::buildContent(const ContentScene& content, GeometrySet kinds) {
  struct NamedSheet {
    Sheet sheet;
    Geometry geometry;
    const char* texture;
  };
  constexpr NamedSheet kSheets[] = {{Sheet::Glint, Geometry::Glint, "glint"},
                                    {Sheet::Glint, Geometry::HandGlint, "glint"},
                                    {Sheet::Rain, Geometry::Rain, "rain"},
                                    {Sheet::Beam, Geometry::BeamCore, "beacon_beam"},
                                    {Sheet::Border, Geometry::Border, "world_border"}};
  for (const NamedSheet& row : kSheets)
    if ((kinds & bitOf(row.geometry)) != 0)
      sheets_[row.sheet] = uploadImage(textureImage(row.texture), 1, row.texture);
  if ((kinds & bitOf(Geometry::Snow)) != 0) sheets_[Sheet::Snow] = uploadImage(snowSheet(), 1, "snow");
  if (kinds == 0) return;
  // What has no such maps, as lines, reads these: flat and rough.
  const bool own = content.atlas.albedo.width > 0;
  const BlockAtlas& atlas = own ? content.atlas : buildAtlas({});
  contentAtlas_ = uploadColors(atlas.albedo, "content atlas");
  contentNormals_ = uploadData(atlas.normal, "content normals");
  contentSpecular_ = uploadData(atlas.specular, "content specular");
  animatedContent_ = AnimatedTiles(atlas.animations);
}

const gl::Texture& GpuScene::sheet(Sheet sheet) const {
  if (sheet == Sheet::Content) return contentAtlas_;
  const auto found = sheets_.find(sheet);
  return found == sheets_.end() ? white_ : found->second;
}

void GpuScene::uploadLists(const DrawLists& lists) {
  lists_ = gl::createBuffer(lists.vertices.size() * sizeof(GpuVertex), lists.vertices.data(),
                            "draw lists");
  for (const ContentDraw& draw : lists.draws) needIndices(draw.range.quads);
}

void GpuScene::buildShapes() {
  ShapeList shapes;
  shapes.quad({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}}, kUnitUv);
  fullscreen = shapes.since(0);
  horizon = addHorizon(shapes);
  skyDisc = addSkyDisc(shapes);
  stars = addStars(shapes);
  sun = addCelestialQuad(shapes, 100, 30, 0);
  moon = addCelestialQuad(shapes, -100, 20, 0.5f);
  endCube = addEndCube(shapes);
  shapes_ = gl::createBuffer(shapes.vertices.size() * sizeof(GpuVertex), shapes.vertices.data(),
                             "shapes");
}

const CloudLayer& GpuScene::clouds(bool fancy) {
  if (clouds_ && clouds_->fancy == fancy) return *clouds_;
  const CloudMesh mesh = buildClouds(fancy);
  clouds_ = {
      fancy, mesh.parts,
      gl::createBuffer(mesh.vertices.size() * sizeof(GpuVertex), mesh.vertices.data(), "clouds")};
  for (const CloudPart& part : mesh.parts) needIndices(part.range.quads);
  return *clouds_;
}

void GpuScene::needIndices(unsigned quads) {
  if (quads <= indexedQuads_) return;
  indexedQuads_ = quads;
  std::vector<std::uint32_t> indices;
  indices.reserve(size_t{quads} * 6);
  for (std::uint32_t i = 0; i < quads; ++i) appendQuad(i * 4, indices);
  indices_ =
      gl::createBuffer(indices.size() * sizeof(std::uint32_t), indices.data(), "quad indices");
}

void GpuScene::uploadMesh(const SceneData& scene, const std::vector<int>& blockIds,
                          const VertexStyle& style) {
  sections_ = scene.mesh.sections;
  grid_ = scene.mesh.grid;
  seenFor_.reset();
  parts_ = terrainParts(sections_, kMostPartBytes / sizeof(GpuVertex));
  terrain_.clear();
  const VertexPacker packer(scene.mesh, blockIds, style);
  // Into the driver's memory: a copy of all vertices would be hundreds of megabytes for a save.
  for (std::size_t first = 0, index = 0; index < parts_.size(); ++index) {
    const TerrainPart& part = parts_[index];
    std::size_t end = first;
    while (end < sections_.size() && terrainPart(sections_[end]) == index) ++end;
    terrain_.push_back(gl::createUnfilledBuffer(std::max(1u, part.count) * sizeof(GpuVertex), "terrain"));
    fillInPlace(terrain_.back(), [&](GpuVertex* vertices) {
      forEachInParallel(end - first, [&](std::size_t i) {
        const MeshSection& section = sections_[first + i];
        packer.pack(section, vertices + (section.first - part.first));
      });
    });
    first = end;
  }
  blockIds_ = blockIds;
  emits_.clear();
  for (const BlockFacts& facts : scene.facts) emits_.push_back(facts.emission > 0);
  unsigned most = stars.quads;
  for (const MeshSection& section : sections_) most = std::max(most, section.count / 4);
  needIndices(most);
  collectTranslucent(scene.mesh);
}

// Sections come sorted by layer, so the translucent vertices are one run at the end.
void GpuScene::collectTranslucent(const BlockMesh& mesh) {
  sortedFor_.reset();
  translucentCenters_.clear();
  const auto first = std::find_if(sections_.begin(), sections_.end(), [](const MeshSection& s) {
    return s.layer == RenderLayer::Translucent;
  });
  if (first == sections_.end()) return;
  firstTranslucent_ = first->first;
  for (size_t v = firstTranslucent_; v < mesh.vertexCount(); v += 4) {
    const std::array<BlockVertex, 4> quad = mesh.quad(v);
    translucentCenters_.push_back((quad[0].position + quad[2].position) * 0.5f);
  }
}

void GpuScene::sortTranslucent(const glm::dvec3& eye) {
  if (translucentCenters_.empty() || sortedFor_ == eye) return;
  sortedFor_ = eye;
  std::vector<std::uint32_t> indices;
  indices.reserve(translucentCenters_.size() * 6);
  for (const MeshSection& section : sections_) {
    if (section.layer != RenderLayer::Translucent) continue;
    const glm::vec3 local(eye - glm::dvec3(section.origin));
    std::vector<std::pair<float, std::uint32_t>> quads;
    for (std::uint32_t v = section.first; v < section.first + section.count; v += 4) {
      const glm::vec3 d = translucentCenters_[(v - firstTranslucent_) / 4] - local;
      quads.emplace_back(-glm::dot(d, d), v);
    }
    std::sort(quads.begin(), quads.end());
    const std::uint32_t start = parts_[terrainPart(section)].first;
    for (const auto& [distance, v] : quads) appendQuad(v - start, indices);
  }
  sortedIndices_ =
      gl::createBuffer(indices.size() * sizeof(std::uint32_t), indices.data(), "sorted quads");
}

void GpuScene::drawSorted(const MeshSection& section, bool patches) const {
  gl::BindBuffer(GL_ELEMENT_ARRAY_BUFFER, sortedIndices_.id());
  if (patches) gl::PatchParameteri(GL_PATCH_VERTICES, 3);
  const size_t offset = size_t{section.first - firstTranslucent_} / 4 * 6 * sizeof(std::uint32_t);
  gl::clearStack();
  gl::DrawElements(patches ? GL_PATCHES : GL_TRIANGLES, static_cast<int>(section.count / 4 * 6),
                   GL_UNSIGNED_INT, reinterpret_cast<const void*>(offset));
}

void GpuScene::drawSection(const MeshSection& section, bool patches) const {
  drawQuads({section.first - parts_[terrainPart(section)].first, section.count / 4}, patches);
}

void GpuScene::animate(const FrameState& state) {
  const auto seconds = double(state.frameTimeCounter);
  animated_.show(seconds, atlas_, normals_, specular_);
  animatedContent_.show(seconds, contentAtlas_, contentNormals_, contentSpecular_);
}

const VisibleSections& GpuScene::seenFrom(const glm::dvec3& eye) {
  const glm::ivec3 section(glm::floor(eye / 16.0));
  if (seenFor_ != section) seen_ = VisibleSections(grid_, eye);
  seenFor_ = section;
  return seen_;
}

void GpuScene::updateLightmap(const FrameState& state) {
  const float height = std::cos(state.skyAngle * 2 * 3.14159265f) * 2 + 0.5f;
  const float day = std::clamp(height, 0.0f, 1.0f) * 0.95f + 0.05f;
  const float ambient = ambientLightOf(state.environment.dimension);
  std::array<std::uint8_t, 16 * 16 * 4> pixels{};
  for (int sky = 0; sky < 16; ++sky)
    for (int block = 0; block < 16; ++block) {
      const float s = levelBrightness(sky, ambient) * day, b = levelBrightness(block, ambient) * 1.4f;
      // Torches are warm: green and blue fall faster than red, as in the game.
      const glm::vec3 rgb = brightened(
          {b + s, b * ((b * 0.6f + 0.4f) * 0.6f + 0.4f) + s, b * (b * b * 0.6f + 0.4f) + s},
          state.environment);
      for (int c = 0; c < 3; ++c)
        pixels[(sky * 16 + block) * 4 + c] = static_cast<std::uint8_t>(
            std::lround(std::clamp(rgb[c] * 0.96f + 0.03f, 0.0f, 1.0f) * 255));
      pixels[(sky * 16 + block) * 4 + 3] = 255;
    }
  gl::upload(lightmap_, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  gl::setParameters(lightmap_, {.linear = true});
}

void GpuScene::bindTerrain(std::size_t part) const {
  gl::BindBuffer(GL_ARRAY_BUFFER, terrain_[part].id());
  gl::BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
}

void GpuScene::bindLists() const {
  gl::BindBuffer(GL_ARRAY_BUFFER, lists_.id());
  gl::BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
}

void GpuScene::bindIndices() const { gl::BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id()); }

void GpuScene::bindClouds() const {
  gl::BindBuffer(GL_ARRAY_BUFFER, clouds_->buffer.id());
  gl::BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
}

void GpuScene::bindShapes() const {
  gl::BindBuffer(GL_ARRAY_BUFFER, shapes_.id());
  gl::BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
}

void GpuScene::drawQuads(const QuadRange& range, bool patches) const {
  if (patches) gl::PatchParameteri(GL_PATCH_VERTICES, 3);
  gl::clearStack();
  gl::DrawElementsBaseVertex(patches ? GL_PATCHES : GL_TRIANGLES, static_cast<int>(range.quads * 6),
                             GL_UNSIGNED_INT, nullptr, static_cast<int>(range.firstVertex));
}

gl::Texture makeNoiseTexture(int resolution) {
  Image8 image(resolution, resolution, 4);
  for (size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] =
        i % 4 == 3 ? 255 : static_cast<std::uint8_t>(mixBits(static_cast<std::uint32_t>(i)));
  gl::Texture texture = uploadImage(image, 1, "noisetex");
  gl::setParameters(texture, {.linear = true, .repeat = true});
  return texture;
}

}  // namespace orris
