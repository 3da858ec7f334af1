// The frame of a pack as a picture or table: programs in order, what each reads and writes.
// docs/pass-graph.md describes the forms; kPassGraphVersion changes with the JSON form.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <orris/pack/shader_pack.h>
#include <orris/plan/schedule/schedule.h>

namespace orris {

inline constexpr int kPassGraphVersion = 1;

/// A buffer that a pass samples, and where its contents come from.
struct GraphRead {
  enum class Source { Passes, History, Clear, Host };
  std::string buffer;             ///< "colortex3", "depthtex0"
  bool alt = false;               ///< side; buffers without sides: main
  Source source = Source::Host;   ///< History: the last frame; Host: depth
  std::vector<std::string> from;  ///< names of the passes that drew it, in frame order
  bool mipmaps = false;           ///< made right before this pass
};

/// A draw buffer of a pass.
struct GraphWrite {
  std::string buffer;
  bool alt = false;
  int slot = 0;
};

/// An image, of a render target or of image.<name>.
struct GraphImage {
  std::string name;    ///< as the program writes it: "colorimg3"
  std::string buffer;  ///< "colortex3"; "" for a custom image
  bool alt = false;
  bool loads = false, stores = false;
};

struct GraphCompute {
  std::string name;
  std::array<int, 3> localSize{1, 1, 1}, groups{1, 1, 1};
  bool indirect = false;  ///< the group counts come from a buffer object
};

struct GraphPass {
  std::string name, title;  ///< unique in the graph; what people call it
  std::string group;        ///< "setup", "shadow", "gbuffers", "translucent", "deferred", ...
  std::string kind;         ///< "fullscreen", "geometry", "compute", "copy" or "present"
  std::string file;         ///< "/world0/composite.fsh"; "" when built into the host
  bool drawn = true;        ///< false: geometry that is drawn only where a world has it
  int width = 0, height = 0;
  std::array<float, 3> scale{1, 0, 0};
  std::vector<GraphRead> reads;
  std::vector<GraphWrite> writes;
  std::vector<GraphImage> images;
  std::vector<std::string> textures;  ///< custom textures, by sampler
  std::vector<std::string> flips;     ///< buffers that change sides after it
  std::vector<GraphCompute> computes;
};

struct GraphBuffer {
  std::string name, format;
  int width = 0, height = 0;
  bool clear = true, clearToFog = false, history = false, mipmaps = false, twoSides = false;
  std::array<float, 4> clearColor{};
};

struct PassGraph {
  std::string pack, folder, profile;
  int width = 0, height = 0;
  std::vector<GraphPass> passes;
  std::vector<GraphBuffer> buffers;
  std::vector<CustomImage> images;
  std::vector<TextureBinding> textures;
  std::vector<BufferObject> bufferObjects;
  std::vector<std::string> disabled;  ///< programs switched off, as the pack writes them
};

PassGraph passGraph(const ShaderPack& pack, const Schedule& schedule);

std::string toJsonText(const PassGraph& graph);
/// Tables in Markdown: buffers with writers and readers, then programs.
std::string toMarkdown(const PassGraph& graph);
/// Graphviz: a cluster for each group, an edge for each pair of passes with the buffers on it.
std::string toDot(const PassGraph& graph);

}  // namespace orris
