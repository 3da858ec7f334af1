// Geometry that an engine submits in place of a world's blocks and content, drawn while a program of the
// pack, its targets and its uniforms are bound.
#pragma once

#include <glm/glm.hpp>
#include <string_view>

#include <orris/plan/schedule/geometry.h>
#include <orris/render/gpu_program.h>
#include <orris/render/scene/gpu_scene.h>
#include <orris/render/draw/sampler_binder.h>
#include <orris/render/scene/vertex_layout.h>

namespace orris {

/// What one draw of an engine sees besides the frame. Contract: uniforms.csv "draw".
struct EngineIds {
  int entity = 0, item = -1, blockEntity = -1;
  glm::vec4 entityColor{0};
};

/// One step of the frame: a kind of geometry from the camera or from the light.
class EnginePass {
 public:
  /// What the step draws with; all of it outlives the pass.
  struct Parts {
    const Step& step;
    const GpuProgram& program;
    const FrameState& state;
    const CustomUniforms& custom;
    GpuScene& scene;
    SamplerBinder& binder;
    DrawState& draw;
  };
  explicit EnginePass(const Parts& parts) : parts_(parts), view_(parts.draw.modelView) {}

  Geometry geometry() const { return parts_.step.geometry; }
  bool isShadow() const { return parts_.step.kind == Step::Kind::DrawShadow; }
  const std::string& name() const { return parts_.step.name; }
  unsigned program() const { return parts_.program.program.id(); }
  const glm::mat4& view() const { return view_; }
  const glm::mat4& projection() const { return parts_.draw.projection; }
  const glm::dvec3& camera() const { return parts_.state.cameraPosition; }
  bool patches() const { return parts_.program.patches; }
  /// Location of a vertex attribute; -1 where the program does not read it as a generic attribute.
  int attributeLocation(std::string_view name) const;

  /// What follows has its positions relative to `origin`, a place of the world in blocks; those of hands
  /// are in view space and know no origin. Uploads the uniforms that change by draw.
  void begin(const glm::dvec3& origin, const EngineTextures& textures, const EngineIds& ids);
  /// Points the attributes at the bound GL_ARRAY_BUFFER.
  void bindVertices(const VertexPlace& place) const;
  /// Quads of four vertices each, from a vertex of what is bound.
  void drawQuads(unsigned first, unsigned quads) const;
  /// Triangles of so many vertices, or of indices of a type where there is a buffer of them.
  void drawTriangles(unsigned first, unsigned count, unsigned indexBuffer, unsigned indexType,
                     std::size_t indexOffset) const;

 private:
  Parts parts_;
  glm::mat4 view_;
};

class EngineGeometry {
 public:
  virtual ~EngineGeometry() = default;
  /// The kinds that the next frame has; a new one means programs to compile.
  virtual GeometrySet kinds() const = 0;
  virtual void draw(EnginePass& pass) = 0;
};

}  // namespace orris
