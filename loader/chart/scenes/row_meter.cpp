#include <orris/chart/scenes/row_meter.h>

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <sstream>

#include <orris/chart/scenes/scene_changes.h>

namespace orris {
namespace {

/// As many as frameCounter has values (plan/frame/frame_state.cpp); a run begins at one of them.
constexpr std::uint64_t kFrameNumbers = 720720;

/// The first frame of a run: far apart and without order, so that no sequence over frames goes on from run to run.
int firstFrameOf(unsigned seed, int run) {
  std::uint64_t value = (std::uint64_t(seed) << 32 | std::uint64_t(run)) + 0x9e3779b97f4a7c15u;
  value = (value ^ value >> 30) * 0xbf58476d1ce4e5b9u;
  value = (value ^ value >> 27) * 0x94d049bb133111ebu;
  value ^= value >> 31;
  return 1 + int(value % (kFrameNumbers - 100000));  // so that no run passes the end
}

double brightnessOf(const ImageF& picture) { return meanLuminance(picture); }

/// Bytes of all buffers that the renderer lists; of depth and what no pack can name four a texel.
double megabytesOf(const FrameRenderer& renderer) {
  std::istringstream names(renderer.bufferNames());
  double bytes = 0;
  std::set<unsigned> counted;
  for (std::string name; names >> name;) {
    for (const bool alt : {false, true}) {
      const gl::Texture* texture = renderer.texture({name, alt});
      if (texture == nullptr || texture->id() == 0 || !counted.insert(texture->id()).second) continue;
      const TextureFormat* format = findFormat(texture->internalFormat);
      bytes += double(texture->width) * texture->height * texture->depth * (format ? format->bytesPerPixel : 4);
    }
  }
  return bytes / 1e6;
}

}  // namespace

/// Sums of the pictures of all runs.
class RowMeter::Sums {
 public:
  explicit Sums(const ReferencePicture& reference) : reference_(reference) {}

  /// One run's frames: halves, and squares for the noise.
  void begin() {
    for (auto* values : {&half_[0], &half_[1], &squares_}) values->assign(reference_.mean.pixels.size() / 3 * 4, 0);
  }
  void add(const ImageF& picture, int half) {
    for (std::size_t i = 0; i < picture.pixels.size() / 3; ++i) {
      const float* rgb = &picture.pixels[i * 3];
      for (std::size_t c = 0; c < kBiasChannels; ++c) {
        const double value = c < 3 ? double(rgb[c]) : luminanceOf(rgb);
        half_[std::size_t(half)][i * 4 + c] += value;
        squares_[i * 4 + c] += value * value;
      }
    }
  }
  void end(int frames) {
    const int firsts = frames / 2, counts[] = {firsts, frames - firsts};
    RunMeans means{reference_.mean, reference_.mean};
    for (std::size_t i = 0; i < reference_.mean.pixels.size(); ++i) {
      const std::size_t at = i / 3 * 4 + i % 3;
      means.first.pixels[i] = float(half_[0][at] / counts[0]);
      means.second.pixels[i] = float(half_[1][at] / counts[1]);
    }
    runs.push_back(std::move(means));
    std::vector<double> mean(squares_.size());
    for (std::size_t i = 0; i < mean.size(); ++i) {
      mean[i] = (half_[0][i] + half_[1][i]) / frames;
      variances_.resize(mean.size());
      variances_[i] += std::max(0.0, squares_[i] / frames - mean[i] * mean[i]) * frames / (frames - 1);
    }
    means_.push_back(std::move(mean));
  }

  /// Relative, rms over the pixels: of a frame, and of the mean of a run.
  void fill(SceneRow& row) const {
    for (std::size_t c = 0; c < kBiasChannels; ++c) {
      double frame = 0, mean = 0;
      const std::size_t pixels = reference_.mean.pixels.size() / 3;
      double average = 0;
      for (std::size_t i = 0; i < pixels; ++i) average += referenceAt(i, c) / double(pixels);
      for (std::size_t i = 0; i < pixels; ++i) {
        const double scale = referenceAt(i, c) + kDarkShare * average;
        if (!(scale > 0)) continue;
        frame += variances_[i * 4 + c] / double(runs.size()) / (scale * scale) / double(pixels);
        mean += varianceOverRuns(i * 4 + c) / (scale * scale) / double(pixels);
      }
      row.noise[c] = std::sqrt(frame);
      row.noiseMean[c] = std::sqrt(mean);
    }
  }

  std::vector<RunMeans> runs;
  std::vector<double> brightness;  ///< of frames before and after a lamp, summed over the runs

