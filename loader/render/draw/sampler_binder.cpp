#include <orris/render/draw/sampler_binder.h>

#include <orris/gl/functions.h>

namespace orris {
namespace {

bool isGeometry(const Step& step) {
  return step.kind == Step::Kind::Draw || step.kind == Step::Kind::DrawShadow;
}

constexpr SamplerState kAtlas{false, false, true, false, false};

/// Does an engine that draws in place of the scene draw this, too?
bool isEngines(Geometry geometry) { return !isSky(geometry) && !isClouds(geometry); }

bool altSide(const Step& step, bool shadow, int index) {
  return ((shadow ? step.shadowFlipped : step.flipped) >> index & 1u) != 0;
}

int filterOf(const SamplerState& state, bool minification) {
  if (!minification || !state.mipmaps) return state.linear ? GL_LINEAR : GL_NEAREST;
  if (state.linear) return GL_LINEAR_MIPMAP_LINEAR;
  return state.integer ? GL_NEAREST_MIPMAP_NEAREST : GL_NEAREST_MIPMAP_LINEAR;
}

}  // namespace

unsigned SamplerBinder::samplerObject(const SamplerState& state) {
  if (const auto it = samplers_.find(state); it != samplers_.end()) return it->second.id();
  unsigned id = 0;
  gl::GenSamplers(1, &id);
  const int wrap = state.repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
  for (unsigned axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    gl::SamplerParameteri(id, axis, wrap);
  gl::SamplerParameteri(id, GL_TEXTURE_MIN_FILTER, filterOf(state, true));
  gl::SamplerParameteri(id, GL_TEXTURE_MAG_FILTER, filterOf(state, false));
  if (state.compare) {
    gl::SamplerParameteri(id, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    gl::SamplerParameteri(id, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  }
  samplers_.emplace(state, gl::Handle<gl::deleteSampler>(id));
  return id;
}

SamplerBinder::Choice SamplerBinder::colorChoice(bool shadow, int index, bool alt) {
  RenderTarget* target = targets_.find(shadow, index);
  if (target == nullptr) return {};
  const bool integer = target->format->isInteger();
  bool nearest = integer, mipmaps = target->mipmapped[alt && target->plan.needsAlt ? 1 : 0];
  if (shadow)
    if (const auto it = directives_.shadowcolor.find(index); it != directives_.shadowcolor.end()) {
      nearest |= it->second.nearest;
      mipmaps |= it->second.mipmap && target->plan.mipmaps;
    }
  return {&target->side(alt), {!nearest, false, mipmaps, false, integer}};
}

SamplerBinder::Choice SamplerBinder::chooseBuffer(const SamplerBinding& sampler, const Step& step,
                                                  bool& found) {
  const BufferName& buffer = *sampler.buffer;
  found = true;
  switch (buffer.kind) {
    case BufferName::Kind::Color:
      // In geometry programs the first four names fall through to the atlas.
      if (isGeometry(step) && buffer.index < 4) break;
      if (step.group == ProgramGroup::ShadowComp) break;
      return colorChoice(false, buffer.index, altSide(step, false, buffer.index));
    case BufferName::Kind::ShadowColor:
      return colorChoice(true, buffer.index, altSide(step, true, buffer.index));
    case BufferName::Kind::Depth: {
      if (step.group == ProgramGroup::ShadowComp) break;
      return {&targets_.depth(buffer.index), {}};
    }
    case BufferName::Kind::Stencil:
      // While geometry is drawn the stencil is attached.
      if (isGeometry(step)) break;
      return {buffer.index == 0 ? &targets_.stencil() : &targets_.lampShadows(), {.integer = true}};
    case BufferName::Kind::ShadowDepth: {
      const ShadowDepthSettings& settings = directives_.shadowtex[buffer.index];
      const bool compare = gl::isShadowSampler(sampler.type);
      return {&targets_.shadowDepth(buffer.index),
              {!settings.nearest, false, settings.mipmap, compare, false}};
    }
  }
  found = false;
  return {};
}

SamplerBinder::Choice SamplerBinder::chooseNamed(const SamplerBinding& sampler, const Step& step,
                                                 bool& found) const {
  found = true;
  if (sampler.name == "noisetex") {
    if (const BoundTexture* own = resources_.find("", "noisetex", 2); own != nullptr)
      return {&own->texture, {own->linear, own->repeat, false, false, false}};
    return {&noise_, {true, true, false, false, false}};
  }
  // Distant Horizons is never there: its depth is empty, that is 1.
  if (sampler.name.starts_with("dhDepthTex")) return {&scene_.white(), {}};
  if (isGeometry(step)) {
    if (sampler.name == "lightmap") return {&scene_.lightmap(), {true, false, false, false, false}};
    const bool content = findContentKind(step.geometry) != nullptr && !engine_;
    if (sampler.name == "normals")
      return content ? Choice{&scene_.contentNormals(), kAtlas} : normals(step);
    if (sampler.name == "specular")
      return content ? Choice{&scene_.contentSpecular(), kAtlas} : specular(step);
  }
  found = false;
  return {};
}

SamplerBinder::Choice SamplerBinder::chooseFallback(const Step& step) {
  if (!isGeometry(step)) return colorChoice(false, 0, altSide(step, false, 0));
  if (isEngines(step.geometry) && engine_) return atlas(step);
  if (const ContentKind* kind = findContentKind(step.geometry)) {
    const bool repeats = kind->sheet > Sheet::White;
    // Iris keeps the game's filters: the glint is smooth.
    return {&scene_.sheet(kind->sheet),
            {kind->sheet == Sheet::Glint, repeats, kind->sheet == Sheet::Content, false, false}};
  }
  switch (step.geometry) {
    case Geometry::Sky:
    case Geometry::Stars:
      return {&scene_.white(), {}};
    case Geometry::SunMoon:
      return {&scene_.celestial(), {}};
    case Geometry::EndSky:
      return {&scene_.endSky(), {false, true, false, false, false}};
    case Geometry::CloudsFast:
    case Geometry::CloudsFancy:
      return {&scene_.white(), {}};
    default:
      return atlas(step);
  }
}

SamplerBinder::Choice SamplerBinder::atlas(const Step& step) const {
  if (!engine_ || !isGeometry(step)) return {&scene_.atlas(), kAtlas};
  if (engine_->albedo == 0) return {&scene_.white(), {}};
  return {nullptr, {}, engine_->albedo};
}

SamplerBinder::Choice SamplerBinder::normals(const Step& step) const {
  if (!engine_ || !isGeometry(step) || engine_->normals == 0) return {&scene_.normals(), kAtlas};
  return {nullptr, {}, engine_->normals};
}

SamplerBinder::Choice SamplerBinder::specular(const Step& step) const {
  if (!engine_ || !isGeometry(step) || engine_->specular == 0) return {&scene_.specular(), kAtlas};
  return {nullptr, {}, engine_->specular};
}

bool SamplerBinder::setEngineTextures(const std::optional<EngineTextures>& textures) {
  if (engine_ == textures) return false;
  engine_ = textures;
  return true;
}

SamplerBinder::Choice SamplerBinder::choose(const SamplerBinding& sampler, const Step& step) {
  const bool replacementEnded = sampler.buffer && sampler.buffer->kind == BufferName::Kind::Color &&
                                (step.flippedInGroup >> sampler.buffer->index & 1u) != 0;
  const std::string stage = textureStageOf(step.group);
  if (!replacementEnded)
    if (const BoundTexture* own =
            resources_.find(stage, sampler.name, gl::dimensionsOf(sampler.type))) {
      if (own->resource == "atlas") return atlas(step);
      if (own->resource == "normals") return normals(step);
      if (own->resource == "specular") return specular(step);
      if (own->resource == "lightmap")
        return {&scene_.lightmap(), {true, false, false, false, false}};
      if (own->resource == "white") return {&scene_.white(), {}};
      return {&own->texture, {own->linear, own->repeat, false, false, false}};
    }
  if (const ImageResource* image = resources_.imageSampler(sampler.name))
    return {&image->texture,
            {!image->format->isInteger(), false, false, false, image->format->isInteger()}};
  bool found = false;
  if (sampler.buffer)
    if (const Choice choice = chooseBuffer(sampler, step, found); found) return choice;
  if (const Choice choice = chooseNamed(sampler, step, found); found) return choice;
  return chooseFallback(step);
}

void SamplerBinder::bindImage(const SamplerBinding& image, const Step& step) {
  const gl::Texture* texture = nullptr;
  if (const ImageResource* own = resources_.image(image.name); own != nullptr) {
    texture = &own->texture;
  } else if (image.buffer && image.buffer->image) {
    const bool shadow = image.buffer->kind == BufferName::Kind::ShadowColor;
    if (RenderTarget* target = targets_.find(shadow, image.buffer->index); target != nullptr)
      texture = &target->side(altSide(step, shadow, image.buffer->index));
  }
  if (texture == nullptr || texture->id() == 0) return;
  gl::BindImageTexture(static_cast<unsigned>(image.unit), texture->id(), 0,
                       texture->target == GL_TEXTURE_3D ? GL_TRUE : GL_FALSE, 0, GL_READ_WRITE,
                       texture->internalFormat);
  gl::Uniform1i(image.location, image.unit);
}

void SamplerBinder::bind(const GpuProgram& program, const Step& step) {
  for (const SamplerBinding& sampler : program.samplers) {
    const Choice choice = choose(sampler, step);
    gl::Uniform1i(sampler.location, sampler.unit);
    if (choice.engine != 0) {
      gl::ActiveTexture(GL_TEXTURE0 + static_cast<unsigned>(sampler.unit));
      gl::BindTexture(GL_TEXTURE_2D, choice.engine);
      gl::BindSampler(static_cast<unsigned>(sampler.unit), 0);
      continue;
    }
    if (choice.texture == nullptr || choice.texture->id() == 0) continue;
    gl::ActiveTexture(GL_TEXTURE0 + static_cast<unsigned>(sampler.unit));
    gl::BindTexture(choice.texture->target, choice.texture->id());
    gl::BindSampler(static_cast<unsigned>(sampler.unit), samplerObject(choice.state));
  }
  for (const SamplerBinding& image : program.images) bindImage(image, step);
}

void SamplerBinder::unbind(const GpuProgram& program) {
  for (const SamplerBinding& sampler : program.samplers) {
    gl::ActiveTexture(GL_TEXTURE0 + static_cast<unsigned>(sampler.unit));
    for (unsigned target : {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D})
      gl::BindTexture(target, 0);
    gl::BindSampler(static_cast<unsigned>(sampler.unit), 0);
  }
  for (const SamplerBinding& image : program.images)
    gl::BindImageTexture(static_cast<unsigned>(image.unit), 0, 0, GL_FALSE, 0, GL_READ_ONLY,
                         GL_RGBA8);
}

}  // namespace orris
