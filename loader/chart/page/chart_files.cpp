#include <orris/chart/page/chart_files.h>

#include <fmt/format.h>

#include <filesystem>
#include <map>

#include <orris/chart/page/chart_page.h>
#include <orris/core/files/named_file.h>

namespace orris {
namespace {

/// The plots as SVG, by name. nullopt: see diagnostics.
std::optional<std::map<std::string, std::string>> writePlots(const ChartData& chart,
                                                             const std::filesystem::path& folder,
                                                             const Plotter& plot, Diagnostics& diagnostics) {
  std::map<std::string, std::string> drawn;
  for (const PlotScript& script : plotScripts(chart)) {
    const std::string path = (folder / script.name).string();
    if (!writeNamedFile(path + ".gp", script.text, diagnostics)) return std::nullopt;
    for (const std::string ending : {".svg", ".png"}) {
      const auto picture = plot(script, ending);
      if (!picture) continue;
      if (!writeNamedFile(path + ending, *picture, diagnostics)) return std::nullopt;
      if (ending == ".svg") drawn[script.name] = *picture;
    }
  }
  return drawn;
}

/// A file of the study, "" when it is not there.
std::string contentOf(const std::string& path, Diagnostics& diagnostics) {
  if (!std::filesystem::exists(path)) return "";
  return readNamedFile(path, diagnostics).value_or("");
}

PagePictures picturesOf(const ChartData& chart, const StudyFiles& files, Diagnostics& diagnostics) {
  PagePictures pictures;
  for (const ChartPoint& point : chart.points) {
    const ImageSize size = point.setting->size;
    const auto content = [&](const char* ending) {
      return contentOf(files.settingPath(point.setting->label, ending), diagnostics);
    };
    pictures.settings.push_back({content(".png"), content(".mean.png"), content(".error.png")});
    pictures.references[size] = contentOf(
        files.path(fmt::format("reference-{}x{}", size.width, size.height), ".png"), diagnostics);
  }
  return pictures;
}

}  // namespace

bool writeChart(const ChartData& chart, const StudyFiles& files, const Plotter& plot, Diagnostics& diagnostics) {
  const std::filesystem::path folder = files.folder();
  const auto write = [&](const char* name, const std::string& text) {
    return writeNamedFile((folder / name).string(), text, diagnostics);
  };
  if (!write("settings.csv", settingsCsv(chart)) || !write("passes.csv", passesCsv(chart)) ||
      !write("frames.csv", accumulatedCsv(chart)))
    return false;
  const auto plots = writePlots(chart, folder, plot, diagnostics);
  if (!plots) return false;
  PagePictures pictures = picturesOf(chart, files, diagnostics);
  pictures.plots = *plots;
  return write("index.html", chartPage(chart, pictures));
}

}  // namespace orris