 private:
  double referenceAt(std::size_t pixel, std::size_t channel) const {
    const float* rgb = &reference_.mean.pixels[pixel * 3];
    return channel < 3 ? double(rgb[channel]) : luminanceOf(rgb);
  }
  double varianceOverRuns(std::size_t value) const {
    double sum = 0, squares = 0;
    for (const auto& mean : means_) {
      sum += mean[value];
      squares += mean[value] * mean[value];
    }
    const auto count = double(means_.size());
    return std::max(0.0, squares - sum * sum / count) / (count - 1);
  }

  const ReferencePicture& reference_;
  std::vector<double> half_[2], squares_, variances_;
  std::vector<std::vector<double>> means_;
};

bool RowMeter::run(SessionRequest request, int number, Sums& sums, SceneRow& row, Diagnostics& diagnostics) {
  request.firstFrame = firstFrameOf(plan_.seed, number);
  const int judged = plan_.warmUp + plan_.frames;
  const auto session =
      SettingSession::open(context_, request, withLamp(world_, request.camera, judged), diagnostics);
  if (!session) return false;
  row.chosen = session->chosen();
  row.megabytes = megabytesOf(session->renderer());
  sums.begin();
  const int drawn = judged + (plan_.rounds > 0 ? kLagFrames : 0);
  sums.brightness.resize(std::size_t(drawn - plan_.warmUp));
  for (int frame = 0; frame < drawn; ++frame) {
    if (frame == plan_.warmUp) session->stopClock();
    session->draw(diagnostics);
    if (frame < plan_.warmUp) continue;
    const std::optional<ImageF> picture = session->picture(plan_.buffer);
    if (!picture || picture->pixels.size() != reference_.mean.pixels.size()) {
      diagnostics.push_back({.id = "dump-unknown",
                             .message = fmt::format("{} has no buffer {} as large as the screen",
                                                    row.setting, plan_.buffer),
                             .hint = "buffers: " + session->renderer().bufferNames()});
      return false;
    }
    sums.brightness[std::size_t(frame - plan_.warmUp)] += brightnessOf(*picture);
    if (frame < judged) sums.add(*picture, frame - plan_.warmUp < plan_.frames / 2 ? 0 : 1);
  }
  sums.end(plan_.frames);
  return !hasErrors(diagnostics);
}

std::optional<SceneRow> RowMeter::row(const SessionRequest& request, const std::string& setting,
                                        Diagnostics& diagnostics) {
  SceneRow row;
  row.scene = world_.name;
  row.camera = request.camera.name;
  row.setting = setting;
  row.time = world_.environment.time;
  row.runs = plan_.runs;
  row.warmUp = plan_.warmUp;
  row.frames = plan_.frames;
  row.referenceNoise = noiseFloor(reference_);
  Sums sums(reference_);
  for (int number = 0; number < plan_.runs; ++number)
    if (!run(request, number, sums, row, diagnostics)) return std::nullopt;
  row.bias = biasOfRuns(sums.runs, reference_);
  sums.fill(row);
  row.lag = lagOf(sums.brightness, std::size_t(plan_.frames));
  return row;
}

bool RowMeter::addCosts(const std::vector<SessionRequest>& requests, std::vector<SceneRow>& rows,
                          Diagnostics& diagnostics) {
  const World still = withoutEvents(world_);
  const int drawn = plan_.warmUp + 2 * plan_.rounds * (plan_.visit + 1);
  const World edited = withEdits(world_, requests.front().camera, drawn);
  const World moving = withMotion(world_, requests.front().camera, drawn);
  return addCosts(requests, still, &SceneRow::cost, rows, diagnostics) &&
         addCosts(requests, edited, &SceneRow::editing, rows, diagnostics) &&
         addCosts(requests, moving, &SceneRow::moving, rows, diagnostics);
}

bool RowMeter::addCosts(const std::vector<SessionRequest>& requests, const World& world,
                          PairedCost SceneRow::*cost, std::vector<SceneRow>& rows, Diagnostics& diagnostics) {
  std::vector<std::unique_ptr<SettingSession>> sessions;
  for (const SessionRequest& request : requests) {
    sessions.push_back(SettingSession::open(context_, request, world, diagnostics));
    if (!sessions.back()) return false;
    for (int frame = 0; frame < plan_.warmUp; ++frame) sessions.back()->draw(diagnostics);
  }
  std::vector<std::vector<TimePair>> pairs(sessions.size());
  for (int round = 0; round < plan_.rounds; ++round) {
    std::vector<double> sums(sessions.size());
    for (const std::size_t turn : turns(sessions.size()))
      sums[turn] += sessions[turn]->visit(plan_.visit, plan_.clock, diagnostics).mean() / 2;
    for (std::size_t i = 0; i < sessions.size(); ++i) pairs[i].push_back({sums[i], sums[0]});
  }
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    rows[i].*cost = pairedCost(pairs[i]);
    if (cost == &SceneRow::cost) rows[i].milliseconds = (rows[i].*cost).median;
  }
  return !hasErrors(diagnostics);
}

}  // namespace orris
