// Geometry that an engine submits through the C interface: batches of the next frame, and a callback.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <orris/orris.h>
#include <orris/render/scene/engine_geometry.h>

/// A pass during its callback.
struct OrrisDraw {
  static constexpr const char* kKind = "OrrisDraw";
  orris::EnginePass& pass;
};

namespace orris::api {

/// nullopt for no OrrisKind.
std::optional<Geometry> geometryOf(OrrisKind kind);
OrrisKind kindOf(Geometry geometry);
/// Of bits ORRIS_KIND_BIT(); fails where one is of no kind.
GeometrySet geometrySetOf(std::uint32_t kinds);

/// A batch and the size of its albedo texture.
struct Submitted {
  OrrisBatch batch;
  glm::ivec2 textureSize{0};
};

/// What of a batch is not its vertices.
void beginDraw(EnginePass& pass, const Submitted& submitted);

class SubmittedGeometry final : public EngineGeometry {
 public:
  explicit SubmittedGeometry(GeometrySet kinds) : kinds_(kinds) {}

  /// Every kind that there was so far.
  GeometrySet kinds() const override { return kinds_; }
  void draw(EnginePass& pass) override;

  void add(Geometry geometry, const Submitted& submitted);
  void setCallback(GeometrySet kinds, OrrisDrawCallback callback, void* user);
  /// After a frame.
  void useUp();

 private:
  void drawBatches(EnginePass& pass) const;
  void callBack(EnginePass& pass) const;

  std::array<std::vector<Submitted>, 32> batches_;  ///< by Geometry
  GeometrySet kinds_, callbackKinds_ = 0;
  OrrisDrawCallback callback_ = nullptr;
  void* user_ = nullptr;
};

}  // namespace orris::api
