#include "app/input/common.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <memory>

#include <orris/core/limits.h>
#include <orris/image/image_size.h>

namespace orris {
namespace {

bool parseInt(std::string_view text, int& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

void parseSize(const std::string& text, ImageOptions& options) {
  const std::optional<ImageSize> size = parseImageSize(text);
  if (!size) {
    throw CLI::ValidationError(
        "--size", fmt::format("expected WIDTHxHEIGHT, each 1 to {} and at most {} pixels in all, "
                              "got \"{}\"",
                              kMaxSide, kMaxPixels, text));
  }
  options.width = size->width;
  options.height = size->height;
}

void parseAssignment(const std::string& flag, const std::string& text, OptionValues& values) {
  const size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos) {
    throw CLI::ValidationError(flag, fmt::format("expected NAME=VALUE, got \"{}\"", text));
  }
  values[text.substr(0, equals)] = text.substr(equals + 1);
}

glm::ivec2 parseColumn(const std::string& text) {
  constexpr int kBorder = 29'999'984;  // blocks from the origin, of the game
  const std::size_t comma = text.find(',');
  glm::ivec2 column{0};
  if (comma == std::string::npos || !parseInt(std::string_view(text).substr(0, comma), column.x) ||
      !parseInt(std::string_view(text).substr(comma + 1), column.y) ||
      std::max(std::abs(column.x), std::abs(column.y)) > kBorder) {
    throw CLI::ValidationError("--at", fmt::format("expected X,Z, two whole numbers of blocks up to {}, got \"{}\"", kBorder, text));
  }
  return column;
}

std::string versionHelp(std::string_view what, const Version& newest) {
  return fmt::format("version of {} that the pack runs in (default {}, the newest known)", what,
                     versionText(newest));
}

HostVersions requireVersions(const std::string& iris, const std::string& game, SeriesEnd end) {
  std::string error;
  const auto chosen = chooseVersions(iris, game, end, error);
  if (!chosen) throw CLI::ValidationError(iris.empty() ? "--game" : "--iris", error);
  return *chosen;
}

/// "1.8..1.11": both; another text is both of its ends.
std::pair<std::string, std::string> endsOf(const std::string& text) {
  const std::size_t dots = text.find("..");
  if (dots == std::string::npos) return {text, text};
  return {text.substr(0, dots), text.substr(dots + 2)};
}

void parseBackendName(const std::string& text, gl::Backend& backend) {
  const std::optional<gl::Backend> parsed = gl::parseBackend(text);
  if (!parsed) {
    throw CLI::ValidationError("--backend",
                               fmt::format("expected auto, osmesa, egl or glfw, got \"{}\"", text));
  }
  backend = *parsed;
}

void parseContextFlag(const std::string& text, gl::ContextProfile& context) {
  const std::optional<gl::ContextProfile> parsed = gl::parseContextProfile(text);
  if (!parsed) {
    throw CLI::ValidationError(
        "--context", fmt::format("expected auto, compatibility or core, got \"{}\"", text));
  }
  context = *parsed;
}

}  // namespace

void addPackFlags(CLI::App& command, PackOptions& options) {
  command.add_option("--profile", options.profile, "profile of the pack to start from")
      ->type_name("NAME");
  addAssignmentFlag(command, "--set", options.values, "set an option of the pack");
  command.add_option("--settings", options.settingsFile, "option file to apply (NAME=VALUE lines)")
      ->type_name("FILE");
  command
      .add_option("--dimension", options.dimension, "world0, world-1, world1 or a dimension name")
      ->type_name("NAME");
}

void addVersionFlags(CLI::App& command, HostVersions& versions) {
  const auto asked = std::make_shared<std::pair<std::string, std::string>>();
  command.add_option("--iris", asked->first, versionHelp("Iris", versions.iris))
      ->type_name("VERSION");
  command.add_option("--game", asked->second, versionHelp("Minecraft", versions.game))
      ->type_name("VERSION");
  // Either decides what the other is when it is not given.
  command.parse_complete_callback([asked, &versions] {
    versions = requireVersions(asked->first, asked->second, SeriesEnd::Last);
  });
}

void addVersionRangeFlags(CLI::App& command, std::optional<VersionRange>& range) {
  const auto asked = std::make_shared<std::pair<std::string, std::string>>();
  const HostVersions newest;
  command
      .add_option("--iris", asked->first,
                  versionHelp("Iris", newest.iris) + "; A..B: check the oldest and the newest")
      ->type_name("VERSION");
  command
      .add_option("--game", asked->second, versionHelp("Minecraft", newest.game) + "; A..B as well")
      ->type_name("VERSION");
  command.parse_complete_callback([asked, &range] {
    if (asked->first.empty() && asked->second.empty()) return;
    const auto [oldIris, newIris] = endsOf(asked->first);
    const auto [oldGame, newGame] = endsOf(asked->second);
    const bool one = oldIris == newIris && oldGame == newGame;
    range = {requireVersions(oldIris, oldGame, one ? SeriesEnd::Last : SeriesEnd::First),
             requireVersions(newIris, newGame, SeriesEnd::Last)};
    if (range->newest.iris < range->oldest.iris || range->newest.game < range->oldest.game)
      throw CLI::ValidationError("--iris", "the range ends before it begins");
  });
}

void addSceneFlags(CLI::App& command, SceneOptions& options) {
  command.add_option("--camera", options.camera, "named camera of the world, or x,y,z,yaw,pitch")
      ->type_name("CAMERA");
  command.add_option("--time", options.time, "time of day")
      ->type_name("TICKS")
      ->check(CLI::Range(0, 23999));
  command.add_option("--seed", options.seed, "seed of generated worlds and of random numbers");
  addSavePartFlags(command, options.part);
  addResourcesFlag(command, options.resources);
}

void addResourcesFlag(CLI::App& command, std::vector<std::string>& packs) {
  command
      .add_option("--resources", packs,
                  "resource pack that blocks, items and figures are drawn with: a folder, a zip or the "
                  "game's jar; may be repeated, the first goes before the others")
      ->type_name("PACK")
      ->allow_extra_args(false);
}

void addSavePartFlags(CLI::App& command, SavePart& part) {
  command
      .add_option_function<std::string>(
          "--at", [&part](const std::string& text) { part.at = parseColumn(text); },
          "of a save or a Luanti world: the block X,Z in the middle (default: where the player is)")
      ->type_name("X,Z");
  command
      .add_option("--radius", part.radius,
                  fmt::format("of a save or a Luanti world: chunks around it (default {})", kDefaultSaveRadius))
      ->type_name("CHUNKS")
      ->check(CLI::Range(0, int(limits::kSaveRadius)));
}

void addSizeFlag(CLI::App& command, ImageOptions& options) {
  command
      .add_option_function<std::string>(
          "--size", [&options](const std::string& text) { parseSize(text, options); },
          fmt::format("size in pixels (default {}x{})", options.width, options.height))
      ->type_name("WxH");
}

void addFramesFlag(CLI::App& command, int& frames) {
  command.add_option("--frames", frames, "frames to draw; the last one is the picture")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000000));
}

