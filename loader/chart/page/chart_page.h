// The chart as one HTML file that needs nothing beside it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <orris/chart/page/chart_data.h>

namespace orris {

/// PNG files as bytes; "" for one that is not there.
struct SettingPictures {
  std::string frame, mean, error;
};

struct PagePictures {
  std::vector<SettingPictures> settings;        ///< of the chart's points
  std::map<ImageSize, std::string> references;  ///< PNG
  std::map<std::string, std::string> plots;     ///< SVG by name (PlotScript::name)
};

std::string chartPage(const ChartData& chart, const PagePictures& pictures);

}  // namespace orris
