#include <orris/report/problem_list.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace orris {
namespace {

using testing::ElementsAre;

Diagnostic problem(const std::string& message, Severity severity = Severity::Error) {
  Diagnostic d{.severity = severity, .id = "glsl-compile", .at = {"/lib/a.glsl", 3, 1}};
  d.message = message;
  return d;
}

void addOne(ProblemList& list, Diagnostic diagnostic) {
  Diagnostics one{std::move(diagnostic)};
  list.add(one);
  EXPECT_TRUE(one.empty());
}

TEST(ProblemList, aMistakeOfASharedFileIsOneProblemOfItsPrograms) {
  ProblemList list;
  for (const char* program : {"/final.fsh", "/composite.fsh"}) {
    Diagnostic d = problem("a");
    d.includedFrom = {{program, 1, 1}};
    addOne(list, d);
  }
  ASSERT_EQ(list.all().size(), 1u);
  EXPECT_THAT(list.entryFiles(0), ElementsAre("/composite.fsh", "/final.fsh"));
}

TEST(ProblemList, saysUnderWhichSettingsAProblemWasMet) {
  ProblemList list;
  list.setContext("profile LOW");
  addOne(list, problem("a"));
  addOne(list, problem("b"));
  list.setContext("profile HIGH");
  addOne(list, problem("b"));
  list.noteContexts(2);
  EXPECT_THAT(list.all()[0].notes, ElementsAre("first met with profile LOW"));
  EXPECT_TRUE(list.all()[1].notes.empty());
}

TEST(ProblemList, afterAnotherLoadErrorsAreNewAndWarningsThatStayAreNot) {
  ProblemList list;
  addOne(list, problem("a"));
  addOne(list, problem("b", Severity::Warning));
  list.beginAgain();
  addOne(list, problem("a"));
  addOne(list, problem("b", Severity::Warning));
  ASSERT_EQ(list.all().size(), 2u);
  EXPECT_EQ(list.all()[0].message, "b") << "it stayed";
  EXPECT_EQ(list.all()[1].message, "a") << "it came again";
}

TEST(ProblemList, hundredsOfLoadsNeitherFillTheListNorUseUpItsLimits) {
  ProblemList list;
  for (int load = 0; load < 300; ++load) {
    list.beginAgain();
    addOne(list, problem("warning", Severity::Warning));
    const std::size_t before = list.all().size();
    addOne(list, problem("load " + std::to_string(load)));
    addOne(list, problem("the same"));
    ASSERT_EQ(list.all().size(), before + 2) << load;
    ASSERT_EQ(list.all().back().id, problem("").id) << "no message stands for others";
  }
  EXPECT_EQ(list.all().size(), 3u);
}

TEST(ProblemList, errorIsAboutTheRequest) {
  ProblemList list;
  list.error("option-unknown", "no", "other");
  EXPECT_EQ(list.all().at(0).severity, Severity::Error);
  EXPECT_EQ(list.all()[0].hint, "other");
}

}  // namespace
}  // namespace orris
