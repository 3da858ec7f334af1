// en_us.lang says something about everything a menu shows.
#include <gtest/gtest.h>

#include "load_pack.h"

namespace orris::test {
namespace {

class Language : public testing::Test {
 protected:
  const ShaderPack pack_ = loadReferencePack({}).value();
  const std::map<std::string, std::string>& texts_ = pack_.languages.at("en_us");
  void expectText(const std::string& key) { EXPECT_TRUE(texts_.contains(key)) << key; }
};

bool isNumber(const std::string& value) {
  return value.find_first_not_of("-.0123456789") == std::string::npos;
}

TEST_F(Language, names_and_explains_every_option) {
  for (const auto& [name, option] : pack_.options.all()) {
    expectText("option." + name);
    expectText("option." + name + ".comment");
    if (option.isBoolean) continue;
    for (const std::string& value : option.values)
      if (!isNumber(value)) expectText("value." + name + "." + value);
  }
}

TEST_F(Language, names_and_explains_every_screen_and_profile) {
  for (const Screen& screen : pack_.properties.screens) {
    if (screen.name.empty()) continue;
    expectText("screen." + screen.name);
    expectText("screen." + screen.name + ".comment");
  }
  for (const Profile& profile : pack_.properties.profiles) {
    expectText("profile." + profile.name);
    expectText("profile." + profile.name + ".comment");
  }
}

TEST_F(Language, has_no_text_for_what_does_not_exist) {
  for (const auto& [key, text] : texts_) {
    if (!key.starts_with("option.")) continue;
    const std::string name = key.substr(7, key.find('.', 7) - 7);
    EXPECT_TRUE(pack_.options.find(name)) << key;
  }
}

}  // namespace
}  // namespace orris::test
