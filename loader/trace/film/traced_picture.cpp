#include <orris/trace/film/traced_picture.h>

#include <algorithm>
#include <filesystem>

#include <orris/core/add_diagnostic.h>
#include <orris/image/image.h>
#include <orris/trace/edge_pixels.h>
#include <orris/trace/film/checkpoint.h>

namespace orris {

std::string checkpointOf(const std::string& picture) { return picture + ".trace"; }

bool writeTraced(const std::string& path, const TraceFilm& film, const std::vector<std::uint8_t>& edges,
                 Diagnostics& diagnostics) {
  static const std::vector<std::string> kChannels = {
      "R",       "G",        "B",        "first.R",  "first.G",
      "first.B", "second.R", "second.G", "second.B", "undecided.V"};
  const ImageF halves = film.image();
  ImageF image(film.width, film.height, int(kChannels.size()));
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto from = halves.pixels.begin() + std::ptrdiff_t(i * 9);
    const auto to = image.pixels.begin() + std::ptrdiff_t(i * kChannels.size());
    *std::copy(from, from + 9, to) = float(edges[i]);
  }
  return writeImage(path, image, kChannels, diagnostics);
}

bool provideTraced(const std::string& path, const ReferenceScene& view, const TraceSettings& settings,
                   const TraceLimits& limits, const TraceHooks& hooks, Diagnostics& diagnostics) {
  const std::uint64_t key = traceKey(view.scene, view.camera, settings);
  const std::string checkpoint = checkpointOf(path);
  std::optional<TraceFilm> film;
  Diagnostics another;  // of another scene: traced anew
  if (std::filesystem::exists(checkpoint)) film = readCheckpoint(checkpoint, key, another);
  if (film && std::filesystem::exists(path)) return true;
  // One of another scene would pass for this one's beside the checkpoint of work that is stopped.
  std::error_code absent;
  std::filesystem::remove(path, absent);
  if (!film) film = TraceFilm(view.camera.width, view.camera.height, {0, 1});
  const std::size_t before = diagnostics.size();
  const TraceProgress done =
      traceUntil(*film, {view.scene, view.camera, settings, 0, checkpoint, key}, limits, hooks, diagnostics);
  if (diagnostics.size() > before) return false;
  if (done.stoppedBy == "interrupt")
    return addError(diagnostics, "trace-stopped", {path}, "tracing was stopped before its limit",
                    "run the command again: it goes on");
  return writeTraced(path, *film, edgePixels(view.scene, view.camera), diagnostics);
}

}  // namespace orris
