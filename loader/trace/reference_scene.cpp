#include <orris/trace/reference_scene.h>

#include <cstdlib>

#include <orris/plan/frame/celestial.h>
#include <orris/plan/scene/scene_data.h>

namespace orris {
namespace {

OptionValues optionsInForce(const ShaderPack& pack) {
  OptionValues values;
  for (const auto& [name, option] : pack.options.all())
    values[name] = pack.options.value(pack.values, name);
  return values;
}

LightingInput lightingOf(const FrameState& frame, const OptionValues& options) {
  const glm::mat3 toWorld(frame.gbufferModelViewInverse);
  LightingInput lighting;
  lighting.options = options;
  lighting.sunDirection = glm::normalize(toWorld * frame.sunPosition);
  lighting.lightDirection = glm::normalize(toWorld * frame.shadowLightPosition);
  lighting.rainStrength = frame.environment.rain;
  return lighting;
}

}  // namespace

ReferenceScene buildReferenceScene(World world, const ShaderPack& pack, const Camera& camera,
                                   int width, int height, Diagnostics& diagnostics) {
  const OptionValues options = optionsInForce(pack);
  // The directive is an option of the pack: with or without its programs read, one value.
  PackDirectives directives;
  const auto rotation = options.find("sunPathRotation");
  if (rotation != options.end())
    directives.sunPathRotation = std::strtof(rotation->second.c_str(), nullptr);
  const FrameState frame = nextFrameState(
      {.width = width, .height = height, .camera = camera, .environment = world.environment},
      directives, nullptr);
  const SceneData data = buildScene(std::move(world), meshStyleOf(pack), diagnostics);
  const std::vector<int> blockIds = blockIdsOf(pack, data.world.blocks);
  return {buildTraceScene({data.world.blocks, data.facts, blockIds, data.atlas, data.mesh,
                           lightingOf(frame, options)}),
          {frame.cameraPosition, frame.gbufferModelViewInverse, frame.gbufferProjectionInverse,
           frame.width, frame.height},
          shadowLightDirection(frame.skyAngle, directives.sunPathRotation)};
}

}  // namespace orris
