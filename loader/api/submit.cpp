// Batches, ids and facts for an engine's own geometry through the C interface.
#include <cmath>
#include <cstring>

#include <orris/api/renderer.h>
#include <orris/gl/functions.h>
#include <orris/plan/schedule/program_uses.h>

namespace orris::api {
namespace {

[[noreturn]] void refuseBatch(const std::string& text) {
  fail(ORRIS_ERROR_ARGUMENT, "batch->" + text);
}

SubmittedGeometry& submittedOf(OrrisRenderer& renderer) {
  if (!renderer.geometry)
    fail(ORRIS_ERROR_ORDER,
         "the renderer draws a world of Orris: make one whose request has no world");
  return *renderer.geometry;
}

/// Bytes of a buffer.
std::uint64_t sizeOf(std::uint32_t buffer, const char* name) {
  if (gl::IsBuffer(buffer) == GL_FALSE)
    refuseBatch(std::string(name) + " " + std::to_string(buffer) +
                " is no buffer of the current context");
  GLint64 bytes = 0;
  gl::GetNamedBufferParameteri64v(buffer, GL_BUFFER_SIZE, &bytes);
  return static_cast<std::uint64_t>(bytes);
}

void checkRange(const char* name, std::uint64_t offset, std::uint64_t bytes, std::uint64_t size) {
  if (offset > size || bytes > size - offset)
    refuseBatch(std::string(name) + " has " + std::to_string(size) + " bytes, and " +
                std::to_string(bytes) + " from " + std::to_string(offset) + " are asked for");
}

void checkIndices(const OrrisBatch& batch) {
  if (batch.primitive != ORRIS_TRIANGLES) refuseBatch("index_buffer: quads have none");
  if (batch.index_bytes != 2 && batch.index_bytes != 4) refuseBatch("index_bytes must be 2 or 4");
  checkRange("index_buffer", batch.index_offset, std::uint64_t{batch.count} * batch.index_bytes,
             sizeOf(batch.index_buffer, "index_buffer"));
}

void checkBuffers(const OrrisBatch& batch) {
  const std::uint64_t size = sizeOf(batch.vertex_buffer, "vertex_buffer");
  if (batch.stride < sizeof(OrrisVertex) || batch.stride > 2048)
    refuseBatch("stride must be 56 to 2048");
  const std::uint32_t corners = batch.primitive == ORRIS_QUADS ? 4 : 3;
  if (batch.count % corners != 0 || batch.count > 1u << 28)
    refuseBatch("count must be a multiple of " + std::to_string(corners) + ", 2^28 at most");
  if (batch.index_buffer != 0) return checkIndices(batch);
  if (batch.count == 0) return;
  const std::uint64_t last = std::uint64_t{batch.first} + batch.count - 1;
  checkRange("vertex_buffer", batch.offset, last * batch.stride + sizeof(OrrisVertex), size);
}

/// Size of the albedo texture; 0 where there is none.
glm::ivec2 checkTextures(const OrrisTextures& textures) {
  for (const std::uint32_t name : {textures.albedo, textures.normals, textures.specular}) {
    // One of another target is a GL error when it is bound: Mesa does not say which target it has.
    if (name != 0 && gl::IsTexture(name) == GL_FALSE)
      refuseBatch("textures: " + std::to_string(name) + " is no texture of the current context");
  }
  glm::ivec2 size(0);
  if (textures.albedo == 0) return size;
  gl::GetTextureLevelParameteriv(textures.albedo, 0, GL_TEXTURE_WIDTH, &size.x);
  gl::GetTextureLevelParameteriv(textures.albedo, 0, GL_TEXTURE_HEIGHT, &size.y);
  return size;
}

void checkNumbers(const OrrisBatch& batch) {
  if (batch.primitive != ORRIS_QUADS && batch.primitive != ORRIS_TRIANGLES)
    refuseBatch("primitive is no OrrisPrimitive");
  if (batch.passes == 0 || batch.passes > 3)
    refuseBatch("passes must be one or both of ORRIS_PASS_*");
  for (const double value : batch.origin)
    if (!std::isfinite(value)) refuseBatch("origin must be finite");
  for (const float value : batch.entity_color)
    if (!std::isfinite(value)) refuseBatch("entity_color must be finite");
}

int idIn(const std::map<std::string, int>& ids, const char* name, int none) {
  refuseNull(name, "name");
  const auto found = ids.find(name);
  return found == ids.end() ? none : found->second;
}

}  // namespace

Submitted checkedForDraw(const OrrisBatch& batch) {
  checkNumbers(batch);
  return {batch, checkTextures(batch.textures)};
}

}  // namespace orris::api

