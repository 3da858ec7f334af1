// orris world: what is in a world.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/commands.h"
#include "app/commands/world_export.h"
#include "app/input/inputs.h"
#include <orris/plan/scene/scene_data.h>

namespace orris {
namespace {

struct WorldOptions {
  SceneOptions scene;
  PackOptions pack;  ///< of an export: the options that light it
  std::string exported;
  OutputOptions output;
};

struct WorldFacts {
  long blocks = 0;  ///< not air
  long states = 0;  ///< palette entries in use
  long lights = 0;  ///< blocks that emit
  long faces = 0;
  std::vector<std::string> unknown;
};

WorldFacts gatherFacts(const SceneData& scene) {
  WorldFacts result;
  const BlockWorld& blocks = scene.world.blocks;
  const std::vector<BlockFacts>& facts = scene.facts;
  std::vector<long> uses(facts.size(), 0);
  const glm::ivec3 first = blocks.origin(), end = blocks.origin() + blocks.size();
  for (int y = first.y; y < end.y; ++y) {
    for (int z = first.z; z < end.z; ++z) {
      for (int x = first.x; x < end.x; ++x) ++uses[blocks.indexAt({x, y, z})];
    }
  }
  for (size_t i = 0; i < facts.size(); ++i) {
    if (uses[i] == 0 || facts[i].air) continue;
    ++result.states;
    result.blocks += uses[i];
    if (facts[i].emission > 0) result.lights += uses[i];
    if (!facts[i].known) result.unknown.push_back(blocks.palette()[i].toString());
  }
  result.faces = long(scene.mesh.faces.size());
  return result;
}

/// How much of the world the resource packs draw.
nlohmann::json lookJson(const BlockLook& look) {
  return {{"modelled", look.modelled}, {"textures", look.textures}, {"ownLook", look.ownLook}};
}

std::string lookText(const BlockLook& look) {
  std::string text = fmt::format("  resources   models for {} block states, {} textures\n", look.modelled,
                                 look.textures);
  if (look.ownLook.empty()) return text;
  return text + fmt::format("  own look    {} blocks without a model: {}\n", look.ownLook.size(),
                            fmt::join(look.ownLook, ", "));
}

nlohmann::json worldJson(const World& world, const WorldFacts& facts) {
  const glm::ivec3 origin = world.blocks.origin(), size = world.blocks.size();
  nlohmann::json cameras = nlohmann::json::array();
  for (const Camera& camera : world.cameras) {
    cameras.push_back({{"name", camera.name},
                       {"position", {camera.position.x, camera.position.y, camera.position.z}},
                       {"yaw", camera.yaw},
                       {"pitch", camera.pitch},
                       {"fov", camera.fov}});
  }
  return {{"name", world.name},
          {"exercises", world.exercises},
          {"origin", {origin.x, origin.y, origin.z}},
          {"size", {size.x, size.y, size.z}},
          {"dimension", world.environment.dimension},
          {"time", world.environment.time},
          {"blocks", facts.blocks},
          {"states", facts.states},
          {"faces", facts.faces},
          {"lights", facts.lights},
          {"unknown", facts.unknown},
          {"entities", world.content.entities.size()},
          {"texts", world.content.texts.size()},
          {"events", world.events.size()},
          {"cameras", cameras}};
}

void printWorld(const World& world, const WorldFacts& facts, const BlockLook* look) {
  const glm::ivec3 origin = world.blocks.origin(), size = world.blocks.size();
  std::string text = fmt::format("{}\n", world.name);
  if (!world.exercises.empty()) text += fmt::format("  {}\n", world.exercises);
  text += fmt::format("  size        {} x {} x {} blocks from ({}, {}, {})\n", size.x, size.y,
                      size.z, origin.x, origin.y, origin.z);
  text += fmt::format("  dimension   {}, time {}\n", world.environment.dimension,
                      world.environment.time);
  text += fmt::format("  blocks      {} of {} block states\n", facts.blocks, facts.states);
  text += fmt::format("  faces       {}\n", facts.faces);
  text += fmt::format("  lights      {}\n", facts.lights);
  text += fmt::format("  unknown     {}\n", facts.unknown.size());
  text += fmt::format("  entities    {}\n", world.content.entities.size());
  text += fmt::format("  texts       {}\n", world.content.texts.size());
  text += fmt::format("  events      {}\n", world.events.size());
  if (look) text += lookText(*look);
  for (const Camera& camera : world.cameras) {
    text += fmt::format("  camera      {}: {:.2f},{:.2f},{:.2f},{:.1f},{:.1f}\n", camera.name,
                        camera.position.x, camera.position.y, camera.position.z, camera.yaw,
                        camera.pitch);
  }
  printText(text);
}

int runWorld(const WorldOptions& options) {
  Report report(options.output);
  if (!options.exported.empty() && !checkExportPath(options.exported, report)) {
    printJson(nlohmann::json::object(), report);
    return report.status();
  }
  std::optional<World> world = loadScene(options.scene, options.pack.dimension, report);
  if (!world) {
    printJson(nlohmann::json::object(), report);
    return report.status();
  }
  if (!options.exported.empty())
    exportWorld(*world, options.pack, options.exported, report);
  Diagnostics diagnostics;
  const SceneData scene = buildScene(std::move(*world), {}, diagnostics);
  report.add(diagnostics);
  const WorldFacts facts = gatherFacts(scene);
  if (!options.output.json) printWorld(scene.world, facts, scene.look.get());
  nlohmann::json result = worldJson(scene.world, facts);
  if (scene.look) result["resources"] = lookJson(*scene.look);
  printJson(std::move(result), report);
  if (report.status() == kClean && !options.exported.empty())
    sayWritten(options.output, {options.exported});
  return report.status();
}

}  // namespace

void addWorldCommand(CLI::App& app, int& status) {
  const auto options = std::make_shared<WorldOptions>();
  CLI::App* command =
      app.add_subcommand("world", "what is in a world: size, blocks, lights, cameras");
  addWorldArgument(*command, options->scene.path);
  command->add_option("--seed", options->scene.seed, "seed of generated worlds");
  command->add_option("--dimension", options->pack.dimension, "of a save: overworld, the_nether, the_end or a dimension name")
      ->type_name("NAME");
  addSavePartFlags(*command, options->scene.part);
  addResourcesFlag(*command, options->scene.resources);
  CLI::Option* exported =
      command
          ->add_option("--export", options->exported,
                       "write the faces, textures, lights, sky and cameras: .glb or .gltf")
          ->type_name("OUT");
  command->add_option("--time", options->scene.time, "with --export: time of day")
      ->type_name("TICKS")
      ->check(CLI::Range(0, 23999))
      ->needs(exported);
  addAssignmentFlag(*command, "--set", options->pack.values,
                    "with --export: set an option of the reference pack");
  addOutputFlags(*command, options->output);
  command->callback([options, &status] { status = runWorld(*options); });
}

}  // namespace orris
