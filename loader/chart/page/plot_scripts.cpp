// What gnuplot gets. Data stand in the script, so that each is a file of its own that anybody can run
// and change.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

#include <orris/chart/page/chart_text.h>

namespace orris {
namespace {

constexpr std::size_t kMostPasses = 10;
constexpr std::size_t kMostLines = 24;

/// gnuplot runs commands that it finds in backquotes and elsewhere: nothing but these letters passes.
std::string plain(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool safe = std::isalnum(byte) != 0 || byte >= 0x80 ||
                      std::string_view(" ._=-+%,:()/[]").find(c) != std::string_view::npos;
    result += safe ? c : '_';
  }
  return result;
}

/// A logarithmic axis has no place for 0: such values stand below all others, infinity above.
class LogScale {
 public:
  void add(double value) {
    if (!std::isfinite(value) || value <= 0) return;
    least_ = any_ ? std::min(least_, value) : value;
    most_ = any_ ? std::max(most_, value) : value;
    any_ = true;
  }
  double place(double value) const {
    return std::isnan(value) ? bottom() : std::clamp(value, bottom(), most_ * 3);
  }
  double bottom() const { return least_ / 3; }
  /// Range and labels of an axis, "x" or "y".
  std::string axis(const char* name) const {
    const double low = least_ / 1.6, high = most_ * 1.6;
    return fmt::format("set {0}range [{1}:{2}]\nset {0}tics ({3})\n", name, low, high,
                       labels(low, high));
  }

 private:
  /// gnuplot labels powers of ten only, of which there may be none.
  static std::string labels(double low, double high) {
    const double decades = std::log10(high / low);
    std::vector<double> steps = {1};
    if (decades < 4) steps = {1, 2, 5};
    if (decades < 1.2) steps = {1, 1.5, 2, 3, 4, 5, 6, 8};
    std::string text;
    for (int power = int(std::floor(std::log10(low))); std::pow(10, power) <= high; ++power) {
      for (const double step : steps) {
        const double at = step * std::pow(10, power);
        if (at >= low && at <= high)
          text += fmt::format("{}'{:.4g}' {}", text.empty() ? "" : ", ", at, at);
      }
    }
    return text;
  }
  double least_ = 1, most_ = 1;
  bool any_ = false;
};

std::string header(const ChartData& chart) {
  std::string text =
      "set encoding utf8\nset grid back linecolor rgb '#dddddd'\nset key outside right noenhanced\n"
      "set tics noenhanced\n";
  constexpr const char* kColours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                      "#b8860b", "#56b4e9", "#7b3294", "#5d4037",
                                      "#e31a1c", "#33a02c", "#1f3b73", "#ff7f00"};
  for (std::size_t i = 0; i < std::size(kColours); ++i)
    text += fmt::format("set linetype {} linecolor rgb '{}'\n", i + 1, kColours[i]);
  text += fmt::format("set linetype cycle {}\n", std::size(kColours));
  return text + fmt::format("set title '{}' noenhanced\n", plain(chart.request.title));
}

std::string againText(const ChartData& chart) {
  if (!chart.again) return "A/A not measured";
  return fmt::format("A/A {:.4f} [{:.4f}, {:.4f}]", chart.again->ratio,
                     chart.again->ratioInterval.low, chart.again->ratioInterval.high);
}

std::string metricText(const ChartData& chart) {
  const ErrorMetric& metric = *chart.request.metric;
  if (metric.name != std::string_view("error")) return metric.label;
  const int frames = chart.points.front().result->error->after(chart.request.accumulated).frames;
  return fmt::format("{}, of the mean of {} frame{}", metric.label, frames, frames == 1 ? "" : "s");
}

/// The part of a label that its series does not say.
std::string restOf(const Setting& setting) {
  const std::size_t blank = setting.label.find(' ');
  return blank == std::string::npos ? std::string() : plain(setting.label.substr(blank + 1));
}