using namespace orris::api;

void orris_batch_init(OrrisBatch* batch, size_t size) {
  if (batch == nullptr) return;
  OrrisBatch defaults;
  std::memset(&defaults, 0, sizeof(defaults));
  defaults.passes = ORRIS_PASS_CAMERA | ORRIS_PASS_SHADOW;
  defaults.stride = sizeof(OrrisVertex);
  defaults.item = defaults.block_entity = -1;
  initialise(batch, size, &defaults, sizeof(defaults));
}

OrrisStatus orris_renderer_submit(OrrisRenderer* handle, const OrrisBatch* given) {
  return guarded([&] {
    OrrisRenderer& renderer = live(handle);
    SubmittedGeometry& geometry = submittedOf(renderer);
    const OrrisBatch& batch = sized(given, "batch");
    const auto kind = geometryOf(batch.kind);
    if (!kind) refuseBatch("kind is no OrrisKind");
    // Only asks, so that there is no state to keep.
    makeCurrent(*renderer.context);
    const Submitted submitted = checkedForDraw(batch);
    checkBuffers(batch);
    if (batch.count != 0) geometry.add(*kind, submitted);
  });
}

OrrisStatus orris_renderer_set_draw_callback(OrrisRenderer* handle, uint32_t kinds,
                                             OrrisDrawCallback callback, void* user) {
  return guarded(
      [&] { submittedOf(live(handle)).setCallback(geometrySetOf(kinds), callback, user); });
}

OrrisStatus orris_renderer_pack_facts(OrrisRenderer* handle, OrrisPackFacts* facts) {
  return guarded([&] {
    OrrisRenderer& renderer = live(handle);
    sized(facts, "facts");
    const orris::FrameRenderer& frames = renderer.session->renderer();
    const orris::ShaderPack& pack = frames.pack();
    facts->separate_ao = pack.properties.flag("separateAo", false) ? 1 : 0;
    facts->old_lighting = pack.properties.flag("oldLighting", false) ? 1 : 0;
    facts->ambient_occlusion = pack.directives.ambientOcclusionLevel;
    facts->reads_normals = facts->reads_specular = 0;
    for (std::size_t i = 0; i < pack.programs.size(); ++i) {
      const orris::ProgramUses uses = orris::usesOf(pack.programs[i]);
      if (uses.contains("normals")) facts->reads_normals = 1;
      if (uses.contains("specular")) facts->reads_specular = 1;
    }
    facts->casts_shadows = frames.schedule().shadowResolution > 0 ? 1 : 0;
    facts->generation = static_cast<uint32_t>(renderer.session->reloads().size());
  });
}

OrrisStatus orris_renderer_block_id(OrrisRenderer* handle, const char* state, int32_t* out) {
  return guarded([&] {
    const OrrisRenderer& renderer = live(handle);
    refuseNull(state, "state");
    refuseNull(out, "out");
    const auto block = orris::parseBlockState(state);
    if (!block)
      fail(ORRIS_ERROR_ARGUMENT,
           std::string("\"") + state + "\" is no block state, as minecraft:oak_log[axis=y]");
    *out = renderer.session->asked().blockIds.idOf(block->name, block->properties);
  });
}

OrrisStatus orris_renderer_entity_id(OrrisRenderer* handle, const char* name, int32_t* out) {
  return guarded([&] {
    const auto& ids = live(handle).session->asked().entityIds;
    refuseNull(out, "out");
    *out = idIn(ids, name, ids.empty() ? 0 : orris::kUnlistedEntity);
  });
}

OrrisStatus orris_renderer_item_id(OrrisRenderer* handle, const char* name, int32_t* out) {
  return guarded([&] {
    const auto& ids = live(handle).session->asked().itemIds;
    refuseNull(out, "out");
    *out = idIn(ids, name, -1);
  });
}
