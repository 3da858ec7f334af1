#include <orris/check/ids/block_states.h>

#include <algorithm>

#include <orris/pack/files/text.h>

namespace orris {
namespace {

std::vector<std::string> numbers(int from, int to) {
  std::vector<std::string> all;
  for (int i = from; i <= to; ++i) all.push_back(std::to_string(i));
  return all;
}

void addFlags(std::vector<StateProperty>& all) {
  for (const std::string_view name : {"attached",
                                      "berries",
                                      "bloom",
                                      "bottom",
                                      "can_summon",
                                      "conditional",
                                      "cracked",
                                      "crafting",
                                      "disarmed",
                                      "down",
                                      "drag",
                                      "enabled",
                                      "extended",
                                      "eye",
                                      "falling",
                                      "hanging",
                                      "has_book",
                                      "has_bottle_0",
                                      "has_bottle_1",
                                      "has_bottle_2",
                                      "has_record",
                                      "in_wall",
                                      "inverted",
                                      "lit",
                                      "locked",
                                      "natural",
                                      "occupied",
                                      "ominous",
                                      "open",
                                      "persistent",
                                      "powered",
                                      "short",
                                      "shrieking",
                                      "signal_fire",
                                      "slot_0_occupied",
                                      "slot_1_occupied",
                                      "slot_2_occupied",
                                      "slot_3_occupied",
                                      "slot_4_occupied",
                                      "slot_5_occupied",
                                      "snowy",
                                      "tip",
                                      "triggered",
                                      "unstable",
                                      "waterlogged"}) {
    all.push_back({name, {"true", "false"}, true});
  }
}

void addNumbers(std::vector<StateProperty>& all) {
  struct Range {
    std::string_view name;
    int from, to;
  };
  for (const Range& range : {Range{"age", 0, 25}, {"bites", 0, 6},          {"candles", 1, 4},
                             {"charges", 0, 4},   {"delay", 1, 4},          {"distance", 0, 7},
                             {"dusted", 0, 3},    {"eggs", 1, 4},           {"flower_amount", 1, 4},
                             {"hatch", 0, 2},     {"honey_level", 0, 5},    {"hydration", 0, 3},
                             {"layers", 1, 8},    {"level", 0, 15},         {"moisture", 0, 7},
                             {"note", 0, 24},     {"pickles", 1, 4},        {"power", 0, 15},
                             {"rotation", 0, 15}, {"segment_amount", 1, 4}, {"stage", 0, 1}}) {
    all.push_back({range.name, numbers(range.from, range.to), true});
  }
}

void addValues(std::vector<StateProperty>& all) {
  struct Words {
    std::string_view name, values;
    bool closed;
  };
  // Sides of fences and panes are true or false, of walls low or tall, of redstone side or up.
  constexpr std::string_view kSide = "true false none low tall side up";
  for (const Words& words :
       {Words{"attachment", "floor ceiling single_wall double_wall", true},
        {"axis", "x y z none", true},
        {"copper_golem_pose", "standing sitting running star", false},
        {"creaking_heart_state", "uprooted dormant awake", false},
        {"east", kSide, true},
        {"face", "floor wall ceiling", true},
        {"facing", "north east south west up down", true},
        {"half", "upper lower top bottom", true},
        {"hinge", "left right", true},
        {"instrument",
         "harp basedrum snare hat bass flute bell guitar chime xylophone iron_xylophone cow_bell "
         "didgeridoo bit banjo pling zombie skeleton creeper dragon wither_skeleton piglin "
         "custom_head",
         false},
        {"leaves", "none small large", true},
        {"mode", "compare subtract save load corner data", false},
        {"north", kSide, true},
        {"orientation",
         "down_east down_north down_south down_west up_east up_north up_south up_west east_up "
         "north_up south_up west_up",
         true},
        {"part", "head foot", true},
        {"sculk_sensor_phase", "inactive active cooldown", false},
        {"shape",
         "straight inner_left inner_right outer_left outer_right north_south east_west "
         "ascending_east ascending_west ascending_north ascending_south south_east south_west "
         "north_west north_east",
         true},
        {"side_chain", "unconnected right center left", false},
        {"south", kSide, true},
        {"thickness", "tip_merge tip frustum middle base", true},
        {"tilt", "none unstable partial full", true},
        {"trial_spawner_state",
         "inactive waiting_for_players active waiting_for_reward_ejection ejecting_reward cooldown",
         false},
        {"type", "single left right top bottom double normal sticky", false},
        {"up", "true false", true},
        {"vault_state", "inactive active unlocking ejecting", false},
        {"vertical_direction", "up down", true},
        {"west", kSide, true},
        // Before 1.13.
        {"check_decay", "", false},
        {"color", "", false},
        {"contents", "", false},
        {"damage", "", false},
        {"decayable", "", false},
        {"dragon", "", false},
        {"explode", "", false},
        {"legacy_data", "", false},
        {"nodrop", "", false},
        {"seamless", "", false},
        {"variant", "", false},
        {"wet", "", false}}) {
    all.push_back({words.name, splitBlanks(words.values), words.closed});
  }
}

std::vector<StateProperty> makeProperties() {
  std::vector<StateProperty> all;
  addFlags(all);
  addNumbers(all);
  addValues(all);
  std::sort(all.begin(), all.end(), [](auto& a, auto& b) { return a.name < b.name; });
  return all;
}

}  // namespace

const std::vector<StateProperty>& stateProperties() {
  static const std::vector<StateProperty> kAll = makeProperties();
  return kAll;
}

const StateProperty* findStateProperty(std::string_view name) {
  const auto& all = stateProperties();
  const auto found = std::lower_bound(all.begin(), all.end(), name,
                                      [](auto& property, auto key) { return property.name < key; });
  return found != all.end() && found->name == name ? &*found : nullptr;
}

}  // namespace orris
