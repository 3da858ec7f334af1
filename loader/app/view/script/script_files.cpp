#include "app/view/script/script_files.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include <orris/core/files/read_file.h>
#include <orris/core/files/replace_file.h>

namespace orris {
namespace {

namespace fs = std::filesystem;

std::string textOf(const ScriptStep& step, const char* member) {
  const JsonNode* node = step.object.find(member);
  return node == nullptr ? "" : node->text;
}

std::string writeScripted(const std::string& path, const std::string& text) {
  const std::error_code error = replaceFile(path, text);
  return error ? fmt::format("{} cannot be written: {}", path, error.message()) : "";
}

std::string replaceText(const std::string& path, const std::string& old, const std::string& text) {
  ReadFault fault{};
  auto contents = readFile(path, kMaxTextBytes, fault);
  if (!contents) return fmt::format("{} {}", path, describe(fault));
  const std::size_t at = contents->find(old);
  if (old.empty() || at == std::string::npos)
    return fmt::format("{} does not contain \"{}\"", path, old);
  return writeScripted(path, contents->replace(at, old.size(), text));
}

}  // namespace

bool isFileStep(const ScriptStep& step) {
  return step.action == "write" || step.action == "replace" || step.action == "remove" ||
         step.action == "rename";
}

std::string changeFile(const ScriptStep& step) {
  const std::string& path = step.value.text;
  if (step.action == "write") return writeScripted(path, textOf(step, "text"));
  if (step.action == "replace") return replaceText(path, textOf(step, "old"), textOf(step, "new"));
  std::error_code error;
  if (step.action == "rename") {
    fs::rename(path, textOf(step, "to"), error);
  } else if (!fs::remove(path, error) && !error) {
    return fmt::format("{} does not exist", path);
  }
  return error ? fmt::format("{}: {}", path, error.message()) : "";
}

}  // namespace orris
