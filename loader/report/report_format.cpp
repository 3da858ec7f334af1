#include <orris/report/report_format.h>

#include <algorithm>
#include <array>

namespace orris {
namespace {

constexpr std::array<ReportFormat, 5> kFormats = {{
    {"text", writeText},
    {"json", writeJson},
    {"sarif", writeSarif},
    {"junit", writeJunit},
    {"github", writeGithub},
}};

}  // namespace

const ReportFormat* findReportFormat(std::string_view name) {
  const auto found = std::ranges::find(kFormats, name, &ReportFormat::name);
  return found == kFormats.end() ? nullptr : &*found;
}

std::vector<std::string> reportFormatNames() {
  std::vector<std::string> names;
  for (const ReportFormat& format : kFormats) names.emplace_back(format.name);
  return names;
}

}  // namespace orris
