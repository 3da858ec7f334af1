// Our pack rendering a small world, frame by frame, with its buffers at hand.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include <orris/gl/context.h>
#include <orris/render/session/render_session.h>

namespace orris::test {

/// Texts by pack path ("/settings.glsl").
using PackTexts = std::map<std::string, std::string>;

/// Replaces what a text holds once; a failure of the test if it does not.
void edit(std::string& text, const std::string& from, const std::string& to);

/// Writes `value`, a vec4, in place of the light that a ray of a pixel has found (colortex14).
void setSamples(PackTexts& files, const std::string& value);

/// Gives an option a value that its list need not hold.
void setDefault(PackTexts& files, const std::string& option, const std::string& value);

struct SessionSetup {
  std::string world;  ///< text of a world.json; its first camera looks
  OptionValues options;
  int width = 32, height = 32;
  std::function<void(PackTexts&)> change;  ///< of the pack's files before they are loaded
};

/// The atlas of include/derived/sizes.glsl: tiles of volume x volume texels, layer y in tile y.
struct AtlasLayout {
  int volume = 64, columns = 16;
};

/// A volume of cells read from its atlas (include/voxels/volume.glsl).
class CellField {
 public:
  CellField(ImageF atlas, AtlasLayout layout) : atlas_(std::move(atlas)), layout_(layout) {}
  /// Of a 3-D image as the renderer dumps it, of slices so high. `texelOf`: where a cell is in it.
  static CellField ofSlices(const ImageF& slices, AtlasLayout layout, int height,
                            const std::function<glm::ivec3(glm::ivec3)>& texelOf);
  /// The four channels of a cell, 0..volume-1 on each axis.
  std::array<float, 4> at(glm::ivec3 cell) const;
  float red(glm::ivec3 cell) const { return at(cell)[0]; }
  float brightest() const;  ///< largest red
  /// Cells whose red is not 0.
  int countLit() const;
  bool operator==(const CellField& other) const { return atlas_.pixels == other.atlas_.pixels; }
  int volume() const { return layout_.volume; }

 private:
  ImageF atlas_;
  AtlasLayout layout_;
};

/// shaderpack/, or the pack that the environment's ORRIS_REFERENCE_PACK names.
class PackSession {
 public:
  explicit PackSession(const SessionSetup& setup);
  /// `world` is the text of a world.json; its first camera looks.
  PackSession(const std::string& world, const OptionValues& options, int width = 32,
              int height = 32)
      : PackSession(SessionSetup{world, options, width, height, {}}) {}
  /// A world of ours by folder name, and the number of its camera.
  static PackSession ofWorld(const std::string& name, const OptionValues& options, int width,
                             int height, std::size_t camera = 0);
  /// Looks from one point to another, with a narrow field of view, from the next frame on.
  void look(glm::dvec3 from, glm::dvec3 to);
  void renderFrames(int count);
  /// With any FLOODFILL_STORAGE; of IMAGE_3D what the lookup makes of it.
  CellField light(AtlasLayout layout = {});
  /// Voxels as stored: red, green, blue, code / 255.
  CellField voxels(AtlasLayout layout = {}) { return {dump("shadowcolor0"), layout}; }
  ImageF dump(const std::string& buffer);
  /// Mean of the lit scene, colortex0.
  glm::dvec3 meanRadiance();
  RenderSession& session() { return *session_; }

 private:
  PackSession(World world, const SessionSetup& setup, std::size_t camera = 0);
  std::unique_ptr<RenderSession> session_;
  OptionValues options_;
  int frames_ = 0;
};

/// The cell of a block when the camera's eye is in block `eye`.
glm::ivec3 cellOf(glm::ivec3 block, glm::ivec3 eye, int volume = 64);

}  // namespace orris::test
