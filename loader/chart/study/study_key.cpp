#include <orris/chart/study/study_key.h>

#include <fmt/format.h>

namespace orris {
namespace {

void addValues(Digest& digest, const OptionValues& values) {
  digest.add(values.size());
  for (const auto& [name, value] : values) digest.add(name).add(value);
}

void addBlocks(Digest& digest, const BlockWorld& blocks) {
  const glm::ivec3 from = blocks.origin(), size = blocks.size();
  for (int axis = 0; axis < 3; ++axis) digest.add(from[axis]).add(size[axis]);
  for (const BlockState& state : blocks.palette()) digest.add(state.toString());
  for (int z = from.z; z < from.z + size.z; ++z)
    for (int y = from.y; y < from.y + size.y; ++y)
      for (int x = from.x; x < from.x + size.x; ++x) digest.add(blocks.indexAt({x, y, z}));
}

void addEnvironment(Digest& digest, const Environment& environment) {
  digest.add(environment.time).add(environment.day).add(environment.rain).add(environment.thunder);
  digest.add(environment.biome).add(environment.dimension).add(environment.renderDistance);
  digest.add(environment.temperature).add(environment.rainfall).add(int(environment.clouds));
  for (int c = 0; c < 3; ++c) digest.add(environment.fogColor[c]).add(environment.skyColor[c]);
  const Player& player = environment.player;
  digest.add(player.heldLight).add(player.heldLight2).add(player.nightVision);
  digest.add(player.blindness).add(player.darkness).add(player.brightness);
}

void addCamera(Digest& digest, const Camera& camera) {
  for (int axis = 0; axis < 3; ++axis) digest.add(camera.position[axis]);
  digest.add(camera.yaw).add(camera.pitch).add(camera.fov);
}

void addRequest(Digest& digest, const SessionRequest& request) {
  digest.add(request.load.profile).add(request.load.dimension);
  const HostVersions& versions = request.versions;
  digest.add(versionNumber(versions.iris)).add(versionNumber(versions.game));
  addValues(digest, request.load.values);
  addValues(digest, request.load.fileValues);
  addCamera(digest, request.camera);
  digest.add(request.renderer.width).add(request.renderer.height).add(request.seed);
}

std::string text(const Digest& digest) { return fmt::format("{:016x}", digest.value()); }

}  // namespace

Digest studyDigest(const FileSource& pack, const World& world, const gl::DriverInfo& driver) {
  Digest digest;
  for (const std::string& file : pack.files()) digest.add(file).add(pack.read(file).value_or(""));
  addBlocks(digest, world.blocks);
  addEnvironment(digest, world.environment);
  return digest.add(driver.renderer).add(driver.version);
}

std::string settingKey(Digest study, const SettingJob& job, const MeasurePlan& plan) {
  addRequest(study, job.request);
  study.add(plan.warmUp).add(plan.visit).add(int(plan.clock));
  if (job.reference != nullptr)
    study.add(plan.frames).add(plan.buffer).add(fingerprint(*job.reference));
  return text(study);
}

std::string referenceKey(Digest study, const SessionRequest& request, const MeasurePlan& plan,
                         int frames) {
  addRequest(study, request);
  return text(study.add(plan.warmUp).add(plan.frames).add(plan.buffer).add(frames));
}

}  // namespace orris
