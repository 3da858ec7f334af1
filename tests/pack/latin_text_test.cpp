#include <orris/pack/properties/latin_text.h>

#include <gmock/gmock.h>

namespace orris {
namespace {

struct Case {
  const char *text, *kept;
  int line;  ///< of the warning; 0: none
};

// Iris's own code read the same files in the same manner.
TEST(LatinText, ends_where_the_preprocessor_of_iris_throws) {
  const Case kCases[] = {
      {"block.1=stone\nblock.2=dirt", "block.1=stone\nblock.2=dirt", 0},
      {"block.1=stone \xC3\xA9 dirt\nblock.2=sand", "block.1=stone \xC3\n\n", 1},
      {"block.1=stone \xC2\xA7\nblock.2=sand", "block.1=stone \xC2\n\n", 1},
      {"block.1=stone // \xC2\xBB dirt\nblock.2=sand",
       "block.1=stone // \xC2\xBB dirt\nblock.2=sand", 0},
      // A letter whose second byte is a control character is a name.
      {"block.1=\xD0\x9B\nblock.2=sand", "block.1=\xD0\x9B\nblock.2=sand", 0},
      {"\xEF\xBB\xBF"
       "block.1=stone\nblock.2=sand",
       "\xEF\n\n", 1},
      {"block.1=a @ $ ` ~ ? dirt\nblock.2=sand", "block.1=a @ $ ` ~ ? dirt\nblock.2=sand", 0},
  };
  for (const Case& test : kCases) {
    Diagnostics diagnostics;
    EXPECT_EQ(upToForeignCharacter("/f", test.text, test.text, diagnostics), test.kept);
    EXPECT_EQ(diagnostics.empty() ? 0 : diagnostics[0].at.line, test.line) << test.text;
  }
}

TEST(LatinText, a_byte_may_end_the_line_of_a_comment) {
  Diagnostics diagnostics;
  const std::string original = "# \xE5\x8F\x91\xE5\x85\x89\nblock.1=stone\n";
  EXPECT_EQ(upToForeignCharacter("/f", original, "\nblock.1=stone\n", diagnostics), "\n\n");
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics[0].at, (SourceLocation{"/f", 1, 8}));
  // Comments without such a byte are no matter.
  EXPECT_EQ(upToForeignCharacter("/f", "# \xC2\xA7\nblock.1=a\n", "\nblock.1=a\n", diagnostics),
            "\nblock.1=a\n");
}

}  // namespace
}  // namespace orris
