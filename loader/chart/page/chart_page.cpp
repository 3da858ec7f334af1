#include <orris/chart/page/chart_page.h>

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include <orris/chart/page/chart_text.h>
#include <orris/chart/page/embedded.h>
#include <orris/chart/page/page_template.h>
#include <orris/chart/study/json_number.h>

namespace orris {
namespace {

using nlohmann::json;

std::string sizeText(ImageSize size) { return fmt::format("{}x{}", size.width, size.height); }

json pageJson(const ChartPoint& point, const SettingPictures& pictures) {
  const ErrorSummary& error = *point.result->error;
  return {{"label", point.setting->label},
          {"ms", jsonNumber(point.milliseconds.value)},
          {"bias", jsonNumber(error.bias)},
          {"noise", jsonNumber(error.noise)},
          {"front", point.front},
          {"frame", dataUri("image/png", pictures.frame)},
          {"mean", dataUri("image/png", pictures.mean)},
          {"difference", dataUri("image/png", pictures.error)}};
}

/// In a script element: no "</script>" may come of it.
std::string scriptText(const json& value) {
  std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace), result;
  for (const char c : text) result += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return result;
}

}  // namespace

std::string chartPage(const ChartData& chart, const PagePictures& pictures) {
  json points = json::array(), references = json::object(), plots = json::array(),
       facts = json::array();
  for (std::size_t i = 0; i < chart.points.size(); ++i)
    points.push_back(pageJson(chart.points[i], pictures.settings[i]));
  for (const auto& [size, picture] : pictures.references)
    references[sizeText(size)] = dataUri("image/png", picture);
  for (const auto& [name, svg] : pictures.plots)
    plots.push_back({{"name", name}, {"picture", dataUri("image/svg+xml", svg)}});
  for (const auto& [name, text] : chart.request.facts) facts.push_back({name, text});
  const json data = {
      {"title", chart.request.title},
      {"table", settingsTable(chart)},
      {"noiseFloor", chart.request.noiseFloor},
      {"again", chart.again ? json{chart.again->ratio, chart.again->ratioInterval.low,
                                   chart.again->ratioInterval.high}
                            : json(nullptr)},
      {"facts", std::move(facts)},
      {"points", std::move(points)},
      {"references", std::move(references)},
      {"plots", std::move(plots)}};
  std::string page(kPageTemplate);
  const std::string_view mark = "/*CHART*/";
  page.replace(page.find(mark), mark.size(), scriptText(data));
  return page;
}

}  // namespace orris
