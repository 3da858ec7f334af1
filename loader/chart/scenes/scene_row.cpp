#include <orris/chart/scenes/scene_row.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <orris/chart/page/pareto.h>

namespace orris {
namespace {

constexpr std::array<const char*, kBiasChannels> kChannelNames = {"red", "green", "blue", "luminance"};
constexpr std::size_t kSmoothed = 8;  // frames

double averageFrom(const std::vector<double>& values, std::size_t first, std::size_t count) {
  const auto begin = values.begin() + std::ptrdiff_t(first);
  return std::accumulate(begin, begin + std::ptrdiff_t(count), 0.0) / double(count);
}

double deviationFrom(const std::vector<double>& values, std::size_t count) {
  const double mean = averageFrom(values, 0, count);
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += (values[i] - mean) * (values[i] - mean);
  return std::sqrt(sum / double(std::max<std::size_t>(count, 2) - 1));
}

double upperRoot(const ChannelBias& bias) { return signedRoot(bias.squareInterval.high); }

std::string inQuotes(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

std::string channelCells(const SceneRow& row, std::size_t channel) {
  const ChannelBias& bias = row.bias[channel];
  return fmt::format(",{:.5f},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f},{:.4f},{:.5f}",
                     signedRoot(bias.square), signedRoot(bias.squareInterval.low), upperRoot(bias),
                     bias.signedMean, bias.signedInterval.low, bias.signedInterval.high, bias.drift,
                     bias.driftInterval.low, bias.driftInterval.high, row.noise[channel],
                     row.noiseMean[channel]);
}

std::string costCells(const PairedCost& cost) {
  if (cost.pairs == 0) return ",,,";
  return fmt::format(",{:.4f},{:.4f},{:.4f}", cost.ratio, cost.ratioInterval.low, cost.ratioInterval.high);
}

std::string csvRow(const SceneRow& row) {
  std::string text = fmt::format("{},{},{},{},{},{},{},{},{:.5f}", inQuotes(row.scene), inQuotes(row.camera),
                                 row.time, inQuotes(row.setting), inQuotes(row.chosen), row.runs, row.warmUp,
                                 row.frames, row.referenceNoise);
  for (std::size_t channel = 0; channel < kBiasChannels; ++channel) text += channelCells(row, channel);
  text += fmt::format(",{:.3f}", row.milliseconds) + costCells(row.cost) + costCells(row.editing) +
          costCells(row.moving);
  return text + fmt::format(",{},{:.2f}\n", row.lag, row.megabytes);
}

/// Those of one setting.
struct Column {
  std::string setting;
  std::vector<double> bias, upper, ratio, editing, moving, noise, lag, megabytes;
};

std::vector<Column> columnsOf(const std::vector<SceneRow>& rows) {
  std::vector<Column> columns;
  for (const SceneRow& row : rows) {
    auto found = std::find_if(columns.begin(), columns.end(),
                              [&](const Column& column) { return column.setting == row.setting; });
    if (found == columns.end()) found = columns.insert(columns.end(), {row.setting, {}, {}, {}, {}, {}, {}, {}, {}});
    const ChannelBias& worst = worstChannel(row);
    found->bias.push_back(signedRoot(worst.square));
    found->upper.push_back(upperRoot(worst));
    if (row.cost.pairs > 0) found->ratio.push_back(row.cost.ratio);
    if (row.editing.pairs > 0) found->editing.push_back(row.editing.ratio);
    if (row.moving.pairs > 0) found->moving.push_back(row.moving.ratio);
    found->noise.push_back(row.noise[kBiasChannels - 1]);
    if (row.lag >= 0) found->lag.push_back(row.lag);
    found->megabytes.push_back(row.megabytes);
  }
  return columns;
}

double shareWithin(const std::vector<double>& values, double limit) {
  return double(std::count_if(values.begin(), values.end(), [=](double value) { return value <= limit; })) /
         double(values.size());
}

std::string numberOrDash(const std::vector<double>& values, double q, int digits) {
  return values.empty() ? "-" : fmt::format("{:.{}f}", quantile(values, q), digits);
}

}  // namespace

int lagOf(const std::vector<double>& brightness, std::size_t changed) {
  if (changed < kSmoothed || brightness.size() < changed + 2 * kSmoothed) return -1;
  const std::size_t after = brightness.size() - changed, tail = after / 4;
  const double before = averageFrom(brightness, 0, changed);
  const double end = averageFrom(brightness, brightness.size() - tail, tail);
  // Of eight frames, whose tenth of the change must stand above their noise.
  const double noise = deviationFrom(brightness, changed) / std::sqrt(double(kSmoothed));
  if (std::abs(end - before) <= 20 * noise) return -1;
  int lag = 0;
  for (std::size_t i = changed; i + kSmoothed <= brightness.size(); ++i)
    if (std::abs(averageFrom(brightness, i, kSmoothed) - end) > 0.1 * std::abs(end - before))
      lag = int(i - changed) + 1;
  return lag + kSmoothed > after - tail ? -1 : lag;
}

const ChannelBias& worstChannel(const SceneRow& row) {
  return *std::max_element(row.bias.begin(), row.bias.begin() + 3, [](const auto& a, const auto& b) {
    return a.squareInterval.high < b.squareInterval.high;
  });
}

std::string sceneRowsCsv(const std::vector<SceneRow>& rows) {
  std::string text = "scene,camera,time,setting,chosen,runs,warm_up,frames,reference_noise";
  for (const char* name : kChannelNames)
    for (const char* value : {"rms", "rms_low", "rms_high", "signed", "signed_low", "signed_high", "drift",
                              "drift_low", "drift_high", "noise", "noise_of_mean"})
      text += fmt::format(",{}_{}", value, name);
  text += ",ms,ratio,ratio_low,ratio_high,editing_ratio,editing_low,editing_high,moving_ratio,moving_low,moving_high,lag,megabytes\n";
  for (const SceneRow& row : rows) text += csvRow(row);
  return text;
}

std::string sceneSummary(const std::vector<SceneRow>& rows) {
  const std::vector<Column> columns = columnsOf(rows);
  std::vector<CostError> points;
  for (const Column& column : columns)
    points.push_back({quantile(column.ratio, 0.5), quantile(column.bias, 0.5)});
  const std::vector<bool> front = paretoFront(points);
  std::string text = "  rms bias, worst channel         scenes within    noise  cost          editing       moving        lag   MB\n"
                     "  median  worst  worst upper end  .03     .05      frame  median  worst median  worst median  worst frames\n";
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const Column& c = columns[i];
    text += fmt::format("{} {:<7} {:<6} {:<16} {:<7.2f} {:<8.2f} {:<6} {:<7} {:<5} {:<7} {:<5} {:<7} {:<5} {:<5} {:<5} {}\n",
                        front[i] ? '*' : ' ', numberOrDash(c.bias, 0.5, 3), numberOrDash(c.bias, 1, 3),
                        numberOrDash(c.upper, 1, 3), shareWithin(c.upper, 0.03), shareWithin(c.upper, 0.05),
                        numberOrDash(c.noise, 0.5, 2), numberOrDash(c.ratio, 0.5, 2), numberOrDash(c.ratio, 1, 2),
                        numberOrDash(c.editing, 0.5, 2), numberOrDash(c.editing, 1, 2), numberOrDash(c.moving, 0.5, 2),
                        numberOrDash(c.moving, 1, 2), numberOrDash(c.lag, 0.5, 0),
                        numberOrDash(c.megabytes, 0.5, 1), c.setting);
  }
  return text;
}

}  // namespace orris
