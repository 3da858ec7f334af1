// What a pack brings or asks for besides render targets: custom textures, images, storage buffers.
// Contract: properties.csv texture.*, customTexture.*, image.*, bufferObject.*.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <orris/gl/buffer.h>
#include <orris/gl/texture.h>
#include <orris/pack/shader_pack.h>

namespace orris {

/// A texture.* or customTexture.* line. `resource` names a host texture instead of own pixels:
/// "atlas", "normals", "specular", "lightmap", or "white" for a game texture the host has not.
struct BoundTexture {
  TextureBinding binding;
  gl::Texture texture;
  std::string resource;
  bool linear = false, repeat = true;
};

struct ImageResource {
  CustomImage plan;
  gl::Texture texture;
  const TextureFormat* format = nullptr;
};

/// Missing files and bad sizes are located warnings (Iris logs and goes on); the binding is dropped.
class PackResources {
 public:
  PackResources(const ShaderPack& pack, int width, int height, Diagnostics& diagnostics);

  /// The texture bound to `sampler` for programs of texture stage `stage` ("gbuffers", ...), or
  /// nullptr. `dimensions` of the declaration must fit a raw texture.
  const BoundTexture* find(const std::string& stage, const std::string& sampler,
                           int dimensions) const;
  const ImageResource* image(const std::string& name) const;         ///< by image uniform name
  const ImageResource* imageSampler(const std::string& name) const;  ///< by its sampler name
  const std::vector<ImageResource>& images() const { return images_; }
  void bindBuffers() const;
  void clearImages(bool all) const;  ///< all: also those without clear=true (creation)
  /// Buffer object of a bufferObject index, 0 when absent.
  unsigned buffer(int index) const;
  const std::map<int, gl::Buffer>& buffers() const { return buffers_; }

 private:
  void addTexture(const ShaderPack& pack, const TextureBinding& binding, Diagnostics& diagnostics);
  void addImage(const CustomImage& plan, int width, int height, Diagnostics& diagnostics);
  void addBuffer(const ShaderPack& pack, const BufferObject& plan, int width, int height,
                 Diagnostics& diagnostics);
  std::vector<BoundTexture> textures_;
  std::vector<ImageResource> images_;
  std::map<int, gl::Buffer> buffers_;
};

}  // namespace orris