std::string block(const std::string& name, const std::vector<const ChartPoint*>& points,
                  const LogScale& scale) {
  std::string text = fmt::format("${} << END\n", name);
  for (const ChartPoint* point : points) {
    const Estimate &time = point->milliseconds, &error = point->error;
    text += fmt::format("{} {} {} {} {} {} \"{}\"\n", time.value, scale.place(error.value),
                        time.interval.low, time.interval.high, scale.place(error.interval.low),
                        scale.place(error.interval.high), restOf(*point->setting));
  }
  return text + "END\n";
}

struct Series {
  std::string name;
  std::vector<const ChartPoint*> points;
};

std::vector<Series> seriesOf(const ChartData& chart) {
  std::vector<Series> all;
  for (const ChartPoint& point : chart.points) {
    const std::string name =
        plain(point.setting->series.empty() ? point.setting->label : point.setting->series);
    auto found = std::find_if(all.begin(), all.end(), [&](auto& s) { return s.name == name; });
    if (found == all.end()) found = all.insert(all.end(), Series{name, {}});
    found->points.push_back(&point);
  }
  return all;
}

/// Where the published costs would be, as bars on the lower edge's side of each point.
std::string publishedBlock(const ChartData& chart, const LogScale& scale, double baseline) {
  std::string text = "$ratios << END\n";
  for (const ChartPoint& point : chart.points) {
    if (!point.publishedRatio) continue;
    text += fmt::format("{} {} {} 0\n", point.milliseconds.value, scale.place(point.error.value),
                        *point.publishedRatio * baseline - point.milliseconds.value);
  }
  return text + "END\n";
}

std::vector<const ChartPoint*> pointsWhere(const ChartData& chart, bool ChartPoint::*flag) {
  std::vector<const ChartPoint*> points;
  for (const ChartPoint& point : chart.points)
    if (point.*flag) points.push_back(&point);
  return points;
}

std::string costErrorScript(const ChartData& chart) {
  LogScale scale, times;
  for (const ChartPoint& point : chart.points) {
    scale.add(point.error.value);
    times.add(point.milliseconds.interval.low);
    times.add(point.milliseconds.interval.high);
  }
  const double baseline = chart.points.front().milliseconds.value;
  for (const ChartPoint& point : chart.points)
    if (point.publishedRatio) times.add(*point.publishedRatio * baseline);
  if (chart.request.noiseFloor > 0) scale.add(chart.request.noiseFloor);
  const bool zero = std::any_of(chart.points.begin(), chart.points.end(),
                                [](const auto& point) { return point.error.value <= 0; });
  if (zero) scale.add(scale.bottom());
  const std::vector<Series> series = seriesOf(chart);
  std::vector<const ChartPoint*> front = pointsWhere(chart, &ChartPoint::front);
  std::sort(front.begin(), front.end(),
            [](auto* a, auto* b) { return a->milliseconds.value < b->milliseconds.value; });
  const std::vector<const ChartPoint*> published = pointsWhere(chart, &ChartPoint::published);
  std::string text = header(chart);
  for (std::size_t i = 0; i < series.size(); ++i)
    text += block(fmt::format("series{}", i), series[i].points, scale);
  text += block("front", front, scale) + block("published", published, scale) +
          publishedBlock(chart, scale, baseline);
  text += fmt::format(
      "set logscale xy\nset xlabel '{}' noenhanced\nset ylabel '{}' noenhanced\n",
      plain(fmt::format("milliseconds a frame, with 95 % interval, {}", againText(chart))),
      plain(metricText(chart)));
  text += times.axis("x") + scale.axis("y") + "plot \\\n";
  if (chart.request.noiseFloor > 0)
    text += fmt::format(
        "  {} with lines dashtype 2 linecolor rgb '#888888' title '{}', \\\n",
        chart.request.noiseFloor,
        fmt::format("noise floor of the reference: {:.2g} %", 100 * chart.request.noiseFloor));
  text +=
      "  $front using 1:2 with linespoints linecolor rgb '#000000' dashtype 3 pointtype 6 "
      "pointsize 2.4 title 'Pareto front', \\\n";
  if (!published.empty())
    text +=
        "  $published using 1:2 with points linecolor rgb '#cc0000' pointtype 3 pointsize 2 "
        "title 'published', \\\n"
        "  $ratios using 1:2:3:4 with vectors linecolor rgb '#cc0000' title 'to the published "
        "cost', \\\n";
  for (std::size_t i = 0; i < series.size(); ++i) {
    text += fmt::format(
        "  $series{0} using 1:2:3:4:5:6 with xyerrorbars linetype {1} pointtype 7 title '{2}', \\\n"
        "  $series{0} using 1:2:7 with labels noenhanced left offset 1,0.5 font ',8' notitle{3}\n",
        i, i + 1, series[i].name, i + 1 < series.size() ? ", \\" : "");
  }
  return text;
}

