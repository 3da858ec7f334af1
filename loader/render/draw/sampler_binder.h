// Which texture a sampler or image name means in a step, and binding it.
// Contract: buffers.csv, README "Mipmaps and sampling".
#pragma once

#include <map>
#include <optional>

#include <orris/render/gpu_program.h>
#include <orris/render/scene/gpu_scene.h>
#include <orris/render/pack_resources.h>
#include <orris/render/render_targets.h>

namespace orris {

/// How a texture is sampled; sampler objects keep it apart from the texture, since one texture is
/// read as sampler2D and as sampler2DShadow.
struct SamplerState {
  bool linear = false, repeat = false, mipmaps = false, compare = false, integer = false;
  auto operator<=>(const SamplerState&) const = default;
};

/// Of a draw that an engine submits: GL names of 2-D textures, sampled with their own parameters. 0 means
/// white, and for the maps flat and rough.
struct EngineTextures {
  unsigned albedo = 0, normals = 0, specular = 0;
  glm::ivec2 size{0};  ///< of `albedo`, texels
  bool operator==(const EngineTextures&) const = default;
};

class SamplerBinder {
 public:
  SamplerBinder(RenderTargets& targets, const GpuScene& scene, const PackResources& resources,
                const PackDirectives& directives, const gl::Texture& noise)
      : targets_(targets),
        scene_(scene),
        resources_(resources),
        directives_(directives),
        noise_(noise) {}

  /// Binds everything `program` samples or loads during `step`, units from 0.
  void bind(const GpuProgram& program, const Step& step);
  static void unbind(const GpuProgram& program);
  /// In place of the scene's textures in geometry steps; nullopt: the scene's. true when they are others.
  bool setEngineTextures(const std::optional<EngineTextures>& textures);
  /// What a sampler reads in `step`; nullptr where it reads nothing.
  const gl::Texture* textureOf(const SamplerBinding& sampler, const Step& step) {
    return choose(sampler, step).texture;
  }

 private:
  struct Choice {
    const gl::Texture* texture = nullptr;
    SamplerState state;
    unsigned engine = 0;  ///< GL name of an engine's texture, in place of `texture`
  };
  Choice choose(const SamplerBinding& sampler, const Step& step);
  Choice chooseBuffer(const SamplerBinding& sampler, const Step& step, bool& found);
  Choice chooseNamed(const SamplerBinding& sampler, const Step& step, bool& found) const;
  Choice chooseFallback(const Step& step);
  Choice atlas(const Step& step) const;
  Choice normals(const Step& step) const;
  Choice specular(const Step& step) const;
  Choice colorChoice(bool shadow, int index, bool alt);
  void bindImage(const SamplerBinding& image, const Step& step);
  unsigned samplerObject(const SamplerState& state);

  RenderTargets& targets_;
  const GpuScene& scene_;
  const PackResources& resources_;
  const PackDirectives& directives_;
  const gl::Texture& noise_;
  std::optional<EngineTextures> engine_;
  std::map<SamplerState, gl::Handle<gl::deleteSampler>> samplers_;
};

}  // namespace orris
