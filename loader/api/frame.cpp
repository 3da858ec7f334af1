// Frames through the C interface: what the engine gives for each, and what becomes of it.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <glm/gtc/type_ptr.hpp>
#include <span>

#include <orris/api/renderer.h>

namespace orris::api {
namespace {

/// A number of OrrisFrame and what it may be.
template <typename T>
struct Limit {
  const char* name;
  T OrrisFrame::*member;
  T least, most;
};
constexpr Limit<float> kNumbers[] = {{"frame_time", &OrrisFrame::frame_time, 0, 3600},
                                     {"rain", &OrrisFrame::rain, 0, 1},
                                     {"thunder", &OrrisFrame::thunder, 0, 1},
                                     {"temperature", &OrrisFrame::temperature, -10, 10},
                                     {"rainfall", &OrrisFrame::rainfall, 0, 10},
                                     {"blindness", &OrrisFrame::blindness, 0, 1},
                                     {"night_vision", &OrrisFrame::night_vision, 0, 1},
                                     {"darkness", &OrrisFrame::darkness, 0, 1},
                                     {"darkness_light", &OrrisFrame::darkness_light, 0, 1},
                                     {"screen_brightness", &OrrisFrame::screen_brightness, 0, 1}};
constexpr Limit<int32_t> kIntegers[] = {{"time", &OrrisFrame::time, 0, 23999},
                                        {"day", &OrrisFrame::day, 0, 1 << 24},
                                        {"render_distance", &OrrisFrame::render_distance, 16, 4096},
                                        {"clouds", &OrrisFrame::clouds, 0, 2},
                                        {"held_light", &OrrisFrame::held_light, 0, 15},
                                        {"held_light2", &OrrisFrame::held_light2, 0, 15},
                                        {"eye_fluid", &OrrisFrame::eye_fluid, 0, 2},
                                        {"eye_block_light", &OrrisFrame::eye_block_light, 0, 15},
                                        {"eye_sky_light", &OrrisFrame::eye_sky_light, 0, 15}};

[[noreturn]] void refuse(const std::string& name, const std::string& value,
                         const std::string& wanted) {
  fail(ORRIS_ERROR_ARGUMENT, "frame->" + name + " is " + value + " and must be " + wanted);
}

template <typename T, std::size_t N>
void checkLimits(const OrrisFrame& frame, const Limit<T> (&limits)[N]) {
  for (const Limit<T>& limit : limits) {
    const T value = frame.*limit.member;
    if (value >= limit.least && value <= limit.most) continue;  // false of NaN
    refuse(limit.name, std::to_string(value),
           std::to_string(limit.least) + " to " + std::to_string(limit.most));
  }
}

template <typename T>
void checkFinite(const char* name, const T* values, int count) {
  for (int i = 0; i < count; ++i)
    if (!std::isfinite(values[i])) refuse(name, std::to_string(values[i]), "finite");
}

/// Angles of a direction, as the game counts them.
void lookAlong(const glm::vec3& direction, Camera& camera) {
  const float length = glm::length(direction);
  if (length <= 0) refuse("camera.direction", "0", "of some length");
  camera.yaw = glm::degrees(std::atan2(0 - direction.x, direction.z));
  camera.pitch = glm::degrees(-std::asin(glm::clamp(direction.y / length, -1.0f, 1.0f)));
}

/// The camera, and its matrices where the engine gives some.
std::optional<ViewMatrices> readCamera(const OrrisCamera& given, Camera& camera) {
  checkFinite("camera.position", given.position, 3);
  camera.position = {given.position[0], given.position[1], given.position[2]};
  if (given.mode == ORRIS_CAMERA_MATRICES) {
    checkFinite("camera.view", given.view, 16);
    checkFinite("camera.projection", given.projection, 16);
    ViewMatrices matrices{glm::make_mat4(given.view), glm::make_mat4(given.projection)};
    if (glm::determinant(matrices.view) == 0 || glm::determinant(matrices.projection) == 0)
      refuse("camera", "a matrix without an inverse", "of two that have one");
    const glm::mat4& v = matrices.view;
    lookAlong(-glm::vec3(v[0][2], v[1][2], v[2][2]), camera);
    camera.fov = glm::degrees(2 * std::atan(1 / matrices.projection[1][1]));
    return matrices;
  }
  if (!(given.fov > 0 && given.fov < 180))
    refuse("camera.fov", std::to_string(given.fov), "over 0 and under 180");
  camera.fov = given.fov;
  if (given.mode == ORRIS_CAMERA_DIRECTION) {
    checkFinite("camera.direction", given.direction, 3);
    lookAlong(glm::make_vec3(given.direction), camera);
  } else if (given.mode == ORRIS_CAMERA_ANGLES) {
    const float angles[] = {given.yaw, given.pitch};
    checkFinite("camera.yaw or pitch", angles, 2);
    camera.yaw = given.yaw;
    camera.pitch = given.pitch;
  } else {
    refuse("camera.mode", std::to_string(given.mode), "an OrrisCameraMode");
  }
  return std::nullopt;
}

std::string textOf(const char* text) { return text == nullptr ? std::string() : std::string(text); }

void readPlayer(const OrrisFrame& frame, Player& player) {
  player.mainHand = textOf(frame.main_hand);
  player.offHand = textOf(frame.off_hand);
  player.heldLight = frame.held_light;
  player.heldLight2 = frame.held_light2;
  player.blindness = frame.blindness;
  player.nightVision = frame.night_vision;
  player.darkness = frame.darkness;
  player.darknessLight = frame.darkness_light;
  player.brightness = frame.screen_brightness;
  player.sneaking = frame.sneaking != 0;
  player.sprinting = frame.sprinting != 0;
  player.hurt = frame.hurt != 0;
  player.invisible = frame.invisible != 0;
  player.burning = frame.burning != 0;
  player.onGround = frame.on_ground != 0;
  player.hideGui = frame.hide_gui != 0;
}

void readEnvironment(const OrrisFrame& frame, Environment& environment) {
  environment.time = frame.time;
  environment.day = frame.day;
  environment.rain = frame.rain;
  environment.thunder = frame.thunder;
  environment.renderDistance = frame.render_distance;
  environment.clouds = static_cast<Clouds>(frame.clouds);
  environment.biome = textOf(frame.biome);
  environment.temperature = frame.temperature;
  environment.rainfall = frame.rainfall;
  environment.skyColor = glm::make_vec3(frame.sky_color);
  environment.fogColor = glm::make_vec3(frame.fog_color);
  readPlayer(frame, environment.player);
}

EngineMoment readMoment(const OrrisFrame& frame) {
  checkFinite("selected_position", frame.selected_position, 3);
  checkFinite("lightning_position", frame.lightning_position, 3);
  EngineMoment moment;
  if (const std::string text = textOf(frame.selected_block); !text.empty()) {
    const auto block = parseBlockState(text);
    if (!block) refuse("selected_block", text, "a block state, as minecraft:chest[facing=north]");
    moment.selected = {*block, glm::make_vec3(frame.selected_position)};
  }
  if (frame.lightning != 0) moment.lightning = glm::make_vec3(frame.lightning_position);
  return moment;
}

/// All of it is checked before any of it is taken.
void takeFrame(OrrisRenderer& renderer, const OrrisFrame& frame) {
  checkLimits(frame, kNumbers);
  checkLimits(frame, kIntegers);
  checkFinite("sky_color", frame.sky_color, 3);
  checkFinite("fog_color", frame.fog_color, 3);
  Camera camera;
  const auto matrices = readCamera(frame.camera, camera);
  const EngineMoment moment = readMoment(frame);
  RenderSession& session = *renderer.session;
  session.setMatrices(matrices);
  session.setCamera(camera);
  session.setFrameTime(frame.frame_time);
  readEnvironment(frame, session.environment());
  if (!renderer.geometry) return;
  renderer.eye = {{frame.eye_block_light * 16, frame.eye_sky_light * 16},
                  frame.eye_fluid,
                  frame.feet_in_water != 0};
  session.setSurroundings(renderer.eye);
  renderer.selected = textOf(frame.selected_block);
  renderer.moment = moment;
  session.setMoment(moment);
}

OrrisFrame frameOf(OrrisRenderer& renderer) {
  RenderSession& session = *renderer.session;
  const Environment& environment = session.environment();
  const Player& player = environment.player;
  const Camera& camera = session.camera();
  renderer.biome = environment.biome;
  renderer.mainHand = player.mainHand;
  renderer.offHand = player.offHand;
  OrrisFrame frame;
  std::memset(&frame, 0, sizeof(frame));
  frame.camera.mode = ORRIS_CAMERA_ANGLES;
  for (int i = 0; i < 3; ++i) {
    frame.camera.position[i] = camera.position[i];
    frame.sky_color[i] = environment.skyColor[i];
    frame.fog_color[i] = environment.fogColor[i];
  }
  frame.camera.yaw = camera.yaw;
  frame.camera.pitch = camera.pitch;
  frame.camera.fov = camera.fov;
  frame.camera.direction[2] = 1;
  for (int i = 0; i < 16; i += 5) frame.camera.view[i] = frame.camera.projection[i] = 1;
  frame.frame_time = 1.0f / 60;
  frame.time = environment.time;
  frame.day = environment.day;
  frame.rain = environment.rain;
  frame.thunder = environment.thunder;
  frame.render_distance = environment.renderDistance;
  frame.clouds = static_cast<int32_t>(environment.clouds);
  frame.biome = renderer.biome.c_str();
  frame.temperature = environment.temperature;
  frame.rainfall = environment.rainfall;
  frame.main_hand = renderer.mainHand.c_str();
  frame.off_hand = renderer.offHand.c_str();
  frame.held_light = player.heldLight;
  frame.held_light2 = player.heldLight2;
  frame.blindness = player.blindness;
  frame.night_vision = player.nightVision;
  frame.darkness = player.darkness;
  frame.darkness_light = player.darknessLight;
  frame.screen_brightness = player.brightness;
  frame.sneaking = player.sneaking ? 1 : 0;
  frame.sprinting = player.sprinting ? 1 : 0;
  frame.hurt = player.hurt ? 1 : 0;
  frame.invisible = player.invisible ? 1 : 0;
  frame.burning = player.burning ? 1 : 0;
  frame.on_ground = player.onGround ? 1 : 0;
  frame.hide_gui = player.hideGui ? 1 : 0;
  renderer.selectedOut = renderer.selected;
  frame.selected_block = renderer.selectedOut.c_str();
  frame.lightning = renderer.moment.lightning ? 1 : 0;
  for (int i = 0; i < 3; ++i) {
    frame.selected_position[i] = renderer.moment.selected ? renderer.moment.selected->middle[i] : 0;
    frame.lightning_position[i] = renderer.moment.lightning ? (*renderer.moment.lightning)[i] : 0;
  }
  frame.eye_fluid = renderer.eye.fluid;
  frame.feet_in_water = renderer.eye.feetInWater ? 1 : 0;
  frame.eye_block_light = renderer.eye.brightness.x / 16;
  frame.eye_sky_light = renderer.eye.brightness.y / 16;
  return frame;
}

/// What was submitted is for one frame, whatever becomes of it.
class UseUp {
 public:
  explicit UseUp(SubmittedGeometry* geometry) : geometry_(geometry) {}
  ~UseUp() {
    if (geometry_ != nullptr) geometry_->useUp();
  }
  UseUp(const UseUp&) = delete;
  UseUp& operator=(const UseUp&) = delete;

