#include <orris/world/files/world_json.h>

#include <gmock/gmock.h>

#include "nbt_builder.h"
#include "world_helpers.h"

namespace orris {
namespace {

TEST(WorldJson, smallest_world_has_defaults) {
  const ParsedWorld parsed = parseWorld(R"({"size": [3, 4, 5]})");
  ASSERT_TRUE(parsed.world) << parsed.errors;
  EXPECT_EQ(parsed.world->name, "unnamed");
  EXPECT_EQ(parsed.world->blocks.size(), glm::ivec3(3, 4, 5));
  EXPECT_EQ(parsed.world->environment.time, 6000);
  ASSERT_FALSE(parsed.world->cameras.empty());
  EXPECT_EQ(parsed.world->cameras[0].name, "default");
}

TEST(WorldJson, operations_apply_in_order) {
  const ParsedWorld parsed = parseWorld(R"({"size": [5, 5, 5], "origin": [10, 0, -5], "blocks": [
    {"box": "stone", "min": [10, 0, -5], "max": [14, 4, -1]},
    {"box": "air", "min": [11, 1, -4], "max": [13, 3, -2]},
    {"hollow": "glass", "min": [10, 0, -5], "max": [14, 4, -1]},
    {"replace": "glass", "with": "dirt", "min": [10, 0, -5], "max": [14, 0, -1]},
    {"block": "torch", "at": [12, 1, -3]},
    {"block": "lantern[hanging=true]", "at": [[11, 3, -4], [13, 3, -2]]}]})");
  ASSERT_TRUE(parsed.world) << parsed.errors;
  const BlockWorld& blocks = parsed.world->blocks;
  EXPECT_EQ(blocks.at({12, 0, -3}).name, "minecraft:dirt");
  EXPECT_EQ(blocks.at({10, 1, -5}).name, "minecraft:glass");
  EXPECT_EQ(blocks.at({12, 2, -3}).name, "minecraft:air");
  EXPECT_EQ(blocks.at({12, 1, -3}).name, "minecraft:torch");
  EXPECT_EQ(blocks.at({13, 3, -2}).toString(), "minecraft:lantern[hanging=true]");
}

TEST(WorldJson, replace_with_properties_matches_the_exact_state_only) {
  const ParsedWorld parsed = parseWorld(R"({"size": [2, 1, 1], "blocks": [
    {"block": "oak_log[axis=x]", "at": [0, 0, 0]}, {"block": "oak_log[axis=y]", "at": [1, 0, 0]},
    {"replace": "oak_log[axis=x]", "with": "stone"}]})");
  ASSERT_TRUE(parsed.world) << parsed.errors;
  EXPECT_EQ(parsed.world->blocks.at({0, 0, 0}).name, "minecraft:stone");
  EXPECT_EQ(parsed.world->blocks.at({1, 0, 0}).name, "minecraft:oak_log");
}

TEST(WorldJson, layers_run_east_south_up_and_spaces_keep_blocks) {
  const ParsedWorld parsed =
      parseWorld(R"({"size": [4, 3, 3], "palette": {"a": "stone", "b": "dirt"},
    "blocks": [{"box": "glass", "min": [0, 0, 0], "max": [3, 2, 2]},
               {"layers": [["a b", ".a"], ["b"]], "at": [1, 1, 1]}]})");
  ASSERT_TRUE(parsed.world) << parsed.errors;
  const BlockWorld& blocks = parsed.world->blocks;
  EXPECT_EQ(blocks.at({1, 1, 1}).name, "minecraft:stone");
  EXPECT_EQ(blocks.at({2, 1, 1}).name, "minecraft:glass");
  EXPECT_EQ(blocks.at({3, 1, 1}).name, "minecraft:dirt");
  EXPECT_EQ(blocks.at({1, 1, 2}).name, "minecraft:air");
  EXPECT_EQ(blocks.at({2, 1, 2}).name, "minecraft:stone");
  EXPECT_EQ(blocks.at({1, 2, 1}).name, "minecraft:dirt");
  EXPECT_EQ(blocks.at({0, 1, 1}).name, "minecraft:glass");
}

