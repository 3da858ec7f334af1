// orris trace: a path-traced reference of the picture that the reference pack draws.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/commands.h"
#include "app/commands/trace_loop.h"
#include "app/commands/trace_scene_input.h"
#include "app/input/common.h"
#include "app/input/inputs.h"
#include <orris/image/image.h>
#include <orris/trace/edge_pixels.h>
#include <orris/trace/film/checkpoint.h>
#include <orris/trace/film/traced_picture.h>
#include <orris/trace/shadow_mask.h>

namespace orris {
namespace {

struct TraceOptions {
  PackOptions pack;
  SceneOptions scene;
  ImageOptions image;
  OutputOptions output;
  std::string picture, shard;
  std::vector<std::string> merge;
  TraceLimits limits;
  int bounces = -1, jobs = 0;
  bool resume = false;
  bool shadowMask = false;
  std::string lamp;
};

bool checkOutput(const std::string& path, Report& report) {
  if (std::filesystem::path(path).extension() == ".exr") return checkWritable(path, report);
  report.error("picture-format-unknown", "only .exr holds linear light and both halves",
               "name a file that ends in .exr", path);
  return false;
}

/// The film to start from: shards put together, a film to go on with, or an empty one.
std::optional<TraceFilm> openFilm(const TraceOptions& options, const TraceCamera& camera,
                                  std::uint64_t key, Report& report) {
  const auto shard = parseShard(options.shard).value_or(Shard{1, 1});
  TraceFilm fresh(camera.width, camera.height, {shard.first - 1, shard.second});
  Diagnostics diagnostics;
  std::optional<TraceFilm> film;
  const std::string checkpoint = checkpointOf(options.picture);
  if (!options.merge.empty()) {
    std::vector<TraceFilm> parts;
    for (const std::string& path : options.merge) {
      auto part = readCheckpoint(path, key, diagnostics);
      if (part) parts.push_back(std::move(*part));
    }
    if (diagnostics.empty()) film = mergeShards(parts, options.merge, diagnostics);
  } else if (options.resume && std::filesystem::exists(checkpoint)) {
    film = readCheckpoint(checkpoint, key, diagnostics);
    if (film && !(film->shard == fresh.shard)) {
      report.error("checkpoint-read",
                   fmt::format("is shard {}/{}", film->shard.index + 1, film->shard.count),
                   "give the --shard that it was made with", checkpoint);
      film.reset();
    }
  } else {
    film = std::move(fresh);
  }
  report.add(diagnostics);
  return film;
}

nlohmann::json describeTrace(const TraceFilm& film, const TraceProgress& done,
                             const TraceScene& scene, std::ptrdiff_t edges) {
  const TraceNoise noise = film.noise();
  const auto perSecond = [&](std::uint64_t count) {
    return done.seconds > 0 ? double(count) / done.seconds : 0;
  };
  return {{"size", {film.width, film.height}},
          {"shard", fmt::format("{}/{}", film.shard.index + 1, film.shard.count)},
          {"samples", 2 * film.samples},
          {"seconds", done.seconds},
          {"stoppedBy", done.stoppedBy},
          {"rays",
           {{"camera", done.rays.camera},
            {"path", done.rays.path},
            {"lamp", done.rays.lamp},
            {"sun", done.rays.sun}}},
          {"raysPerSecond", perSecond(done.rays.total())},
          {"mean", noise.mean},
          {"noise", {{"rms", noise.rms}, {"relative", noise.relative}, {"median", noise.median}}},
          {"edgePixels", edges},
          {"quads", scene.grid.quads().size()},
          {"lampFaces", scene.lamps.faces().size()}};
}

int runTrace(const TraceOptions& options, Report& report, nlohmann::json& result) {
  if (!checkOutput(options.picture, report)) return report.status();
  const auto view = openReferenceScene(options.pack, options.scene, options.image, report);
  if (!view) return report.status();
  const TraceSettings settings{options.scene.seed, options.bounces};
  const std::uint64_t key = traceKey(view->scene, view->camera, settings);
  auto film = openFilm(options, view->camera, key, report);
  if (!film) return report.status();

  TraceProgress done;
  Diagnostics diagnostics;
  if (options.merge.empty()) {
    const TraceJob job{
        view->scene, view->camera, settings, options.jobs, checkpointOf(options.picture), key};
    withTraceHooks(report, [&](const TraceHooks& hooks) {
      done = traceUntil(*film, job, options.limits, hooks, diagnostics);
    });
    report.add(diagnostics);
    if (report.status() != kClean) return report.status();
  }
  const std::vector<std::uint8_t> edges = edgePixels(view->scene, view->camera);
  const bool written = writeTraced(options.picture, *film, edges, diagnostics);
  report.add(diagnostics);
  if (!written) return report.status();
  result = describeTrace(*film, done, view->scene, std::count(edges.begin(), edges.end(), 1));
  if (!options.output.json && !options.output.quiet) {
    std::cout << fmt::format("{} samples a pixel, noise {:.3g} % rms of the mean\n",
                             2 * film->samples, 100 * film->noise().relative);
  }
  sayWritten(options.output, {options.picture});
  return report.status();
}

/// "x,y,z" in world blocks.
std::optional<glm::dvec3> placeOf(const std::string& text) {
  glm::dvec3 place(0);
  char end = 0;
  if (std::sscanf(text.c_str(), "%lf,%lf,%lf%c", &place.x, &place.y, &place.z, &end) != 3)
    return std::nullopt;
  return place;
}

/// Which pixels the sun, or a lamp, reaches: nothing is sampled.
int runShadowMask(const TraceOptions& options, Report& report, nlohmann::json& result) {
  if (!checkWritable(options.picture, report)) return report.status();
  const auto lamp = placeOf(options.lamp);
  if (!options.lamp.empty() && !lamp) {
    report.error("usage", "--lamp \"" + options.lamp + "\" is no place", "write x,y,z");
    return kUsage;
  }
  const auto view = openReferenceScene(options.pack, options.scene, options.image, report);
  if (!view) return report.status();
  const glm::dvec4 light = lamp ? glm::dvec4(*lamp, 1) : glm::dvec4(view->shadowLight, 0);
  const ImageF mask = shadowMask(view->scene, view->camera, stoppedByBlocks(view->scene), light);
  Diagnostics diagnostics;
  writeImage(options.picture, mask, diagnostics);
  report.add(diagnostics);
  const auto lit = std::count_if(mask.pixels.begin(), mask.pixels.end(),
                                 [](float value) { return value > 0.5f; });
  result = {{"size", {mask.width, mask.height}}, {"lit", lit}};
  if (!options.output.json && !options.output.quiet)
    std::cout << fmt::format("{} of {} pixels lit\n", lit, mask.pixels.size());
  if (report.status() == kClean) sayWritten(options.output, {options.picture});
  return report.status();
}

void addTraceFlags(CLI::App& command, TraceOptions& options) {
  command.add_option("-o,--output", options.picture, "picture: .exr, with both halves")
      ->type_name("OUT")
      ->required();
  command.add_option("--samples", options.limits.samples, "stop at this many samples a pixel")
      ->check(CLI::Range(2u, 1u << 30));
  command.add_option("--seconds", options.limits.seconds, "stop after this time")
      ->check(checkPositive);
  command
      .add_option("--noise", options.limits.noise, "stop at this noise: rms over the mean, 0.01")
      ->check(checkPositive);
  command
      .add_option("--bounces", options.bounces,
                  "cut light off after this many rays in a row; 0: direct sun only")
      ->check(CLI::Range(0, 4096));
  command.add_option("--jobs", options.jobs, "threads; default as many as the machine has")
      ->check(CLI::Range(1, 1024));
  addShardFlag(command, options.shard, "trace only part I of N of the picture: I/N");
  command.add_option("--merge", options.merge, "put shards together: their OUT.trace files")
      ->type_name("FILE")
      ->excludes("--shard");
  command.add_flag("--shadow-mask", options.shadowMask,
                   "write which pixels the sun reaches, by one ray each: .png or .exr");
  command.add_option("--lamp", options.lamp, "with --shadow-mask: a lamp at x,y,z instead")
      ->type_name("PLACE")
      ->needs("--shadow-mask");
  command.add_flag("--resume", options.resume, "go on from OUT.trace, if there is one")
      ->excludes("--merge");
}

}  // namespace

void addTraceCommand(CLI::App& app, int& status) {
  const auto options = std::make_shared<TraceOptions>();
  CLI::App* command =
      app.add_subcommand("trace", "path-trace the reference picture of a world, with its noise");
  addWorldArgument(*command, options->scene.path);
  addTraceFlags(*command, *options);
  addPackFlags(*command, options->pack);
  addSceneFlags(*command, options->scene);
  addSizeFlag(*command, options->image);
  addOutputFlags(*command, options->output);
  command->callback([options, &status] {
    Report report(options->output);
    nlohmann::json result = nlohmann::json::object();
    status = (options->shadowMask ? runShadowMask : runTrace)(*options, report, result);
    result["status"] = status;
    printJson(std::move(result), report);
  });
}

}  // namespace orris