 private:
  SubmittedGeometry* geometry_;
};

/// Of the loads of a session from one on, which may be due to what a frame has.
bool allSucceeded(const RenderSession& session, std::size_t first) {
  const auto& loads = session.reloads();
  return std::all_of(loads.begin() + static_cast<std::ptrdiff_t>(first), loads.end(),
                     [](const SessionReload& load) { return load.succeeded; });
}

}  // namespace
}  // namespace orris::api

using namespace orris::api;

OrrisStatus orris_renderer_frame_init(OrrisRenderer* handle, OrrisFrame* frame, size_t size) {
  return guarded([&] {
    OrrisRenderer& renderer = live(handle);
    refuseNull(frame, "frame");
    const OrrisFrame now = frameOf(renderer);
    initialise(frame, size, &now, sizeof(now));
  });
}

OrrisStatus orris_renderer_set_uniform(OrrisRenderer* handle, const char* name, const float* values,
                                       size_t count) {
  return guarded([&] {
    OrrisRenderer& renderer = live(handle);
    refuseNull(name, "name");
    refuseNull(values, "values");
    const orris::StatedUniform* uniform = orris::findStated(name);
    if (uniform == nullptr)
      fail(ORRIS_ERROR_NOT_FOUND, std::string(name) + " is no uniform that can be stated");
    const std::span given(values, count);
    if (!orris::takes(*uniform, given))
      fail(ORRIS_ERROR_ARGUMENT, std::string(name) + " does not take these " + std::to_string(count) + " numbers");
    std::array<float, 3>& stated = renderer.session->environment().stated[name];
    std::copy(given.begin(), given.end(), stated.begin());
  });
}

OrrisStatus orris_renderer_draw_frame(OrrisRenderer* handle, const OrrisFrame* frame) {
  return guarded([&] {
    OrrisRenderer& renderer = live(handle);
    const Current current(*renderer.context);
    if (frame != nullptr) takeFrame(renderer, sized(frame, "frame"));
    const UseUp useUp(renderer.geometry.get());
    const std::size_t loads = renderer.session->reloads().size();
    orris::Diagnostics diagnostics;
    renderer.session->renderFrame(diagnostics);
    renderer.drawn = true;
    addGlErrors(*renderer.context, diagnostics);
    finishLoad(renderer, allSucceeded(*renderer.session, loads), diagnostics);
  });
}
