// The pass graph for programs. docs/pass-graph.schema.json states the form.
#include <nlohmann/json.hpp>

#include <orris/check/graph/pass_graph.h>

namespace orris {
namespace {

using nlohmann::json;

const char* side(bool alt) { return alt ? "alt" : "main"; }

const char* sourceName(GraphRead::Source source) {
  switch (source) {
    case GraphRead::Source::Passes:
      return "passes";
    case GraphRead::Source::History:
      return "history";
    case GraphRead::Source::Clear:
      return "clear";
    case GraphRead::Source::Host:
      break;
  }
  return "host";
}

json toJson(const GraphPass& pass) {
  json reads = json::array(), writes = json::array(), images = json::array(),
       computes = json::array();
  for (const GraphRead& read : pass.reads)
    reads.push_back({{"buffer", read.buffer},
                     {"side", side(read.alt)},
                     {"source", sourceName(read.source)},
                     {"from", read.from},
                     {"mipmaps", read.mipmaps}});
  for (const GraphWrite& write : pass.writes)
    writes.push_back({{"buffer", write.buffer}, {"side", side(write.alt)}, {"slot", write.slot}});
  for (const GraphImage& image : pass.images)
    images.push_back({{"name", image.name},
                      {"buffer", image.buffer},
                      {"side", side(image.alt)},
                      {"loads", image.loads},
                      {"stores", image.stores}});
  for (const GraphCompute& compute : pass.computes)
    computes.push_back({{"name", compute.name},
                        {"localSize", compute.localSize},
                        {"groups", compute.groups},
                        {"indirect", compute.indirect}});
  return {{"name", pass.name},         {"program", pass.title},
          {"group", pass.group},       {"kind", pass.kind},
          {"file", pass.file},         {"drawn", pass.drawn},
          {"width", pass.width},       {"height", pass.height},
          {"scale", pass.scale},       {"reads", reads},
          {"writes", writes},          {"images", images},
          {"textures", pass.textures}, {"flips", pass.flips},
          {"computes", computes}};
}

json toJson(const GraphBuffer& buffer) {
  return {{"name", buffer.name},
          {"format", buffer.format},
          {"width", buffer.width},
          {"height", buffer.height},
          {"clear", buffer.clear},
          {"clearColor", buffer.clearToFog ? json("fog") : json(buffer.clearColor)},
          {"history", buffer.history},
          {"mipmaps", buffer.mipmaps},
          {"twoSides", buffer.twoSides}};
}

json imagesOf(const PassGraph& graph) {
  json images = json::array();
  for (const CustomImage& image : graph.images)
    images.push_back({{"name", image.name},
                      {"sampler", image.sampler},
                      {"format", image.internalFormat},
                      {"size", image.size},
                      {"dimensions", image.dimensions},
                      {"relative", image.relative},
                      {"clear", image.clear}});
  return images;
}

json texturesOf(const PassGraph& graph) {
  json textures = json::array();
  for (const TextureBinding& texture : graph.textures)
    textures.push_back(
        {{"stage", texture.stage}, {"sampler", texture.sampler}, {"path", texture.path}});
  return textures;
}

json bufferObjectsOf(const PassGraph& graph) {
  json objects = json::array();
  for (const BufferObject& object : graph.bufferObjects)
    objects.push_back({{"index", object.index},
                       {"bytes", object.bytes},
                       {"relative", object.relative},
                       {"file", object.file}});
  return objects;
}

}  // namespace

std::string toJsonText(const PassGraph& graph) {
  json passes = json::array(), buffers = json::array();
  for (const GraphPass& pass : graph.passes) passes.push_back(toJson(pass));
  for (const GraphBuffer& buffer : graph.buffers) buffers.push_back(toJson(buffer));
  const json all = {{"version", kPassGraphVersion},
                    {"pack", graph.pack},
                    {"folder", graph.folder},
                    {"profile", graph.profile},
                    {"width", graph.width},
                    {"height", graph.height},
                    {"passes", passes},
                    {"buffers", buffers},
                    {"images", imagesOf(graph)},
                    {"textures", texturesOf(graph)},
                    {"bufferObjects", bufferObjectsOf(graph)},
                    {"disabled", graph.disabled}};
  return all.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

}  // namespace orris