TEST(WorldJson, schematic_gives_the_size_or_is_placed) {
  const WorldFileReader files = [](const std::string& path) {
    return path == "parts/a.schem" ? std::optional(SchematicParts().file()) : std::nullopt;
  };
  const ParsedWorld whole = parseWorld(R"({"from": "parts/a.schem", "origin": [5, 5, 5]})", files);
  ASSERT_TRUE(whole.world) << whole.errors;
  EXPECT_EQ(whole.world->blocks.size(), glm::ivec3(2, 1, 2));
  EXPECT_EQ(whole.world->blocks.at({6, 5, 5}).name, "minecraft:stone");
  const ParsedWorld placed = parseWorld(
      R"({"size": [4, 1, 2], "blocks": [{"from": "./parts/a.schem", "at": [3, 0, 0]}]})", files);
  ASSERT_TRUE(placed.world) << placed.errors;
  EXPECT_EQ(placed.world->blocks.at({3, 0, 1}).name, "minecraft:stone");
}

TEST(WorldJson, cameras_look_at_their_target) {
  const ParsedWorld parsed = parseWorld(R"({"size": [1, 1, 1], "cameras": [
    {"name": "a", "position": [0, 0, 0], "yaw": 90, "pitch": 10, "fov": 50},
    {"name": "north", "position": [1, 2, 3], "target": [1, 2, -5]},
    {"name": "east", "position": [1, 2, 3], "target": [9, 2, 3]},
    {"name": "down", "position": [1, 2, 3], "target": [1, 1, 4]}]})");
  ASSERT_TRUE(parsed.world) << parsed.errors;
  const World& world = *parsed.world;
  EXPECT_EQ(world.camera("a")->yaw, 90);
  EXPECT_EQ(world.camera("a")->fov, 50);
  EXPECT_NEAR(std::abs(world.camera("north")->yaw), 180, 1e-4);
  EXPECT_NEAR(world.camera("east")->yaw, -90, 1e-4);
  EXPECT_NEAR(world.camera("down")->pitch, 45, 1e-4);
  EXPECT_NEAR(world.camera("down")->yaw, 0, 1e-4);
  EXPECT_EQ(world.camera("none"), nullptr);
}

TEST(WorldJson, environment_is_read) {
  const ParsedWorld parsed = parseWorld(R"({"size": [1, 1, 1], "environment": {"time": 13000,
    "day": 3, "rain": 0.5, "thunder": 1, "biome": "minecraft:desert", "dimension": "the_end",
    "renderDistance": 64, "temperature": 2, "rainfall": 0, "fogColor": [0, 0.5, 1],
    "skyColor": [1, 0, 0]}})");
  ASSERT_TRUE(parsed.world) << parsed.errors;
  const Environment& environment = parsed.world->environment;
  EXPECT_EQ(environment.time, 13000);
  EXPECT_EQ(environment.day, 3);
  EXPECT_EQ(environment.rain, 0.5f);
  EXPECT_EQ(environment.thunder, 1);
  EXPECT_EQ(environment.biome, "minecraft:desert");
  EXPECT_EQ(environment.dimension, "the_end");
  EXPECT_EQ(environment.renderDistance, 64);
  EXPECT_EQ(environment.fogColor, glm::vec3(0, 0.5f, 1));
}

TEST(WorldJson, clouds_are_off_fast_or_fancy) {
  const auto clouds = [](const std::string& value) {
    return parseWorld("{\"size\": [1, 1, 1], \"environment\": {\"clouds\": " + value + "}}");
  };
  EXPECT_EQ(clouds("\"fancy\"").world->environment.clouds, Clouds::Fancy);
  EXPECT_EQ(clouds("\"fast\"").world->environment.clouds, Clouds::Fast);
  EXPECT_EQ(clouds("\"off\"").world->environment.clouds, Clouds::Off);
  for (const char* wrong : {"\"many\"", "true"})
    EXPECT_NE(clouds(wrong).errors.find("expected off, fast or fancy"), std::string::npos)
        << clouds(wrong).errors;
}

