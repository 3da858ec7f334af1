// The GL state of an engine, kept while Orris draws in its context.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include <orris/gl/handle.h>

namespace orris::gl {

/// What Orris sets is read and set to GL's defaults, and set back when the value dies. The context that
/// was current then must be so again. Not kept: current values of vertex attributes, the current colour
/// and fog of a compatibility context, bindings of shader storage buffers, debug message filters.
class StateGuard {
 public:
  StateGuard();
  ~StateGuard();
  StateGuard(const StateGuard&) = delete;
  StateGuard& operator=(const StateGuard&) = delete;

 private:
  struct Unit {
    std::array<int, 3> textures{};  ///< 1D, 2D, 3D
    int sampler = 0;
  };
  struct Image {
    int name = 0, level = 0, layered = 0, layer = 0, access = 0, format = 0;
  };
  struct Blend {
    int enabled = 0;
    std::array<int, 4> factors{};
    std::array<int, 2> equations{};
    std::array<unsigned char, 4> mask{};
  };
  struct Stencil {
    std::array<int, 7> values{};  ///< function, reference, mask, three operations, write mask
  };
  void saveUnits();
  void saveBlending();
  void saveFixedFunctions();
  void restoreUnits() const;
  void restoreBlending() const;
  void restoreFixedFunctions() const;

  std::vector<std::pair<unsigned, int>> capabilities_, pixelStore_;
  std::vector<int> bindings_;  ///< in the order of a table
  std::vector<Unit> units_;
  std::vector<Image> images_;
  std::vector<Blend> blend_;
  std::array<Stencil, 2> stencil_;
  int activeTexture_ = 0, depthFunction_ = 0, cullFace_ = 0, frontFace_ = 0, patchVertices_ = 3;
  std::array<int, 2> polygonMode_{}, clip_{};
  std::array<int, 4> viewport_{}, scissor_{};
  std::array<float, 2> polygonOffset_{};
  std::array<double, 2> depthRange_{};
  unsigned char depthMask_ = 1;
  int clearStencil_ = 0;
  // Of a compatibility context.
  int matrixMode_ = 0, alphaTest_ = 0, alphaFunction_ = 0, clientTexture_ = 0;
  float alphaReference_ = 0;
  std::vector<std::array<float, 16>>
      matrices_;                           ///< model view, projection, texture of units 0 to 2
  Handle<deleteVertexArray> vertexArray_;  ///< Orris's own, so that the engine's stay as they are
};

}  // namespace orris::gl
