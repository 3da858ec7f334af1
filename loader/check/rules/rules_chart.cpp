// Charts and tuning.
#include <vector>

#include <orris/check/rules/rule_tables.h>

namespace orris {

std::span<const Rule> chartRules() {
  static const std::vector<Rule> kRules = {
      {"axis-empty", Severity::Error, "an axis of a chart has no values", kUsage},
      {"axis-repeated", Severity::Error, "an axis of a chart is given twice", kUsage},
      {"axis-too-many", Severity::Error, "the axes of a chart make too many settings", kUsage},
      {"axis-unknown", Severity::Error, "an axis names no option, profile or size", kUsage},
      {"axis-value", Severity::Error, "an axis has a value that its option cannot take", kUsage},
      {"baseline-unknown", Severity::Error, "--baseline names no setting of the chart", kUsage},
      {"budget-short", Severity::Error, "the budget ended before the reference was drawn", kUsage},
      {"gallery-before", Severity::Warning, "a picture of the older revision could not be drawn"},
      {"gallery-set", Severity::Error, "a set of pictures cannot be read"},
      {"gallery-unfinished", Severity::Warning, "some pictures of a gallery are not drawn yet"},
      {"gnuplot-failed", Severity::Warning, "gnuplot did not draw a plot"},
      {"gnuplot-missing", Severity::Warning, "gnuplot is not installed"},
      {"mark-syntax", Severity::Error, "--mark has no cost ratio behind its colon", kUsage},
      {"reference-camera", Severity::Error, "a reference names none of several cameras", kUsage},
      {"reference-missing", Severity::Error, "there is nothing to measure errors against", kUsage},
      {"reference-not-finite", Severity::Error,
       "a reference picture holds a value that is no number", kUsage},
      {"reference-size", Severity::Error, "no reference picture has the size of the frames", kUsage},
      {"scenes-syntax", Severity::Error, "the list of --scenes cannot be read", kUsage},
      {"setting-syntax", Severity::Error, "a setting is not written as NAME=VALUE", kUsage},
      {"study-file", Severity::Error, "a file of a chart cannot be read or written"},
      {"study-unfinished", Severity::Warning, "some settings are not measured yet"},
      {"tune-out-of-reach", Severity::Error, "no setting tried is good or fast enough"},
  };
  return kRules;
}

}  // namespace orris
