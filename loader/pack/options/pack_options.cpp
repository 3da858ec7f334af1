#include <orris/pack/options/pack_options.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include <orris/core/files/named_file.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

std::optional<OptionValues> readSettings(const std::shared_ptr<const FileSource>& files,
                                         const LoadRequest& request, const std::string& path,
                                         Diagnostics& diagnostics) {
  const std::optional<std::string> text = readNamedFile(path, diagnostics);
  if (!text) return std::nullopt;
  LoadRequest optionsOnly{.dimension = request.dimension, .environment = request.environment};
  optionsOnly.buildSources = false;
  const std::optional<ShaderPack> pack = loadShaderPack(files, optionsOnly, diagnostics);
  if (!pack) return std::nullopt;
  return parseOptionFile(path, *text, pack->options, diagnostics);
}

/// A name without a namespace is one of the game's dimensions or a folder of the pack; other mods may add
/// any other.
bool knowsDimension(const FileSource& files, const std::string& request, Diagnostics& diagnostics) {
  static const std::vector<std::string> kOfGame = {"overworld", "the_nether", "the_end"};
  constexpr std::string_view kGame = "minecraft:";
  const bool ofGame = request.starts_with(kGame);
  const std::string name = ofGame ? request.substr(kGame.size()) : request;
  const std::string folder = (name.starts_with('/') ? name : "/" + name) + "/";
  const bool known =
      name.empty() || name == "/" || std::ranges::find(kOfGame, name) != kOfGame.end() ||
      name.find(':') != std::string::npos ||
      (!ofGame && (fullDimensionName(name) != name ||
                   std::ranges::any_of(files.files(), [&](const std::string& file) {
                     return file.starts_with(folder);
                   })));
  if (known) return true;
  const std::string meant = suggest(name, kOfGame);
  Diagnostic unknown{.id = "dimension-unknown"};
  unknown.message = fmt::format("--dimension: there is no dimension {}", request);
  unknown.hint = meant.empty()
                     ? "name overworld, the_nether, the_end, a folder of the pack (world0), or a "
                       "dimension of a mod with its namespace"
                     : meant;
  diagnostics.push_back(std::move(unknown));
  return false;
}

}  // namespace

std::optional<LoadRequest> makeLoadRequest(const std::shared_ptr<const FileSource>& files,
                                           const PackOptions& options,
                                           const MacroDefinitions& environment,
                                           Diagnostics& diagnostics) {
  LoadRequest request{
      .values = options.values, .profile = options.profile, .environment = environment};
  if (!knowsDimension(*files, options.dimension, diagnostics)) return std::nullopt;
  if (!options.dimension.empty()) request.dimension = options.dimension;
  if (options.settingsFile.empty()) return request;
  const auto values = readSettings(files, request, options.settingsFile, diagnostics);
  if (!values) return std::nullopt;
  request.fileValues = *values;
  return request;
}

std::string fullDimensionName(const std::string& name) {
  static const std::map<std::string, std::string> kNames = {
      {"world0", "minecraft:overworld"},     {"overworld", "minecraft:overworld"},
      {"world-1", "minecraft:the_nether"},   {"the_nether", "minecraft:the_nether"},
      {"world1", "minecraft:the_end"},       {"the_end", "minecraft:the_end"}};
  const auto found = kNames.find(name);
  return found == kNames.end() ? name : found->second;
}

}  // namespace orris
