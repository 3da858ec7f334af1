#include <orris/core/files/named_file.h>

#include <filesystem>

#include <orris/core/add_diagnostic.h>
#include <orris/core/files/read_file.h>
#include <orris/core/files/replace_file.h>

namespace orris {
namespace {

void reportUnreadable(const std::string& path, ReadFault fault, Diagnostics& diagnostics) {
  addError(diagnostics, "file-unreadable", {path}, describe(fault));
}

void reportUnwritable(const std::string& path, Diagnostics& diagnostics) {
  const std::string problem = outputProblem(path);
  addError(diagnostics, "file-unwritable", {path}, problem.empty() ? "cannot be written" : problem,
           "name a file in a folder that exists and may be written");
}

}  // namespace

std::optional<std::string> readNamedFile(const std::string& path, Diagnostics& diagnostics) {
  ReadFault fault{};
  std::optional<std::string> text = readQuotedFile(path, kMaxTextBytes, fault);
  if (!text) reportUnreadable(path, fault, diagnostics);
  return text;
}

std::optional<std::string> readNamedFileBelow(const std::string& folder, const std::string& name,
                                              Diagnostics& diagnostics) {
  ReadFault fault{};
  std::optional<std::string> text = readFileBelow(folder, name, kMaxTextBytes, fault);
  if (!text)
    reportUnreadable((std::filesystem::path(folder) / name).string(), fault, diagnostics);
  return text;
}

bool canWriteNamedFile(const std::string& path, Diagnostics& diagnostics) {
  if (outputProblem(path).empty()) return true;
  reportUnwritable(path, diagnostics);
  return false;
}

bool writeNamedFile(const std::string& path, const std::string& text, Diagnostics& diagnostics) {
  if (!replaceFile(path, text)) return true;
  reportUnwritable(path, diagnostics);
  return false;
}

}  // namespace orris
