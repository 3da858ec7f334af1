#include <orris/chart/page/chart_data.h>

#include <gmock/gmock.h>

#include <orris/chart/page/chart_page.h>
#include <orris/chart/page/chart_text.h>

namespace orris {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;
using testing::StartsWith;

/// Settings A=0, A=1 ... of a given cost and error.
class SomeChart : public testing::Test {
 protected:
  void add(const std::string& value, double cost, double error) {
    Setting setting;
    setting.values = {{"A", value}};
    setting.series = value;
    setting.label = "A=" + value;
    setting.size = {8, 4};
    settings_.push_back(setting);
    SettingResult result;
    result.label = setting.label;
    for (int i = 0; i < 3; ++i) result.pairs.push_back({cost, 10});
    result.frames = {cost, cost};
    result.passes = {{"deferred", {cost / 2, cost / 2}}, {"final", {cost / 4}}};
    result.error =
        ErrorSummary{.frames = 4, .bias = error, .accumulated = {{1, error, {error, error}}}};
    result.ssim = 0.5;
    results_.push_back(result);
  }
  ChartData make(ChartRequest request = {}) {
    request.metric = findErrorMetric("error");
    if (request.title.empty()) request.title = "a pack";
    std::vector<const SettingResult*> pointers;
    for (const SettingResult& result : results_) pointers.push_back(&result);
    return makeChart(std::move(request), settings_, pointers);
  }
  std::vector<Setting> settings_;
  std::vector<SettingResult> results_;
};

TEST_F(SomeChart, CostsAreMultiplesOfTheBaseline) {
  add("0", 10, 0.5);
  add("1", 15, 0.2);
  add("2", 20, 0.3);
  // The machine was twice as fast when this one was measured.
  results_[1].pairs = {{7.5, 5}, {7.5, 5}};
  const ChartData chart = make();
  ASSERT_THAT(chart.points, SizeIs(3));
  EXPECT_EQ(chart.points[1].milliseconds.value, 15);
  EXPECT_EQ(chart.points[1].cost.median, 7.5);
  EXPECT_TRUE(chart.points[0].front);
  EXPECT_TRUE(chart.points[1].front);
  EXPECT_FALSE(chart.points[2].front);
}

TEST_F(SomeChart, LeavesOutWhatIsNotMeasuredWhole) {
  add("0", 10, 0.5);
  add("1", 15, 0.2);
  add("2", 20, 0.3);
  results_[1].error.reset();
  results_[2].pairs.clear();
  EXPECT_THAT(make().points, SizeIs(1));
}

TEST_F(SomeChart, MarksWhatWasPublished) {
  add("0", 10, 0.5);
  add("1", 15, 0.2);
  ChartRequest request;
  request.marks = {{Setting{.profile = {}, .values = {{"A", "1"}}}, 1.25}};
  const ChartData chart = make(request);
  EXPECT_FALSE(chart.points[0].published);
  EXPECT_TRUE(chart.points[1].published);
  EXPECT_EQ(chart.points[1].publishedRatio, 1.25);
}

TEST_F(SomeChart, TablesHoldEverySettingWithItsNumbers) {
  add("0", 10, 0.5);
  add("x,\"y\"", 20, 0.25);
  const ChartData chart = make();
  EXPECT_THAT(settingsCsv(chart), StartsWith("setting,size,pairs,ms,ms_low,ms_high,ratio,ratio_low,ratio_high,"));
  EXPECT_THAT(settingsCsv(chart),
              HasSubstr("\"A=x,\"\"y\"\"\",8x4,3,20.0000,20.0000,20.0000,2.0000,2.0000,2.0000,"
                        "20.0000,20.0000,,4,0.25,0,0,0,0,1,0.25,0.25,0.25,0,0,0,0.5,0,1,0\n"));
  EXPECT_EQ(passesCsv(chart),
            "setting,pass,ms\nA=0,deferred,5.0000\nA=0,final,2.5000\n"
            "\"A=x,\"\"y\"\"\",deferred,10.0000\n\"A=x,\"\"y\"\"\",final,5.0000\n");
  EXPECT_EQ(accumulatedCsv(chart),
            "setting,frames,error,error_low,error_high\nA=0,1,0.5,0.5,0.5\n"
            "\"A=x,\"\"y\"\"\",1,0.25,0.25,0.25\n");
}

// gnuplot runs what stands in backquotes and after `system`.
TEST_F(SomeChart, NothingOfAPackReachesGnuplotAsACommand) {
  const std::string evil = "'; system('rm x'); `rm y` \"$(z)\"\n!rm\\";
  add("0", 10, 0.5);
  add(evil, 20, 0.25);
  results_[1].passes[0].name = evil;
  ChartRequest request;
  request.title = evil;
  const std::vector<PlotScript> scripts = plotScripts(make(request));
  ASSERT_THAT(scripts, SizeIs(3));
  for (const PlotScript& script : scripts) {
    EXPECT_THAT(script.text, Not(HasSubstr("`")));
    EXPECT_THAT(script.text, Not(HasSubstr("system('")));
    EXPECT_THAT(script.text, Not(HasSubstr("!")));
    EXPECT_THAT(script.text, Not(HasSubstr("$(")));
  }
}

TEST_F(SomeChart, PrintsTheAARunAndTheNoiseFloor) {
  add("0", 10, 0.5);
  add("1", 20, 0.25);
  SettingResult again;
  again.pairs = {{10.1, 10}, {10.1, 10}};
  ChartRequest request;
  request.again = &again;
  request.noiseFloor = 0.023;
  const ChartData chart = make(request);
  const std::string plot = plotScripts(chart)[0].text;
  EXPECT_THAT(plot, HasSubstr("A/A 1.0100 [1.0100, 1.0100]"));
  EXPECT_THAT(plot, HasSubstr("noise floor of the reference: 2.3 %"));
  EXPECT_THAT(summaryTable(chart), HasSubstr("A/A: 1.0100 [1.0100, 1.0100] of 2 pairs"));
  EXPECT_THAT(summaryTable(chart), HasSubstr("noise floor of the reference: 2.3 %"));
}

TEST_F(SomeChart, PageAndTerminalShowTheSameCells) {
  add("low", 10, 0.5);
  const ChartData chart = make();
  PagePictures pictures;
  pictures.settings.resize(1);
  const std::string page = chartPage(chart, pictures), terminal = summaryTable(chart);
  const TextTable table = settingsTable(chart);
  ASSERT_EQ(table.size(), 2u);
  ASSERT_EQ(table[0].size(), table[1].size());
  EXPECT_THAT(table[0], testing::Contains(chart.request.metric->label)) << "in place of its place holder";
  for (const std::vector<std::string>& cells : table)
    for (const std::string& cell : cells) {
      EXPECT_THAT(page, HasSubstr('"' + cell + '"'));
      EXPECT_THAT(terminal, HasSubstr(cell));
    }
  EXPECT_THAT(settingsCsv(chart), Not(HasSubstr(",,ms"))) << "what has no name there is not there";
}

TEST_F(SomeChart, ThePageHoldsPicturesAndNoWayOutOfItsData) {
  add("</script><b>", 10, 0.5);
  PagePictures pictures;
  pictures.settings = {{"frame", "me", "e"}};
  pictures.references[{8, 4}] = "";
  const std::string page = chartPage(make(), pictures);
  EXPECT_THAT(page, HasSubstr("data:image/png;base64,ZnJhbWU="));
  EXPECT_THAT(page, HasSubstr("data:image/png;base64,bWU="));
  EXPECT_THAT(page, HasSubstr("data:image/png;base64,ZQ=="));
  EXPECT_THAT(page, HasSubstr("\\u003c/script>\\u003cb>"));
  EXPECT_THAT(page, Not(HasSubstr("</script><b>")));
  EXPECT_THAT(page, Not(HasSubstr("http:")));
  EXPECT_THAT(page, Not(HasSubstr("https:")));
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));  // the browser holds it, too
}

TEST_F(SomeChart, WithoutPointsThereIsNothingToDraw) {
  const ChartData chart = make();
  EXPECT_TRUE(chart.points.empty());
  EXPECT_TRUE(plotScripts(chart).empty());
  EXPECT_THAT(chartPage(chart, {}), HasSubstr("</html>"));
}

}  // namespace
}  // namespace orris