TEST(WorldJson, player_is_read) {
  const ParsedWorld parsed = parseWorld(R"({"size": [1, 1, 1], "environment": {"player":
    {"blindness": 0.5, "heldLight2": 15, "sneaking": true, "onGround": false}}})");
  ASSERT_TRUE(parsed.world) << parsed.errors;
  const Player& player = parsed.world->environment.player;
  EXPECT_EQ(player.blindness, 0.5f);
  EXPECT_EQ(player.heldLight2, 15);
  EXPECT_TRUE(player.sneaking);
  EXPECT_FALSE(player.onGround);
  EXPECT_TRUE(player.hideGui);
  const ParsedWorld wrong =
      parseWorld(R"({"size": [1, 1, 1], "environment": {"player": {"hurt": 1, "heldLight": 16}}})");
  EXPECT_NE(wrong.errors.find("true or false"), std::string::npos) << wrong.errors;
  EXPECT_NE(wrong.errors.find("an integer from 0 to 15"), std::string::npos) << wrong.errors;
}

TEST(WorldJson, events_are_sorted_by_frame_and_keep_their_order_within_one) {
  const ParsedWorld parsed = parseWorld(R"({"size": [2, 2, 2],
    "cameras": [{"name": "a", "position": [7, 7, 7]}], "events": [
    {"frame": 9, "time": 100}, {"frame": 2, "camera": "a"},
    {"frame": 9, "option": {"name": "GI_METHOD", "value": "NONE"}},
    {"frame": 2, "set": {"block": "torch", "at": [1, 0, 1]}},
    {"frame": 0, "camera": {"position": [1, 1, 1]}}]})");
  ASSERT_TRUE(parsed.world) << parsed.errors;
  const std::vector<Event>& events = parsed.world->events;
  ASSERT_EQ(events.size(), 5u);
  EXPECT_EQ(std::get<MoveCamera>(events[0].action).camera.position, glm::dvec3(1));
  EXPECT_EQ(std::get<MoveCamera>(events[1].action).camera.position, glm::dvec3(7));
  EXPECT_EQ(std::get<SetBlock>(events[2].action).state.name, "minecraft:torch");
  EXPECT_EQ(std::get<SetTime>(events[3].action).time, 100);
  EXPECT_EQ(std::get<SetOption>(events[4].action).value, "NONE");
  EXPECT_EQ(events[4].frame, 9);
}

TEST(WorldJson, uniforms_are_stated_by_their_names) {
  const ParsedWorld parsed = parseWorld(R"({"size": [1, 1, 1], "environment": {"uniforms": {"isSpectator": true,
    "currentPlayerHealth": 0.25, "vehicleId": 7, "currentDate": [2020, 2, 29], "vehicleLookVector": [0, 0.5, -1]}}})");
  ASSERT_TRUE(parsed.world) << parsed.errors;
  const StatedValues expected = {{"isSpectator", {1, 0, 0}},
                                 {"currentPlayerHealth", {0.25f, 0, 0}},
                                 {"vehicleId", {7, 0, 0}},
                                 {"currentDate", {2020, 2, 29}},
                                 {"vehicleLookVector", {0, 0.5f, -1}}};
  EXPECT_EQ(parsed.world->environment.stated, expected);
}

