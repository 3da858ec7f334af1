// What the reader of world.json says about mistakes: whole messages with their place.
#include <gtest/gtest.h>

#include "world_helpers.h"

namespace orris {
namespace {

std::string errorsOf(const std::string& text) {
  const ParsedWorld parsed = parseWorld(text);
  EXPECT_FALSE(parsed.world);
  return parsed.errors;
}

/// The message and its place, without the source line.
std::string messageOf(const std::string& text) {
  const std::string errors = errorsOf(text);
  return errors.substr(0, errors.find('\n'));
}

/// Of a world whose only operation stands on the second line.
std::string operationMessage(const std::string& operation) {
  return messageOf("{\"size\": [4, 4, 4], \"palette\": {\"a\": \"stone\"}, \"blocks\": [\n" +
                   operation + "]}");
}

/// Of a world with further members on the second line.
std::string memberMessage(const std::string& members) {
  return messageOf("{\"size\": [2, 2, 2],\n" + members + "}");
}

TEST(WorldJsonErrors, bad_palette_key_is_reported_at_its_character) {
  EXPECT_EQ(errorsOf("{\n"
                     "  \"size\": [4, 1, 2],\n"
                     "  \"palette\": {\"a\": \"stone\", \"#\": \"dirt\"},\n"
                     "  \"blocks\": [\n"
                     "    {\"layers\": [[\"a#.\", \"a#x \"]]}\n"
                     "  ]\n"
                     "}"),
            "world.json:5:28: error: 'x' is not in the palette: expected one of #.a or a space\n"
            "      {\"layers\": [[\"a#.\", \"a#x \"]]}\n"
            "                             ^\n"
            "  hint: add it to \"palette\"");
}

TEST(WorldJsonErrors, all_are_reported_at_once) {
  EXPECT_EQ(errorsOf("{\"size\": [1, 1, 1], \"colour\": 1,\n"
                     " \"environment\": {\"time\": 24000, \"rain\": \"much\"}}"),
            "world.json:1:21: error: unknown key \"colour\" in the world: expected one of name, "
            "exercises, origin, size, from, palette, blocks, cameras, environment, events, "
            "entities, particles, beams, damaged, texts, selected, border\n"
            "  {\"size\": [1, 1, 1], \"colour\": 1,\n"
            "                      ^\n"
            "world.json:2:26: error: \"time\" is 24000: expected an integer from 0 to 23999\n"
            "   \"environment\": {\"time\": 24000, \"rain\": \"much\"}}\n"
            "                           ^\n"
            "world.json:2:41: error: \"rain\" is \"much\": expected a number from 0 to 1\n"
            "   \"environment\": {\"time\": 24000, \"rain\": \"much\"}}\n"
            "                                          ^");
}

TEST(WorldJsonErrors, text_that_is_no_world_says_what_was_expected) {
  EXPECT_EQ(messageOf(""),
            "world.json:1:1: error: syntax error while parsing value - unexpected end of input; "
            "expected '[', '{', or a literal");
  EXPECT_EQ(messageOf("[]"), "world.json:1:1: error: the world is a list of 0: expected an object");
  EXPECT_EQ(messageOf("{}"), "world.json:1:1: error: the world has no \"size\"");
}

TEST(WorldJsonErrors, sizes_out_of_range) {
  EXPECT_EQ(messageOf(R"({"size": [0, 1, 1]})"),
            "world.json:1:11: error: \"size\" is 0: expected an integer from 1 to 512");
  EXPECT_EQ(messageOf(R"({"size": [1, 513, 1]})"),
            "world.json:1:14: error: \"size\" is 513: expected an integer from 1 to 512");
  EXPECT_EQ(messageOf(R"({"size": [1, 1.5, 1]})"),
            "world.json:1:14: error: \"size\" is 1.5: expected an integer from 1 to 512");
  EXPECT_EQ(messageOf(R"({"size": [1, 1]})"),
            "world.json:1:10: error: \"size\" is a list of 2: expected three integers [x, y, z]");
  EXPECT_EQ(messageOf(R"({"size": [99999999999999999999, 1, 1]})"),
            "world.json:1:11: error: \"size\" is 1e+20: expected an integer from 1 to 512");
}

TEST(WorldJsonErrors, wrong_palettes) {
  const auto message = [](const std::string& palette) {
    return messageOf("{\"size\": [1, 1, 1], \"palette\": " + palette + "}");
  };
  EXPECT_EQ(message(R"({"ab": "stone"})"),
            "world.json:1:33: error: the palette key \"ab\" is not one printable ASCII character "
            "other than space and \".\"");
  EXPECT_EQ(message(R"({".": "stone"})"),
            "world.json:1:33: error: the palette key \".\" is not one printable ASCII character "
            "other than space and \".\"");
  EXPECT_EQ(message(R"({"a": "Stone!"})"),
            "world.json:1:38: error: the palette entry \"a\" is \"Stone!\": expected a block state "
            "such as \"oak_stairs[facing=north,half=bottom]\"");
  EXPECT_EQ(message("7"), "world.json:1:32: error: \"palette\" is 7: expected an object");
}

TEST(WorldJsonErrors, wrong_operations) {
  EXPECT_EQ(operationMessage("{}"),
            "world.json:2:1: error: an operation of \"blocks\" is an object with one of \"box\", "
            "\"hollow\", \"replace\", \"block\", \"layers\", \"from\", \"generate\"");
  EXPECT_EQ(operationMessage(R"({"box": "stone", "min": [0, 0, 0]})"),
            "world.json:2:1: error: the operation has no \"max\"");
  EXPECT_EQ(operationMessage(R"({"box": "stone", "min": [0, 0, 0], "max": [4, 0, 0]})"),
            "world.json:2:43: error: \"max\" (4, 0, 0) is outside the world: expected (0, 0, 0) to "
            "(3, 3, 3)");
  EXPECT_EQ(operationMessage(R"({"box": "stone", "min": [1, 0, 0], "max": [0, 0, 0]})"),
            "world.json:2:43: error: \"max\" is below \"min\" on an axis");
  EXPECT_EQ(operationMessage(R"({"block": "stone", "at": [0, 0, 0], "of": 1})"),
            "world.json:2:37: error: unknown key \"of\" in \"block\": expected one of block, at");
  EXPECT_EQ(operationMessage(R"({"layers": [["aaaaa"]]})"),
            "world.json:2:14: error: this row reaches (4, 0, 0), outside the world");
  EXPECT_EQ(operationMessage(R"({"layers": ["aa"]})"),
            "world.json:2:13: error: a layer is \"aa\": expected a list");
  EXPECT_EQ(
      operationMessage(R"({"generate": {"city": {}}})"),
      "world.json:2:15: error: unknown key \"city\" in \"generate\": expected one of terrain");
  EXPECT_EQ(operationMessage(R"({"generate": {"terrain": {}}})"),
            "world.json:2:26: error: the sea level 63 is outside of the box, whose heights are 0 to 3: set "
            "\"seaLevel\" or \"origin\"");
}

TEST(WorldJsonErrors, files_stay_inside_the_folder_and_their_errors_are_reported) {
  const auto message = [](const std::string& path) {
    const WorldFileReader files = [](const std::string& name) {
      return name == "bad.schem" ? std::optional<std::string>("oops") : std::nullopt;
    };
    const ParsedWorld parsed = parseWorld("{\"from\": \"" + path + "\"}", files);
    return parsed.errors.substr(0, parsed.errors.find('\n'));
  };
  EXPECT_EQ(message("../a.schem"),
            "world.json:1:10: error: \"../a.schem\" is not a path inside the world's folder");
  EXPECT_EQ(message("/etc/passwd"),
            "world.json:1:10: error: \"/etc/passwd\" is not a path inside the world's folder");
  EXPECT_EQ(message("none.schem"), "world.json:1:10: error: cannot read \"none.schem\"");
  EXPECT_EQ(message("bad.schem"),
            "world.json:1:10: error: bad.schem: not a schematic: expected gzip data");
}

TEST(WorldJsonErrors, wrong_cameras) {
  EXPECT_EQ(memberMessage(R"("cameras": [{"position": [0, 0, 0]}])"),
            "world.json:2:13: error: a camera has no \"name\"");
  EXPECT_EQ(memberMessage(R"("cameras": [{"name": "a", "position": [0, 0, 0], "yaw": 1,)"
                          R"( "target": [1, 1, 1]}])"),
            "world.json:2:70: error: a camera has either \"target\" or \"yaw\" and \"pitch\"");
  EXPECT_EQ(memberMessage(R"("cameras": [{"name": "a", "position": [0, 0, 0], "fov": 180}])"),
            "world.json:2:57: error: \"fov\" is 180: expected a number from 1 to 170");
  EXPECT_EQ(memberMessage("\"cameras\": [{\"name\": \"a\", \"position\": [0, 0, 0]},\n"
                          "{\"name\": \"a\", \"position\": [1, 0, 0]}]"),
            "world.json:3:1: error: a second camera is named \"a\"");
}

TEST(WorldJsonErrors, wrong_events) {
  EXPECT_EQ(memberMessage(R"("events": [{"frame": 1}])"),
            "world.json:2:12: error: an event has \"frame\" and one of \"set\", \"camera\", "
            "\"option\", \"time\", \"entity\", \"lightning\"");
  EXPECT_EQ(memberMessage(R"("events": [{"frame": -1, "time": 0}])"),
            "world.json:2:22: error: \"frame\" is -1: expected an integer from 0 to 1000000000");
  EXPECT_EQ(memberMessage(R"("events": [{"frame": 1, "camera": "b"}])"),
            "world.json:2:35: error: no camera is named \"b\"");
  EXPECT_EQ(memberMessage(R"("events": [{"frame": 1, "set": {"block": "air", "at": [2, 0, 0]}}])"),
            "world.json:2:55: error: \"at\" is outside the world");
}

}  // namespace
}  // namespace orris