void addImageFlags(CLI::App& command, ImageOptions& options) {
  addSizeFlag(command, options);
  addBackendFlag(command, options.backend);
  command
      .add_option_function<std::string>(
          "--context", [&options](const std::string& text) { parseContextFlag(text, options.context); },
          "profile of the GL context: auto, compatibility or core")
      ->type_name("PROFILE");
}

std::optional<Shard> parseShard(const std::string& text) {
  constexpr int kMost = 4096;
  const std::size_t slash = text.find('/');
  int index = 0, count = 0;
  const bool numbers = slash != std::string::npos && parseInt(text.substr(0, slash), index) &&
                       parseInt(text.substr(slash + 1), count);
  if (!numbers || index < 1 || index > count || count > kMost) return std::nullopt;
  return Shard{index, count};
}

void addShardFlag(CLI::App& command, std::string& shard, const std::string& help) {
  command.add_option("--shard", shard, help)->check([](const std::string& text) {
    return parseShard(text) ? std::string() : "expected I/N, with I from 1 to N: " + text;
  });
}

std::optional<std::chrono::seconds> parseBudget(const std::string& text) {
  constexpr int kDay = 24 * 60 * 60;
  if (text.empty()) return std::nullopt;
  const bool minutes = text.back() == 'm';
  const bool unit = minutes || text.back() == 's';
  int number = 0;
  if (!parseInt(std::string_view(text).substr(0, text.size() - (unit ? 1 : 0)), number) ||
      number < 1 || number > kDay)
    return std::nullopt;
  return std::chrono::seconds(number * (minutes ? 60 : 1));
}

std::string checkPositive(const std::string& text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && number > 0 && std::isfinite(number) ? std::string() : "expected a number above 0: " + text;
}

void addTimeFlag(CLI::App& command, const std::string& flag, std::string& time,
                 const std::string& help) {
  CLI::Option* option = command.add_option(flag, time, help)->check([](const std::string& text) {
    return parseBudget(text) ? std::string() : "expected a time such as 60s or 5m: " + text;
  });
  if (!time.empty()) option->capture_default_str();
}

void addBudgetFlag(CLI::App& command, std::string& budget, const std::string& help) {
  addTimeFlag(command, "--budget", budget, help);
}

void addBackendFlag(CLI::App& command, gl::Backend& backend) {
  command
      .add_option_function<std::string>(
          "--backend", [&backend](const std::string& text) { parseBackendName(text, backend); },
          "GL context: auto, osmesa, egl or glfw")
      ->type_name("NAME");
}

void addOutputFlags(CLI::App& command, OutputOptions& options) {
  command.add_flag("--json", options.json, "print one JSON object on standard output");
  command.add_flag("--quiet", options.quiet, "print errors only");
  command.add_flag("--verbose", options.verbose, "print notes too");
}

CLI::Option* addPackArgument(CLI::App& command, std::string& path) {
  return command.add_option("pack", path, "shader pack: a folder or a .zip")
      ->type_name("PACK")
      ->required();
}

CLI::Option* addWorldArgument(CLI::App& command, std::string& path) {
  return command.add_option("world", path, "world: a folder with world.json, a schematic, a save, a region file (.mca) or a Luanti world")
      ->type_name("WORLD")
      ->required();
}

void addAssignmentFlag(CLI::App& command, const std::string& flag, OptionValues& values,
                       const std::string& help, const std::string& typeName) {
  command
      .add_option_function<std::vector<std::string>>(
          flag,
          [flag, &values](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) parseAssignment(flag, text, values);
          },
          help)
      ->type_name(typeName)
      ->allow_extra_args(false);
}

}  // namespace orris