TEST(WorldJson, uniforms_that_cannot_be_are_errors) {
  const std::pair<const char*, const char*> rows[] = {
      {R"("isSpectator": 1)", "expected true or false"},
      {R"("currentPlayerHealth": 2)", "expected a number from -1 to 1"},
      {R"("currentPlayerHealth": [1])", "expected a number from -1 to 1"},
      {R"("vehicleId": 1.5)", "expected a whole number from -1 to 65535"},
      {R"("currentDate": [2020, 1])", "expected a list of three whole numbers from 1 to 9999"},
      {R"("currentDate": [2020, 1, "a"])", "expected a list of three whole numbers from 1 to 9999"},
      {R"("vehicleLookVector": 1)", "expected a list of three numbers from -1 to 1"},
      {R"("sunAngle": 1)", "unknown key \"sunAngle\""}};
  for (const auto& [member, error] : rows) {
    const ParsedWorld parsed =
        parseWorld(R"({"size": [1, 1, 1], "environment": {"uniforms": {)" + std::string(member) + "}}}");
    EXPECT_FALSE(parsed.world) << member;
    EXPECT_THAT(parsed.errors, testing::HasSubstr(error)) << member;
  }
}

TEST(WorldJson, a_dimension_has_its_own_fog_sky_and_climate) {
  const auto environment = [](const std::string& members) {
    return parseWorld(R"({"size": [1, 1, 1], "environment": {)" + members + "}}").world.value().environment;
  };
  const Environment nether = environment(R"("dimension": "minecraft:the_nether")");
  EXPECT_EQ(nether.biome, "minecraft:nether_wastes");
  EXPECT_EQ(nether.temperature, 2);
  EXPECT_EQ(nether.skyColor, glm::vec3(0));
  EXPECT_NEAR(nether.fogColor.r, 0.2f, 1e-3f);
  EXPECT_NEAR(nether.fogColor.g, 0.031f, 1e-3f);
  const Environment end = environment(R"("dimension": "minecraft:the_end", "fogColor": [1, 0, 0])");
  EXPECT_EQ(end.biome, "minecraft:the_end");
  EXPECT_EQ(end.fogColor, glm::vec3(1, 0, 0)) << "what the file says goes before it";
  EXPECT_EQ(environment(R"("dimension": "mod:moon")").fogColor, Environment().fogColor);
}

TEST(WorldJson, terrain_depends_on_both_seeds_only) {
  const std::string text =
      R"({"origin": [0, 45, 0], "size": [32, 40, 32], "blocks": [{"generate": {"terrain": {"seed": 3}}}]})";
  const auto heights = [](const ParsedWorld& parsed) {
    std::string result;
    for (int i = 0; i < 32 * 32 * 40; ++i) {
      result += char('a' + parsed.world->blocks.indexAt({i % 32, 45 + i / 1024, i / 32 % 32}));
    }
    return result;
  };
  const std::string first = heights(parseWorld(text));
  EXPECT_EQ(first, heights(parseWorld(text)));
  EXPECT_NE(first, heights(parseWorld(text, nullptr, 1)));
}

TEST(WorldJson, terrain_has_the_sea_of_the_game) {
  const auto parsed = parseWorld(R"({"origin": [0, 40, 0], "size": [64, 60, 64],
      "blocks": [{"generate": {"terrain": {"seed": 7}}}]})");
  ASSERT_TRUE(parsed.world) << parsed.errors;
  int highest = 0;
  for (int i = 0; i < 64 * 64 * 60; ++i) {
    const glm::ivec3 place(i % 64, 40 + i / 4096, i / 64 % 64);
    if (parsed.world->blocks.at(place).name == "minecraft:water") highest = std::max(highest, place.y);
  }
  EXPECT_EQ(highest, 63);
}

TEST(WorldJson, nothing_of_a_bad_text_crashes) {
  const std::string text = R"({"size": [2, 2, 2], "palette": {"a": "stone"}, "blocks": [
    {"layers": [["aa", "a."]]}, {"block": "torch", "at": [0, 1, 0]}], "cameras": [
    {"name": "x", "position": [0, 0.5, -1e1], "target": [1, 1, 1]}], "events": []})";
  for (std::size_t length = 0; length < text.size(); ++length) {
    EXPECT_FALSE(parseWorld(text.substr(0, length)).world) << length;
    std::string changed = text;
    changed[length] = '[';
    parseWorld(changed);
  }
  EXPECT_TRUE(parseWorld(text).world);
}

}  // namespace
}  // namespace orris
