#include <orris/report/baseline.h>

#include <gtest/gtest.h>

namespace orris {
namespace {

Diagnostic problemAt(std::string message, int line, std::string sourceLine) {
  return {.severity = Severity::Warning,
          .id = "option-unused",
          .at = {"/lib/a.glsl", line, 9},
          .message = std::move(message),
          .sourceLine = std::move(sourceLine)};
}

const Diagnostic kProblem = problemAt("option A changes nothing", 7, "#define A");

TEST(Fingerprint, staysWhenTheLineMoves) {
  EXPECT_EQ(fingerprintOf(kProblem),
            fingerprintOf(problemAt("option A changes nothing", 90, "#define A")));
}

TEST(Fingerprint, staysWhenBlanksChange) {
  EXPECT_EQ(fingerprintOf(kProblem),
            fingerprintOf(problemAt("option A changes nothing", 7, "\t#define   A ")));
}

TEST(Fingerprint, staysWhenALineNumberInTheMessageChanges) {
  EXPECT_EQ(fingerprintOf(problemAt("A is 1 here and 2 in /b.glsl:12", 1, "A")),
            fingerprintOf(problemAt("A is 1 here and 2 in /b.glsl:345", 1, "A")));
  EXPECT_EQ(fingerprintOf(problemAt("already defined in line 8; ignored", 1, "A")),
            fingerprintOf(problemAt("already defined in line 19; ignored", 1, "A")));
}

TEST(Fingerprint, changesWithIdFileMessageAndSourceLine) {
  Diagnostic other = kProblem;
  other.id = "option-unknown";
  EXPECT_NE(fingerprintOf(kProblem), fingerprintOf(other));
  other = kProblem;
  other.at.file = "/lib/b.glsl";
  EXPECT_NE(fingerprintOf(kProblem), fingerprintOf(other));
  EXPECT_NE(fingerprintOf(kProblem),
            fingerprintOf(problemAt("option B changes nothing", 7, "#define A")));
  EXPECT_NE(fingerprintOf(kProblem),
            fingerprintOf(problemAt("option A changes nothing", 7, "#define A 1")));
}

// The value is part of files that live in other repositories.
TEST(Fingerprint, isTheSameOnEveryMachine) {
  EXPECT_EQ(fingerprintOf(kProblem), "e37cf50a5bb6d160");
}

std::string read(const std::string& text) {
  Diagnostics diagnostics;
  if (Baseline::parse("known.txt", text, diagnostics)) return "ok";
  return formatDiagnostic(diagnostics.at(0));
}

TEST(Baseline, takesAFingerprintAsOftenAsItWasThere) {
  Diagnostics diagnostics;
  Diagnostic other = kProblem;
  other.at.file = "/b.glsl";
  auto baseline =
      Baseline::parse("known.txt", formatBaseline({kProblem, kProblem, other}), diagnostics);
  ASSERT_TRUE(baseline);
  const std::string fingerprint = fingerprintOf(kProblem);
  EXPECT_TRUE(baseline->take(fingerprint));
  EXPECT_TRUE(baseline->take(fingerprint));
  EXPECT_FALSE(baseline->take(fingerprint));
  EXPECT_FALSE(baseline->take("0123456789abcdef"));
  EXPECT_EQ(baseline->taken(), 2);
  EXPECT_EQ(baseline->left(), 1);
}

TEST(Baseline, isSortedAndReadable) {
  Diagnostic first = kProblem;
  first.at.file = "/a.glsl";
  first.message = "two\nlines";
  const std::string text = formatBaseline({kProblem, first, kProblem});
  EXPECT_EQ(text,
            "# orris baseline 1: known problems, written by orris validate --write-baseline\n" +
                fingerprintOf(first) + " 1 warning option-unused /a.glsl: two lines\n" +
                fingerprintOf(kProblem) +
                " 2 warning option-unused /lib/a.glsl: option A changes nothing\n");
}

TEST(Baseline, mayHoldCommentsBlankLinesAndNothing) {
  EXPECT_EQ(read("# orris baseline 1\r\n\r\n# ours\r\n0123456789abcdef 1\r\n"), "ok");
  EXPECT_EQ(read("# orris baseline 1"), "ok");
}

TEST(Baseline, refusesWhatIsNone) {
  EXPECT_EQ(read(""),
            "known.txt:1: error: a baseline starts with \"# orris baseline 1\"\n"
            "  hint: write the file anew with --write-baseline");
  for (const char* line : {"0123456789abcdef", "0123456789abcdeX 1", "0123456789abcdef 0",
                           "0123456789abcdef many", "0123 1", "0123456789abcdef 99999999999"}) {
    EXPECT_EQ(
        read(std::string("# orris baseline 1\n") + line),
        std::string("known.txt:2: error: expected a fingerprint and how often it may occur\n  ") +
            line + "\n  hint: write the file anew with --write-baseline");
  }
}

}  // namespace
}  // namespace orris
