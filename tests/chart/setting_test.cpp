#include <orris/chart/measure/setting.h>

#include <gmock/gmock.h>

namespace orris {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

ShaderPack somePack() {
  ShaderPack pack;
  pack.options.all()["QUALITY"] = {.name = "QUALITY", .values = {"LOW", "HIGH"}};
  pack.options.all()["SHADOWS"] = {
      .name = "SHADOWS", .isBoolean = true, .values = {"true", "false"}};
  pack.properties.profiles = {{.name = "FAST"}, {.name = "FINE"}};
  return pack;
}

std::vector<std::string> messages(const Diagnostics& diagnostics) {
  std::vector<std::string> result;
  for (const Diagnostic& d : diagnostics) result.push_back(d.message + " | " + d.hint);
  return result;
}

std::vector<std::string> labels(const std::vector<std::string>& axes) {
  const ShaderPack pack = somePack();
  std::vector<Axis> parsed;
  for (const std::string& axis : axes) parsed.push_back(parseAxis(axis));
  Diagnostics diagnostics;
  if (!resolveAxes(parsed, pack, diagnostics)) return messages(diagnostics);
  const auto settings = combine(parsed, {64, 36}, diagnostics);
  if (!settings) return messages(diagnostics);
  std::vector<std::string> result;
  for (const Setting& setting : *settings) result.push_back(setting.label);
  return result;
}

TEST(Axes, WithoutValuesTakeAllThereAre) {
  EXPECT_THAT(labels({"QUALITY"}), ElementsAre("QUALITY=LOW", "QUALITY=HIGH"));
  EXPECT_THAT(labels({"profile"}), ElementsAre("profile=FAST", "profile=FINE"));
}

TEST(Axes, MakeEveryCombination) {
  EXPECT_THAT(
      labels({"profile=FINE", "QUALITY=HIGH,LOW,HIGH", "size=32x18,64x36"}),
      ElementsAre("profile=FINE QUALITY=HIGH size=32x18", "profile=FINE QUALITY=HIGH size=64x36",
                  "profile=FINE QUALITY=LOW size=32x18", "profile=FINE QUALITY=LOW size=64x36"));
  EXPECT_THAT(labels({}), ElementsAre("as it is"));
}

TEST(Axes, EveryMistakeIsReportedWithWhatIsNearest) {
  EXPECT_THAT(
      labels({"QALITY", "profile=FAT", "SHADOWS=maybe", "size", "QUALITY=LOW", "QUALITY=HIGH",
              "size=0x3"}),
      ElementsAre("\"QALITY\" is no option of the pack, nor profile or size | did you mean "
                  "QUALITY?",
                  "profile cannot be \"FAT\" | did you mean FAST?",
                  "SHADOWS cannot be \"maybe\" | its values are true, false",
                  "the axis size has no values | write them behind it: size=160x90,320x180",
                  "the axis QUALITY is given twice | give all its values at once: NAME=A,B,C",
                  "the axis size is given twice | give all its values at once: NAME=A,B,C",
                  "size cannot be \"0x3\" | write it as 320x180"));
}

TEST(Axes, MoreThanTheLimitIsRefused) {
  std::vector<Axis> axes;
  for (int i = 0; i < 10; ++i) axes.push_back({"A" + std::to_string(i), {"1", "2"}});
  Diagnostics diagnostics;
  EXPECT_FALSE(combine(axes, {1, 1}, diagnostics));
  EXPECT_THAT(messages(diagnostics),
              ElementsAre("the axes make more than 512 settings | give fewer axes, or fewer "
                          "values: --axis NAME=A,B"));
  axes.pop_back();
  EXPECT_THAT(*combine(axes, {1, 1}, diagnostics), SizeIs(512));
}

TEST(Setting, IsParsedAndIncluded) {
  const ShaderPack pack = somePack();
  Diagnostics diagnostics;
  const auto part = parseSetting("QUALITY=HIGH,profile=FAST", pack, {}, diagnostics);
  ASSERT_TRUE(part);
  Setting setting = *part;
  setting.values["SHADOWS"] = "true";
  setting.size = {8, 8};
  EXPECT_TRUE(includes(setting, *part));
  EXPECT_FALSE(includes(*part, setting));
  const auto sized = parseSetting("size=16x8", pack, {}, diagnostics);
  EXPECT_FALSE(includes(setting, *sized));
  setting.size = {16, 8};
  EXPECT_TRUE(includes(setting, *sized));
  EXPECT_TRUE(diagnostics.empty());
  EXPECT_FALSE(parseSetting("QUALITY", pack, {}, diagnostics));
  EXPECT_FALSE(parseSetting("QUALITY=ULTRA", pack, {}, diagnostics));
  EXPECT_THAT(messages(diagnostics),
              ElementsAre("expected NAME=VALUE, got \"QUALITY\" | separate several with commas",
                          "QUALITY cannot be \"ULTRA\" | its values are LOW, HIGH"));
}

TEST(Setting, GoesOverTheCommandLine) {
  LoadRequest request;
  request.profile = "FAST";
  request.values = {{"QUALITY", "LOW"}, {"SHADOWS", "false"}};
  const Setting setting{.profile = "FINE", .values = {{"QUALITY", "HIGH"}}, .size = {1, 1}};
  const LoadRequest changed = withSetting(request, setting);
  EXPECT_EQ(changed.profile, "FINE");
  EXPECT_EQ(changed.values, (OptionValues{{"QUALITY", "HIGH"}, {"SHADOWS", "false"}}));
  EXPECT_EQ(withSetting(request, {}).profile, "FAST");
}

TEST(Setting, FileNamesStayInTheirFolderAndApart) {
  EXPECT_EQ(fileStem("A=../b").find('/'), std::string::npos);
  EXPECT_NE(fileStem("A=1 B=2"), fileStem("A=1_B=2"));
  EXPECT_LT(fileStem(std::string(5000, 'x')).size(), 100u);
}

}  // namespace
}  // namespace orris
