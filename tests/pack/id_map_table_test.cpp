// Ids of block states and names. Contract: idmaps.csv. Iris: IdMap, BlockEntry,
// BlockMaterialMapping.
#include <gmock/gmock.h>

#include <orris/glsl/preprocess/preprocessor.h>
#include <orris/pack/ids/id_map.h>

namespace orris {
namespace {

using States = std::map<std::string, std::string>;

struct BlockCase {
  const char* text;
  const char* block;
  States states;
  int id;
};

int idOf(const BlockCase& test, Diagnostics& diagnostics) {
  const MacroDefinitions macros{{"MC_VERSION", "12101"}, {"GLOW", "1"}, {"WATER_ID", "32"}};
  const std::string file = "/block.properties";
  const std::string active = preprocessProperties(file, test.text, macros, diagnostics);
  return parseBlockProperties(file, active, test.text, diagnostics).idOf(test.block, test.states);
}

TEST(IdMapTable, blocks) {
  const BlockCase kCases[] = {
      {"block.1=stone", "minecraft:stone", {}, 1},
      {"block.1 = minecraft:stone", "minecraft:stone", {}, 1},
      {"block.1:stone", "minecraft:stone", {}, 1},
      {"block.1 stone", "minecraft:stone", {}, 1},
      {"  block.1=stone\tdirt   sand", "minecraft:sand", {}, 1},
      {"block.1=mod:stone", "minecraft:stone", {}, -1},
      {"block.1=mod:stone", "mod:stone", {}, 1},
      {"block.1=", "minecraft:stone", {}, -1},
      {"block.0=stone", "minecraft:stone", {}, 0},
      {"block.2147483646=stone", "minecraft:stone", {}, 2147483646},
      // States.
      {"block.1=lamp:lit=true", "minecraft:lamp", {{"lit", "true"}}, 1},
      {"block.1=lamp:lit=true", "minecraft:lamp", {{"lit", "false"}}, -1},
      {"block.1=mod:lamp:lit=true", "mod:lamp", {{"lit", "true"}}, 1},
      {"block.1=lamp:lit=true:on=1", "minecraft:lamp", {{"lit", "true"}, {"on", "2"}}, -1},
      {"block.1=lamp:lit=true,false", "minecraft:lamp", {{"lit", "false"}}, 1},
      {"block.1=lamp:lit=true:lit=false", "minecraft:lamp", {{"lit", "false"}}, 1},
      {"block.1=lamp:age=1,2", "minecraft:lamp", {{"age", "3"}}, -1},
      // The first that fits counts; of a key the last line, at the place of the first.
      {"block.1=lamp\nblock.2=lamp:lit=true", "minecraft:lamp", {{"lit", "true"}}, 1},
      {"block.2=lamp:lit=true\nblock.1=lamp", "minecraft:lamp", {{"lit", "true"}}, 2},
      {"block.2=lamp:lit=true\nblock.1=lamp", "minecraft:lamp", {{"lit", "false"}}, 1},
      {"block.9=lamp\nblock.2=lamp", "minecraft:lamp", {}, 9},
      {"block.1=lamp\nblock.1=stone", "minecraft:lamp", {}, -1},
      {"block.1=stone\nblock.2=lamp\nblock.1=lamp", "minecraft:lamp", {}, 1},
      // Tags come after all names.
      {"block.1=%logs\nblock.2=oak_log", "minecraft:oak_log", {}, 2},
      {"block.1=%logs\nblock.2=oak_log", "minecraft:birch_log", {}, 1},
      {"block.1=%minecraft:logs:axis=y", "minecraft:oak_log", {{"axis", "y"}}, 1},
      {"block.1=%mod:unknown", "minecraft:oak_log", {}, -1},
      // Continued lines.
      {"block.1=stone \\\n dirt", "minecraft:dirt", {}, 1},
      {"block.1=\\\nstone \\\n dirt", "minecraft:dirt", {}, 1},
      {"block.1=stone\\\n dirt", "minecraft:dirt", {}, -1},  // one word, as blanks are dropped
      {"block.1=stone \\   \n dirt", "minecraft:dirt", {}, 1},
      {"block.1=stone \\\n\n\n dirt", "minecraft:dirt", {}, 1},
      // Preprocessing.
      {"#if MC_VERSION >= 11300\nblock.1=stone\n#else\nblock.2=stone\n#endif",
       "minecraft:stone",
       {},
       1},
      {"#ifdef GLOW\nblock.1=stone\n#endif", "minecraft:stone", {}, 1},
      {"#ifndef GLOW\nblock.1=stone\n#endif", "minecraft:stone", {}, -1},
      {"block.1=stone \\\n#ifdef GLOW\n dirt \\\n#endif\n sand", "minecraft:dirt", {}, 1},
      {"block.1=stone \\\n#ifndef GLOW\n dirt \\\n#endif\n sand", "minecraft:sand", {}, 1},
      {"block.WATER_ID=water", "minecraft:water", {}, 32},
      {"#block.1=stone", "minecraft:stone", {}, -1},
      {"# if 0\nblock.1=stone", "minecraft:stone", {}, 1},
      {"item.1=stone", "minecraft:stone", {}, -1},
  };
  for (const BlockCase& test : kCases) {
    Diagnostics diagnostics;
    EXPECT_EQ(idOf(test, diagnostics), test.id) << test.text;
    EXPECT_TRUE(diagnostics.empty()) << formatDiagnostic(diagnostics.front());
  }
}

struct ProblemCase {
  const char *text, *message;
};

TEST(IdMapTable, problems_stand_at_the_word) {
  const ProblemCase kCases[] = {
      {"block.x=stone", "id-number 1:1 block.x has no id; the line is ignored"},
      {"block.-1=stone", "id-number 1:1 block.-1 has no id; the line is ignored"},
      {"block.1.5=stone", "id-number 1:1 block.1.5 has no id; the line is ignored"},
      {"block.99999999999=stone", "id-number 1:1 block.99999999999 has no id; the line is ignored"},
      {"block.1=a \\\n  lamp:lit", ""},  // a namespace
      {"block.1=a \\\n  mod:lamp:lit b",
       "id-state 2:3 \"lit\" in mod:lamp:lit is no property=value"},
      {"block.1=a:b:1 a:b:2\nblock.2=a:b:3",
       "id-state 1:9 \"1\" in a:b:1 is no property=value; 2 more words of this file give numbers"},
      {"block.1=stone\n  dirt", "id-stray-line 2:3 this line belongs to no key and is ignored"},
      // Comments that the programs see, and ids that they do not.
      {"/*\nblock.1=stone\n*/\nfloat f(float x) {\n}\n", ""},
      {"/*\nblock.1=stone\n dirt\n*/\n",
       "id-stray-line 3:2 this line belongs to no key and is ignored"},
      {"/* stone\n and dirt */\nblock.1=stone\n// lamps\nblock.2=lamp\n", ""},
      {"layer.glass=stone", "id-layer 1:1 there is no render layer glass"},
  };
  for (const ProblemCase& test : kCases) {
    Diagnostics diagnostics;
    parseBlockProperties("/block.properties", test.text, test.text, diagnostics);
    std::string found;
    for (const Diagnostic& d : diagnostics) {
      found += d.id + " " + std::to_string(d.at.line) + ":" + std::to_string(d.at.column) + " " +
               d.message;
    }
    EXPECT_EQ(found, test.message) << test.text;
  }
}

TEST(IdMapTable, a_state_that_is_none_comes_with_what_was_meant) {
  const auto hintOf = [](const std::string& text) {
    Diagnostics diagnostics;
    parseBlockProperties("/block.properties", text, text, diagnostics);
    return diagnostics.empty() ? "none" : diagnostics.front().hint;
  };
  EXPECT_EQ(hintOf("block.1=mod::lamp"), "write one colon after the namespace");
  EXPECT_EQ(hintOf("block.1=minecraft:stone:3"),
            "numbers of states are of the game before 1.13: Iris leaves this one out, so that all "
            "states match");
  EXPECT_EQ(hintOf("block.1=mod:lamp:lit"), "");
}

TEST(IdMapTable, items_and_entities_take_the_last_line) {  // Iris: IdMap.parseIdMap
  Diagnostics diagnostics;
  const std::string text =
      "item.1=torch "
      "mod:lamp\nitem.2=torch\nitem.3=sword:damage=3\nitem.4=player_cape\nblock.5=dirt\n";
  const std::map<std::string, int> expected{
      {"minecraft:torch", 2}, {"mod:lamp", 1}, {"minecraft:player_cape", 4}};
  EXPECT_EQ(parseIdProperties("/item.properties", text, text, "item.", diagnostics), expected);
  EXPECT_TRUE(diagnostics.empty());
}

}  // namespace
}  // namespace orris
