#include "app/input/folder_config.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include <orris/core/files/read_file.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

constexpr std::size_t kMaxConfigBytes = std::size_t{64} << 10;

bool isFolderKey(const CLI::ConfigItem& item) {
  const auto& keys = folderConfigKeys();
  const bool sectionEdge = item.name == "++" || item.name == "--";
  return sectionEdge || std::find(keys.begin(), keys.end(), item.name) != keys.end();
}

Diagnostic configProblem(std::string message, std::string hint, std::string file = kFolderConfig) {
  return {.id = "config-refused",
          .at = {.file = std::move(file)},
          .message = std::move(message),
          .hint = std::move(hint)};
}

// The parser keeps no lines; a key that it takes from quotes or a dotted name has none here.
void placeKey(Diagnostic& diagnostic, const std::string& key, const std::vector<std::string>& lines) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::size_t begin = std::min(lines[i].find_first_not_of(" \t"), lines[i].size());
    if (lines[i].compare(begin, key.size(), key) != 0) continue;
    const std::size_t after = lines[i].find_first_not_of(" \t", begin + key.size());
    if (after != std::string::npos && lines[i][after] != '=') continue;
    diagnostic.at.line = static_cast<int>(i + 1);
    diagnostic.at.column = static_cast<int>(begin + 1);
    diagnostic.sourceLine = lines[i];
    return;
  }
}

Diagnostic refusal(const CLI::ConfigItem& item, const std::vector<std::string>& lines) {
  Diagnostic diagnostic = configProblem(
      fmt::format("\"{}\" is not taken from a file that nobody named", item.name),
      fmt::format("if you trust this folder, say --config {}; otherwise --no-config. Unasked, only "
                  "these are read: {}",
                  kFolderConfig, joinNames(folderConfigKeys())));
  placeKey(diagnostic, item.name, lines);
  return diagnostic;
}

/// nullopt: the parser does not understand the text.
std::optional<std::vector<CLI::ConfigItem>> configItems(const std::string& text,
                                                    Diagnostics& diagnostics) {
  std::istringstream stream(text);
  try {
    return CLI::ConfigTOML().from_config(stream);
  } catch (const CLI::Error& error) {
    diagnostics.push_back(configProblem(error.what(), ""));
    return std::nullopt;
  }
}

void addSilenced(const CLI::ConfigItem& item, std::set<std::string>& ids) {
  if (item.name != "ignore" && item.name != "severity") return;
  for (const std::string& word : item.inputs) ids.insert(word.substr(0, word.find('=')));
}

}  // namespace

const std::vector<std::string>& folderConfigKeys() {
  // None of them reads or writes a file; none hides messages without leaving their counts.
  static const std::vector<std::string> kKeys = {
      "ignore", "severity",   "strict",    "profile", "profiles", "set",
      "target", "dimensions", "dimension", "camera",  "time",     "seed"};
  return kKeys;
}

std::optional<FolderConfig> readFolderConfig(const std::string& folder, Diagnostics& diagnostics) {
  ReadFault fault{};
  const auto text = readFileBelow(folder, kFolderConfig, kMaxConfigBytes, fault);
  if (!text && fault == ReadFault::Missing) return FolderConfig{};
  if (!text) {
    diagnostics.push_back(configProblem(describe(fault), "remove it, or say --no-config"));
    return std::nullopt;
  }
  const auto items = configItems(*text, diagnostics);
  if (!items) return std::nullopt;
  FolderConfig config{.present = true};
  const std::vector<std::string> lines = splitLines(*text);
  for (const CLI::ConfigItem& item : *items) {
    if (!isFolderKey(item)) diagnostics.push_back(refusal(item, lines));
    addSilenced(item, config.silenced);
  }
  return diagnostics.empty() ? std::optional(std::move(config)) : std::nullopt;
}

bool isBoundedConfig(const std::string& path, Diagnostics& diagnostics) {
  ReadFault fault{};
  if (path.starts_with("/dev/") || readFile(path, kMaxConfigBytes, fault) || fault == ReadFault::Missing) return true;
  diagnostics.push_back(configProblem(describe(fault), "name a file of flags", path));
  return false;
}

}  // namespace orris
