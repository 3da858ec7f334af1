#include <orris/world/luanti/luanti_files.h>

#include <charconv>
#include <map>
#include <string_view>

#include <orris/core/limits.h>
#include <orris/core/files/read_file.h>

namespace orris {
namespace {

constexpr const char* kMap = "map.sqlite";
constexpr const char* kWorldSettings = "world.mt";
constexpr int kTicksOfDay = 24000, kSixInTheMorning = 6000;

bool isRegularFile(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error);
}

std::string_view trimmed(std::string_view text) {
  const std::size_t from = text.find_first_not_of(" \t\r");
  return from == text.npos ? "" : text.substr(from, text.find_last_not_of(" \t\r") + 1 - from);
}

/// Lines `key = value`; others say nothing.
std::map<std::string, std::string, std::less<>> readSettings(const std::filesystem::path& folder, const char* file) {
  std::map<std::string, std::string, std::less<>> settings;
  ReadFault ignored{};
  const auto bytes = readFileBelow(folder.string(), file, limits::kTextFileBytes, ignored);
  std::string_view rest = bytes ? std::string_view(*bytes) : "";
  for (std::size_t lines = 0; !rest.empty() && lines < limits::kTextFileLines; ++lines) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    const std::size_t equals = line.find('=');
    if (equals != line.npos) settings.emplace(trimmed(line.substr(0, equals)), trimmed(line.substr(equals + 1)));
  }
  return settings;
}

std::optional<int> wholeNumber(const std::map<std::string, std::string, std::less<>>& settings, std::string_view key) {
  const auto setting = settings.find(key);
  if (setting == settings.end()) return std::nullopt;
  const char* end = setting->second.data() + setting->second.size();
  int value = 0;
  const auto [stop, error] = std::from_chars(setting->second.data(), end, value);
  if (error != std::errc() || stop != end || value < 0) return std::nullopt;
  return value;
}

}  // namespace

bool isLuantiWorld(const std::filesystem::path& path) {
  if (path.filename() == kWorldSettings || path.extension() == ".sqlite") return isRegularFile(path);
  return isRegularFile(path / kWorldSettings) || isRegularFile(path / kMap);
}

LuantiFiles findLuantiFiles(const std::filesystem::path& path) {
  LuantiFiles files;
  const bool named = isRegularFile(path);
  files.folder = !named ? path : path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  files.map = path.extension() == ".sqlite" && named ? path : files.folder / kMap;
  std::error_code error;
  files.name = std::filesystem::weakly_canonical(files.folder, error).filename().string();
  const auto world = readSettings(files.folder, kWorldSettings);
  if (const auto name = world.find("world_name"); name != world.end() && !name->second.empty()) files.name = name->second;
  if (const auto backend = world.find("backend"); backend != world.end()) files.backend = backend->second;
  files.blockSize = wholeNumber(world, "blocksize").value_or(files.blockSize);
  const auto state = readSettings(files.folder, "env_meta.txt");
  if (const auto time = wholeNumber(state, "time_of_day"))
    files.time = (*time % kTicksOfDay + kTicksOfDay - kSixInTheMorning) % kTicksOfDay;
  files.day = wholeNumber(state, "day_count");
  return files;
}

}  // namespace orris
