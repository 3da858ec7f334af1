#include "app/gallery/gallery_drawing.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "app/input/inputs.h"
#include <orris/check/workers/diagnostic_codec.h>
#include <orris/check/workers/isolated_jobs.h>
#include <orris/core/work_record.h>
#include <orris/image/codecs/image_codecs.h>
#include <orris/validate/driver_check.h>

namespace orris {
namespace {

using nlohmann::json;

constexpr std::size_t kNumberBytes = std::size_t{16} << 20;  // of all that comes beside the pixels

/// What a worker keeps from one picture to the next: never destroyed, its process ends without cleaning up.
struct GalleryWorker {
  gl::Context* context = nullptr;
  std::shared_ptr<ProgramPool> pool = std::make_shared<ProgramPool>();
};

std::string encodeDrawn(const GalleryDrawn& drawn) {
  const std::string found = encodeDiagnostics(drawn.diagnostics);
  json value = {{"diagnostics", json::binary({found.begin(), found.end()})}};
  if (drawn.picture) {
    value["numbers"] = writeGalleryNumbers(*drawn.picture);
    value["width"] = drawn.picture->image.width;
    value["height"] = drawn.picture->image.height;
    value["pixels"] = json::binary(drawn.picture->image.pixels);
  }
  std::string bytes;
  json::to_cbor(value, bytes);
  return bytes;
}

/// The worker may have been taken over: what it sends is checked.
std::optional<GalleryDrawn> decodeDrawn(const std::string& bytes, ImageSize size) {
  GalleryDrawn drawn;
  try {
    const json value = json::from_cbor(bytes);
    const auto& found = value.at("diagnostics").get_binary();
    drawn.diagnostics = decodeDiagnostics({reinterpret_cast<const char*>(found.data()), found.size()});
    if (!value.contains("numbers")) return drawn;
    drawn.picture = parseGalleryNumbers(value.at("numbers").get<std::string>());
    const auto& pixels = value.at("pixels").get_binary();
    Image8 image(size.width, size.height, 3);
    if (!drawn.picture || value.at("width") != size.width || value.at("height") != size.height ||
        pixels.size() != image.pixels.size())
      return std::nullopt;
    image.pixels = pixels;
    drawn.picture->image = std::move(image);
  } catch (const json::exception&) {
    return std::nullopt;
  }
  return drawn;
}

PackOptions packForShot(const GalleryOptions& options, const GalleryShot& shot, bool before) {
  PackOptions pack = options.pack;
  if (before) pack.path = options.against;
  if (!shot.profile.empty()) pack.profile = shot.profile;
  for (const auto& [name, value] : shot.values) pack.values[name] = value;
  return pack;
}

std::optional<World> worldOf(const GalleryOptions& options, const GalleryShot& shot, const std::string& path,
                             Report& report) {
  SceneOptions scene;
  scene.path = path;
  scene.time = shot.time;
  auto world = loadScene(scene, options.pack.dimension, report);
  if (world) applyWeather(shot.weather, world->environment);
  return world;
}

void reportLeftOut(const std::vector<std::string>& names, bool allowed, Diagnostics& diagnostics) {
  if (names.empty()) return;
  Diagnostic& found = diagnostics.emplace_back();
  found.severity = allowed ? Severity::Warning : Severity::Error;
  found.id = "program-left-out";
  found.message = fmt::format("left out of the picture, because this driver cannot run it: {}", fmt::join(names, ", "));
  if (!allowed) found.hint = "with --allow-missing this is a warning";
}

/// In a worker.
GalleryDrawn drawOne(const GalleryOptions& options, const GalleryInput& input, const GalleryJob& job,
                     GalleryWorker& worker) {
  const GalleryShot& shot = input.set.shots[job.shot];
  GalleryDrawn drawn;
  Report report = Report::keeping();
  auto world = worldOf(options, shot, input.worlds[job.shot], report);
  const auto camera = world ? chooseCamera(*world, shot.camera, report, "cameras") : std::nullopt;
  PackOptions pack = packForShot(options, shot, job.before);
  if (world && pack.dimension.empty()) pack.dimension = world->environment.dimension;
  const auto files = job.before ? input.filesBefore : input.files;
  const auto load = camera ? makeLoadRequest(files, pack, {}, report) : std::nullopt;
  drawn.diagnostics = report.all();
  if (!worker.context)
    worker.context = gl::createContext({.backend = options.image.backend, .profile = options.image.context},
                                       drawn.diagnostics).release();
  if (!load || !worker.context) return drawn;
  SessionRequest request;
  request.openPack = [files](Diagnostics&) { return files; };
  request.load = *load;
  request.versions = pack.versions;
  request.renderer = {.width = input.size.width, .height = input.size.height, .pool = worker.pool};
  request.camera = *camera;
  drawn.picture = drawGalleryPicture(*worker.context, std::move(request), std::move(*world),
                                     {input.frames, galleryClock(options)}, drawn.diagnostics);
  if (drawn.picture) reportLeftOut(drawn.picture->leftOut, options.allowMissing, drawn.diagnostics);
  return drawn;
}

GalleryDrawn lostPicture(const JobOutcome& outcome, const WorkNote& note, const WorkLimits& limits) {
  const bool late = outcome.kind == JobOutcome::Kind::TimedOut;
  const std::string where = note.where().empty() ? "" : " " + note.where();
  Diagnostic lost;
  lost.id = late ? "frame-timeout" : "driver-died";
  lost.at.file = note.file;
  lost.message = late ? fmt::format("the driver took longer than {} s of processor time for the picture{}",
                                    frameTimeOf(limits).count(), where)
                      : fmt::format("the driver died{} ({})", where, outcome.cause);
  lost.hint = late ? "look for loops and dispatches without end; on a slow machine give more time with --frame-limit, "
                     "or draw fewer or smaller frames"
                   : "leave out parts of the program until it is drawn: players' drivers may die on the same "
                     "lines; or allow more with --memory-limit";
  return {std::nullopt, {lost}};
}

GalleryDrawn unreadableResult() {
  return {std::nullopt, {{.id = "driver-died", .at = {}, .message = "the process that drew sent no picture"}}};
}

}  // namespace

FrameClock galleryClock(const GalleryOptions& options) {
  return gl::isSoftware(options.image.backend) ? FrameClock::Processor : FrameClock::Wall;
}

void drawGallery(const GalleryOptions& options, const GalleryInput& input,
                 const std::vector<GalleryJob>& jobs,
                 std::optional<std::chrono::steady_clock::time_point> until,
                 const std::function<void(std::size_t job, GalleryDrawn drawn)>& take) {
  const bool software = gl::isSoftware(options.image.backend);
  const WorkRecord record;
  GalleryWorker worker;  // each process has its own
  Diagnostics reportedWhenUsed;
  imageCodecs("", reportedWhenUsed);  // a worker could not load them
  IsolatedJobs isolated;
  isolated.count = jobs.size();
  isolated.work = [&](std::size_t i) { return encodeDrawn(drawOne(options, input, jobs[i], worker)); };
  isolated.time = frameTimeOf(options.limits);
  isolated.memoryBytes = parseMemory(options.limits.memory).value_or(driverMemory(software));
  isolated.resultBytes = std::size_t(input.size.width) * std::size_t(input.size.height) * 3 + kNumberBytes;
  isolated.confined = software;
  isolated.driver = true;
  isolated.until = until;
  runIsolated(isolated, [&](std::size_t i, const JobOutcome& outcome) {
    if (outcome.kind == JobOutcome::Kind::Done)
      take(i, decodeDrawn(outcome.result, input.size).value_or(unreadableResult()));
    else
      take(i, lostPicture(outcome, record.read(), options.limits));
    return true;
  });
}

}  // namespace orris
