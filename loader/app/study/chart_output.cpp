#include "app/study/chart_output.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "app/input/inputs.h"
#include "app/output/child_process.h"
#include <orris/chart/page/chart_page.h>
#include <orris/chart/page/chart_text.h>

namespace orris {
namespace {

constexpr std::chrono::seconds kLongestPlot{60};

struct Form {
  const char *ending, *terminal;
};
constexpr Form kForms[] = {
    {".svg", "set terminal svg size 1000,600 font 'sans-serif,12' background rgb 'white'\n"},
    {".png", "set terminal pngcairo size 1000,600 font 'sans,10'\n"},
};

void warn(Report& report, std::string id, std::string message, std::string hint) {
  report.add({.severity = Severity::Warning,
              .id = std::move(id),
              .message = std::move(message),
              .hint = std::move(hint)});
}

/// nullopt: warned.
std::optional<std::string> plot(const PlotScript& script, const Form& form, Report& report) {
  const auto result = runChild({"gnuplot", "-d", "-"}, form.terminal + script.text, kLongestPlot);
  if (result && result->succeeded()) return result->output;
  if (!result || result->missing)
    warn(report, "gnuplot-missing", "the program gnuplot cannot be run: no plots are drawn",
         "install gnuplot-nox");
  else
    warn(report, "gnuplot-failed",
         fmt::format("gnuplot did not draw {}{}: {}", script.name, form.ending,
                     result->exitStatus ? result->errors : "it was stopped"),
         "");
  return std::nullopt;
}

/// The plots as SVG, by name.
std::optional<std::map<std::string, std::string>> writePlots(const ChartData& chart,
                                                             const std::filesystem::path& folder,
                                                             Report& report) {
  std::map<std::string, std::string> drawn;
  for (const PlotScript& script : plotScripts(chart)) {
    const std::string path = (folder / script.name).string();
    if (!writeWholeFile(path + ".gp", script.text, report)) return std::nullopt;
    for (const Form& form : kForms) {
      const auto picture = plot(script, form, report);
      if (!picture) continue;
      if (!writeWholeFile(path + form.ending, *picture, report)) return std::nullopt;
      if (form.ending == std::string(".svg")) drawn[script.name] = *picture;
    }
  }
  return drawn;
}

/// A file of the study, "" when it is not there.
std::string contentOf(const std::string& path, Report& report) {
  if (!std::filesystem::exists(path)) return "";
  return readWholeFile(path, report).value_or("");
}

PagePictures picturesOf(const ChartData& chart, const StudyFiles& files, Report& report) {
  PagePictures pictures;
  for (const ChartPoint& point : chart.points) {
    const ImageSize size = point.setting->size;
    const auto content = [&](const char* ending) {
      return contentOf(files.settingPath(point.setting->label, ending), report);
    };
    pictures.settings.push_back({content(".png"), content(".mean.png"), content(".error.png")});
    pictures.references[size] = contentOf(
        files.path(fmt::format("reference-{}x{}", size.width, size.height), ".png"), report);
  }
  return pictures;
}

}  // namespace

bool writeChart(const ChartData& chart, const StudyFiles& files, Report& report) {
  const std::filesystem::path folder = files.folder();
  const auto write = [&](const char* name, const std::string& text) {
    return writeWholeFile((folder / name).string(), text, report);
  };
  if (!write("settings.csv", settingsCsv(chart)) || !write("passes.csv", passesCsv(chart)) ||
      !write("frames.csv", accumulatedCsv(chart)))
    return false;
  const auto plots = writePlots(chart, folder, report);
  if (!plots) return false;
  PagePictures pictures = picturesOf(chart, files, report);
  pictures.plots = *plots;
  return write("index.html", chartPage(chart, pictures));
}

}  // namespace orris
