#include <orris/render/session/render_session.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include <orris/core/work_record.h>
#include <orris/plan/lists/draw_lists.h>
#include <orris/plan/scene/scene_quantities.h>
#include <orris/world/blocks/block_data.h>

namespace orris {
namespace {

// When AUTO is asked again: choosing and compiling take time, and a scene does not change its kind
// from one frame to the next.
constexpr int kChoiceFrames = 20;
constexpr double kChoiceWay = 16;  // blocks that the eye moved
constexpr int kChoiceTicks = 500;

std::shared_ptr<const ShaderPack> withoutErrors(std::optional<ShaderPack> pack,
                                                const Diagnostics& problems,
                                                Diagnostics& diagnostics) {
  diagnostics.insert(diagnostics.end(), problems.begin(), problems.end());
  if (!pack || hasErrors(problems)) return nullptr;
  return std::make_shared<const ShaderPack>(std::move(*pack));
}

}  // namespace

MacroDefinitions environmentFor(const gl::DriverInfo& driver, const HostVersions& versions) {
  return standardMacros({.glVendor = driver.vendor,
                         .glRenderer = driver.renderer,
                         .glExtensions = driver.extensions,
                         .glVersion = driver.glVersion,
                         .glslVersion = driver.glVersion,
                         .versions = versions,
                         .labPbr = true});  // the generated atlas follows it
}

RenderSession::RenderSession(SessionRequest request, SceneData scene)
    : request_(std::move(request)), scene_(std::move(scene)) {}

std::unique_ptr<RenderSession> RenderSession::create(gl::Context& context, SessionRequest request,
                                                     World world, Diagnostics& diagnostics) {
  request.load.environment = environmentFor(context.driver(), request.versions);
  if (request.time) world.environment.time = *request.time;
  auto session = std::unique_ptr<RenderSession>(new RenderSession(std::move(request), SceneData()));
  const auto asked = session->loadPack(diagnostics);
  if (asked == nullptr) return nullptr;
  session->scene_ = buildScene(std::move(world), meshStyleOf(*asked), diagnostics);
  EngineGeometry* engine = session->request_.engine;
  if (engine != nullptr) session->scene_.submitted = engine->kinds();
  const auto pack = session->settle(asked, diagnostics);
  if (pack == nullptr) return nullptr;
  if (meshStyleOf(*pack) != meshStyleOf(*asked)) rebuildMesh(session->scene_, meshStyleOf(*pack));
  session->weather_ = weatherOf(session->scene_.world.environment);
  session->renderer_ = std::make_unique<FrameRenderer>(context, session->request_.renderer);
  session->renderer_->setEngine(engine);
  SessionReload start{0, "start", false, {}};
  start.succeeded = session->renderer_->setPack(pack, session->scene_, start.report, diagnostics);
  session->reloads_.push_back(start);
  return start.succeeded ? std::move(session) : nullptr;
}

std::shared_ptr<const ShaderPack> RenderSession::loadPack(Diagnostics& diagnostics) {
  Diagnostics problems;
  auto source = request_.openPack(problems);
  std::optional<ShaderPack> pack;
  if (source != nullptr) pack = loadShaderPack(std::move(source), request_.load, problems);
  return withoutErrors(std::move(pack), problems, diagnostics);
}

std::shared_ptr<const ShaderPack> RenderSession::rebuildPack(Diagnostics& diagnostics) {
  Diagnostics problems;
  auto pack = rebuildShaderPack(renderer_->pack(), request_.load, problems);
  return withoutErrors(std::move(pack), problems, diagnostics);
}

bool RenderSession::reload(const std::string& cause, Diagnostics& diagnostics) {
  waitForChange(diagnostics);
  return use(cause, loadPack(diagnostics), diagnostics);
}

SceneMeter RenderSession::meterFor(const ShaderPack& asked) const {
  return [this, &asked](const std::set<std::string>& wanted) {
    const FrameState view = nextFrameState(frameInput(), asked.directives, nullptr);
    return measureScene(scene_, view, asked.directives, wanted);
  };
}

std::shared_ptr<const ShaderPack> RenderSession::settle(std::shared_ptr<const ShaderPack> asked,
                                                        Diagnostics& diagnostics) {
  asked_ = asked;
  chosenFor_ = {frame_, scene_.world.environment.time, request_.camera.position, false};
  auto_.choose(*asked, request_.load, meterFor(*asked));
  if (auto_.all().empty()) return asked;
  Diagnostics problems;
  auto pack = rebuildShaderPack(*asked, auto_.applied(request_.load), problems);
  return withoutErrors(std::move(pack), problems, diagnostics);
}

bool RenderSession::sceneChanged() const {
  if (auto_.all().empty() || frame_ - chosenFor_.frame < kChoiceFrames) return false;
  return chosenFor_.blocksChanged ||
         std::abs(scene_.world.environment.time - chosenFor_.time) > kChoiceTicks ||
         glm::distance(request_.camera.position, chosenFor_.eye) > kChoiceWay;
}

void RenderSession::chooseAgain(Diagnostics& diagnostics) {
  const AutoChoices before = auto_;
  const auto pack = settle(asked_, diagnostics);
  if (pack == nullptr || auto_.text() == before.text()) return;
  if (!take("AUTO: " + auto_.text(), pack, diagnostics)) auto_ = before;
}

bool RenderSession::use(const std::string& cause, std::shared_ptr<const ShaderPack> asked,
                        Diagnostics& diagnostics) {
  const auto askedBefore = asked_;
  const AutoChoices autoBefore = auto_;
  if (asked != nullptr) asked = settle(std::move(asked), diagnostics);
  if (take(cause, std::move(asked), diagnostics)) return true;
  asked_ = askedBefore;
  auto_ = autoBefore;
  return false;
}

bool RenderSession::take(const std::string& cause, std::shared_ptr<const ShaderPack> pack,
                         Diagnostics& diagnostics, LoadReport report) {
  SessionReload reload{frame_, cause, false, std::move(report)};
  if (pack != nullptr) {
    const MeshStyle style = meshStyleOf(*pack);
    const bool newStyle = style != meshStyleOf(renderer_->pack());
    if (newStyle) rebuildMesh(scene_, style);
    reload.succeeded = renderer_->setPack(pack, scene_, reload.report, diagnostics);
    if (newStyle && reload.succeeded) renderer_->updateScene(scene_);
  }
  reloads_.push_back(reload);
  return reload.succeeded;
}

bool RenderSession::setOption(const std::string& name, const std::string& value,
                              Diagnostics& diagnostics) {
  waitForChange(diagnostics);
  const LoadRequest before = request_.load;
  request_.load.values[name] = value;
  request_.load.live.clear();  // whether it can be live depends on the others
  if (use(fmt::format("{}={}", name, value), rebuildPack(diagnostics), diagnostics)) return true;
  request_.load = before;
  return false;
}

bool RenderSession::setProfile(const std::string& name, Diagnostics& diagnostics) {
  waitForChange(diagnostics);
  const std::string before = request_.load.profile;
  request_.load.profile = name;
  if (use("profile " + name, rebuildPack(diagnostics), diagnostics)) return true;
  request_.load.profile = before;
  return false;
}

bool RenderSession::setWorld(World world, const Camera& camera, Diagnostics& diagnostics) {
  waitForChange(diagnostics);
  const std::string cause = "world " + world.name;
  SceneData before =
      std::exchange(scene_, buildScene(std::move(world), meshStyleOf(*asked_), diagnostics));
  const Camera cameraBefore = std::exchange(request_.camera, camera);
  renderer_->forgetScene();
  weather_ = weatherOf(scene_.world.environment);
  const std::size_t eventBefore = std::exchange(nextEvent_, 0);
  // Events count frames of their world.
  const int frameBefore = std::exchange(frame_, 0);
  const auto state = std::exchange(state_, std::nullopt);
  if (use(cause, asked_, diagnostics)) return true;
  scene_ = std::move(before);
  request_.camera = cameraBefore;
  nextEvent_ = eventBefore;
  frame_ = frameBefore;
  state_ = state;
  return false;
}

void RenderSession::follow(const RenderSession& other) {
  request_.camera = other.request_.camera;
  request_.frameTime = other.request_.frameTime;
  scene_.world.environment = other.scene_.world.environment;
  frame_ = other.frame_;
  state_ = other.state_;
  nextEvent_ = other.nextEvent_;
}

void RenderSession::applyEvents(Diagnostics& diagnostics) {
  bool blocksChanged = false;
  World& world = scene_.world;
  for (; nextEvent_ < world.events.size() && world.events[nextEvent_].frame <= frame_;
       ++nextEvent_) {
    const auto& action = world.events[nextEvent_].action;
    if (const auto* block = std::get_if<SetBlock>(&action)) {
      world.blocks.set(block->at, world.blocks.paletteIndex(block->state));
      blocksChanged = true;
    } else if (const auto* camera = std::get_if<MoveCamera>(&action)) {
      request_.camera = camera->camera;
    } else if (const auto* option = std::get_if<SetOption>(&action)) {
      setOption(option->name, option->value, diagnostics);
    } else if (const auto* time = std::get_if<SetTime>(&action)) {
      world.environment.time = time->time;
    } else if (const auto* change = std::get_if<ChangeEntity>(&action)) {
      changeEntity(*change);
    } else if (const auto* bolt = std::get_if<StrikeLightning>(&action)) {
      world.content.bolts.push_back({bolt->at, frame_ + bolt->frames});
    }
  }
  std::erase_if(world.content.bolts, [&](const LightningBolt& bolt) { return bolt.until <= frame_; });
  if (!blocksChanged) return;
  chosenFor_.blocksChanged = true;
  rebuildScene(diagnostics);
}

void RenderSession::changeEntity(const ChangeEntity& change) {
  for (Entity& entity : scene_.world.content.entities) {
    if (entity.name != change.name) continue;
    entity.position = change.position.value_or(entity.position);
    entity.yaw = change.yaw.value_or(entity.yaw);
    entity.walking = change.walking.value_or(entity.walking);
    entity.hurt = change.hurt.value_or(entity.hurt);
  }
}

void RenderSession::followContents(const std::string& cause, Diagnostics& diagnostics) {
  SessionReload reload{frame_, cause, false, {}};
  reload.succeeded =
      renderer_->setPack(renderer_->sharedPack(), scene_, reload.report, diagnostics);
  reloads_.push_back(reload);
}

void RenderSession::rebuildScene(Diagnostics& diagnostics) {
  const SceneContents before = scene_.contents();
  rebuildMesh(scene_, meshStyleOf(renderer_->pack()));
  // The first glass pane brings a translucent pass with it, the last one takes it away.
  if (scene_.contents() != before) followContents("blocks changed", diagnostics);
  renderer_->updateScene(scene_);
}

FrameInput RenderSession::frameInput() const {
  FrameInput input;
  input.width = renderer_ ? renderer_->schedule().width : request_.renderer.width;
  input.height = renderer_ ? renderer_->schedule().height : request_.renderer.height;
  input.seed = request_.seed;
  input.camera = request_.camera;
  input.environment = scene_.world.environment;
  input.matrices = matrices_;
  input.eye = surroundings_ ? *surroundings_ : scene_.surroundings(request_.camera.position);
  input.frameTime = request_.frameTime;
  return input;
}

void RenderSession::setContentIds(FrameState& state) const {
  const ShaderPack& pack = renderer_->pack();
  const int none = pack.hasItemFile ? -1 : 0;
  const auto heldId = [&](const std::string& item) {
    const auto found = pack.itemIds.find(item);
    return found == pack.itemIds.end() ? none : found->second;
  };
  Player& player = state.environment.player;
  state.heldItemId = heldId(player.mainHand);
  state.heldItemId2 = heldId(player.offHand);
  const auto& items = scene_.content.items;
  if (const auto it = items.find(player.mainHand); it != items.end())
    player.heldLight = std::max(player.heldLight, it->second.emission);
  if (const auto it = items.find(player.offHand); it != items.end())
    player.heldLight2 = std::max(player.heldLight2, it->second.emission);
  const EngineMoment now = moment();
  if (now.selected) {
    const BlockState& block = now.selected->block;
    state.selectedBlockId = pack.blockIds.idOf(block.name, wholeProperties(block));
    state.selectedBlockPos = glm::vec3(now.selected->middle - state.cameraPosition);
  }
  if (now.lightning)
    state.lightningBolt = glm::vec4(glm::vec3(*now.lightning - state.cameraPosition), 1);
}

EngineMoment RenderSession::moment() const {
  if (request_.engine != nullptr) return moment_;
  const WorldContent& content = scene_.world.content;
  EngineMoment now;
  if (content.selected)
    now.selected = {scene_.world.blocks.at(*content.selected), glm::dvec3(*content.selected) + 0.5};
  if (!content.bolts.empty()) now.lightning = content.bolts.back().at;
  return now;
}

void RenderSession::followWorld(Diagnostics& diagnostics) {
  if (request_.engine != nullptr) {
    const GeometrySet kinds = request_.engine->kinds();
    if (kinds == scene_.submitted) return;
    scene_.submitted = kinds;
    followContents("other geometry submitted", diagnostics);
  } else if (const GeometrySet weather = weatherOf(scene_.world.environment); weather != weather_) {
    weather_ = weather;
    renderer_->forgetScene();  // its textures are others
    followContents("weather changed", diagnostics);
  }
}

void RenderSession::renderFrame(Diagnostics& diagnostics) {
  noteFrame(frame_);
  applyEvents(diagnostics);
  followWorld(diagnostics);
  if (!change_ && sceneChanged()) chooseAgain(diagnostics);
  FrameInput input = frameInput();
  input.centerDepth = renderer_->centerDepth();
  state_ = nextFrameState(input, renderer_->pack().directives, state_ ? &*state_ : nullptr);
  if (frame_ == 0) state_->frameCounter = request_.firstFrame;
  setContentIds(*state_);
  Player& player = state_->environment.player;
  if (renderer_->pack().properties.flag("oldHandLight", true))
    player.heldLight = std::max(player.heldLight, player.heldLight2);
  noteFrame(frame_);  // events and choices may have compiled programs
  renderer_->render(*state_,
                    request_.engine != nullptr ? DrawLists() : buildDrawLists(scene_, *state_));
  ++frame_;
}

}  // namespace orris