std::string accumulatedScript(const ChartData& chart) {
  LogScale scale;
  const std::size_t lines = std::min(chart.points.size(), kMostLines);
  for (std::size_t i = 0; i < lines; ++i)
    for (const AccumulatedError& run : chart.points[i].result->error->accumulated)
      scale.add(run.error);
  std::string text = header(chart), plots;
  for (std::size_t i = 0; i < lines; ++i) {
    text += fmt::format("$line{} << END\n", i);
    for (const AccumulatedError& run : chart.points[i].result->error->accumulated)
      text += fmt::format("{} {} {} {}\n", run.frames, scale.place(run.error),
                          scale.place(run.interval.low), scale.place(run.interval.high));
    text += "END\n";
    plots += fmt::format("{}  $line{} using 1:2:3:4 with yerrorlines linetype {} title '{}'",
                         i == 0 ? "" : ", \\\n", i, i + 1, plain(chart.points[i].setting->label));
  }
  return text + scale.axis("y") +
         "set logscale xy\nset logscale x 2\nset xlabel 'frames averaged'\n"
         "set ylabel 'relative error, rms'\nplot \\\n" +
         plots + "\n";
}

/// The dearest passes over all settings, in frame order.
std::vector<std::string> dearestPasses(const ChartData& chart) {
  std::map<std::string, double> sums;
  std::vector<std::string> names;
  for (const ChartPoint& point : chart.points) {
    for (const auto& [name, milliseconds] : point.passes) {
      if (!sums.contains(name)) names.push_back(name);
      sums[name] += milliseconds;
    }
  }
  std::vector<std::string> byCost = names;
  std::sort(byCost.begin(), byCost.end(),
            [&](const auto& a, const auto& b) { return sums[a] > sums[b]; });
  byCost.resize(std::min(byCost.size(), kMostPasses));
  std::erase_if(names, [&](const std::string& name) {
    return std::find(byCost.begin(), byCost.end(), name) == byCost.end();
  });
  return names;
}

std::string passesScript(const ChartData& chart) {
  const std::vector<std::string> names = dearestPasses(chart);
  std::string text = header(chart) + "$passes << END\n";
  for (const ChartPoint& point : chart.points) {
    text += fmt::format("\"{}\"", plain(point.setting->label));
    double others = 0;
    std::map<std::string, double> own(point.passes.begin(), point.passes.end());
    for (const auto& [name, milliseconds] : own) others += milliseconds;
    for (const std::string& name : names) {
      others -= own[name];
      text += fmt::format(" {}", own[name]);
    }
    text += fmt::format(" {}\n", std::max(0.0, others));
  }
  text +=
      "END\nset style data histograms\nset style histogram rowstacked\nset style fill solid 0.9\n"
      "set boxwidth 0.8\nset yrange [0:*]\nset ylabel 'milliseconds a frame'\n"
      "set xtics rotate by -25\nset bmargin 9\nset rmargin at screen 0.74\nplot \\\n";
  for (std::size_t i = 0; i < names.size(); ++i)
    text += fmt::format("  $passes using {}:xtic(1) title '{}', \\\n", i + 2, plain(names[i]));
  return text + fmt::format("  $passes using {}:xtic(1) linecolor rgb '#bbbbbb' title 'others'\n",
                            names.size() + 2);
}

}  // namespace

std::vector<PlotScript> plotScripts(const ChartData& chart) {
  if (chart.points.empty()) return {};
  return {{"cost-error", costErrorScript(chart)},
          {"frames", accumulatedScript(chart)},
          {"passes", passesScript(chart)}};
}

}  // namespace orris
