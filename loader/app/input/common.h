// The flags that commands share, in groups, so that each has one spelling, one check and one help
// text. A bad value ends the command with exit status 2 before anything is opened.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <orris/gl/context.h>
#include <orris/pack/options/pack_options.h>
#include <orris/report/text_style.h>
#include <orris/world/world.h>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace orris {

/// Which world, seen how.
struct SceneOptions {
  std::string path;
  std::string camera;       ///< a name, or x,y,z,yaw,pitch; "" for the first camera
  std::optional<int> time;  ///< ticks; nullopt for the world's own
  unsigned seed = 0;
  SavePart part;  ///< of a save; its dimension is not set
  std::vector<std::string> resources;  ///< resource packs, the first before the others
};

/// How much to draw, and on what.
struct ImageOptions {
  int width = 640, height = 360;
  int frames = 0;  ///< of commands that have addFramesFlag()
  gl::Backend backend = gl::Backend::Auto;
  gl::ContextProfile context = gl::ContextProfile::Auto;
};

/// What to print.
struct OutputOptions : Verbosity {
  bool json = false;  ///< a JSON object on standard output instead of text
};

void addPackFlags(CLI::App& command, PackOptions& options);  ///< all but path and versions
/// --iris and --game, for commands that run a pack as one version.
void addVersionFlags(CLI::App& command, HostVersions& versions);
/// The same flags, which also take a range: 1.8..1.11. Nothing asked: nullopt.
void addVersionRangeFlags(CLI::App& command, std::optional<VersionRange>& range);
void addSceneFlags(CLI::App& command, SceneOptions& options);  ///< all but the path
void addSavePartFlags(CLI::App& command, SavePart& part);  ///< of addSceneFlags
void addResourcesFlag(CLI::App& command, std::vector<std::string>& packs);  ///< of addSceneFlags
void addImageFlags(CLI::App& command, ImageOptions& options);  ///< all but the frames
void addFramesFlag(CLI::App& command, int& frames);
void addSizeFlag(CLI::App& command, ImageOptions& options);  ///< of addImageFlags
void addBackendFlag(CLI::App& command, gl::Backend& backend);
void addOutputFlags(CLI::App& command, OutputOptions& options);
/// The positional arguments PACK and WORLD.
CLI::Option* addPackArgument(CLI::App& command, std::string& path);
CLI::Option* addWorldArgument(CLI::App& command, std::string& path);
/// Part I of N, "2/5", 1 to N; nullopt when the text is none.
using Shard = std::pair<int, int>;
std::optional<Shard> parseShard(const std::string& text);
void addShardFlag(CLI::App& command, std::string& shard, const std::string& help);
/// A check of a flag's value: "", or what is wrong with it.
std::string checkPositive(const std::string& text);
/// "60s", "5m"; nullopt for other texts and for "".
std::optional<std::chrono::seconds> parseBudget(const std::string& text);
/// A flag with a default that parseBudget() takes.
void addTimeFlag(CLI::App& command, const std::string& flag, std::string& time, const std::string& help);
void addBudgetFlag(CLI::App& command, std::string& budget, const std::string& help);
/// A NAME=VALUE flag that may be repeated, or followed by several values.
void addAssignmentFlag(CLI::App& command, const std::string& flag, OptionValues& values,
                       const std::string& help, const std::string& typeName = "NAME=VALUE");

}  // namespace orris
