#include "app/lsp/edited_pack.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include <orris/core/files/read_file.h>
#include <orris/core/characters.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

namespace fs = std::filesystem;

}  // namespace

std::string packRootOf(const std::string& file) {
  for (fs::path folder = fs::path(file).parent_path(); folder.has_relative_path(); folder = folder.parent_path())
    if (folder.filename() == "shaders") return folder.parent_path().string();
  return "";
}

std::string EditedPack::packPath(const std::string& file) const {
  const std::string shaders = root_ + "/shaders";
  return file.starts_with(shaders + "/") ? file.substr(shaders.size()) : "";
}

std::string EditedPack::filePath(const std::string& packPath) const {
  return root_ + "/shaders" + packPath;
}

void EditedPack::edit(const std::string& packPath, std::string text) {
  const auto [entry, isNew] = overlay_.try_emplace(packPath);
  if (!isNew && entry->second == text) return;
  entry->second = std::move(text);
  changedOnDisk(packPath);
}

void EditedPack::close(const std::string& packPath) {
  if (overlay_.erase(packPath) > 0) changedOnDisk(packPath);
}

void EditedPack::changedOnDisk(const std::string& packPath) {
  changed_.insert(packPath);
  stale_ = true;
  waiting = true;
}

std::shared_ptr<const FileSource> EditedPack::open() {
  Diagnostics ignored;
  std::shared_ptr<const FileSource> files = openPack(root_, ignored);
  if (!files) files = memorySource({});
  return overlaidSource(std::move(files), overlay_);
}

std::string EditedPack::text(const std::string& packPath) {
  if (const auto found = overlay_.find(packPath); found != overlay_.end()) return found->second;
  ReadFault fault;
  return readFileBelow(root_, "shaders" + packPath, kMaxTextBytes, fault).value_or("");
}

PackKnowledge& EditedPack::knowledge() {
  if (knowledge_ && !stale_) return *knowledge_;
  const auto files = open();
  LoadRequest request;
  request.environment = standardMacros({});
  request.buildSources = false;
  request.keepGoing = true;
  Diagnostics ignored;
  auto pack = loadShaderPack(files, request, ignored);
  if (!pack) {
    // Names are found in the files all the same.
    pack.emplace();
    pack->source = files;
  }
  knowledge_ = std::make_unique<PackKnowledge>(std::move(*pack));
  ReadFault fault;
  if (const auto chosen = readFile(root_ + ".txt", kMaxTextBytes, fault)) {
    ShaderPack& own = knowledge_->pack;
    own.values = parseOptionFile(root_ + ".txt", *chosen, own.options, ignored);
    knowledge_->valuesFrom = root_ + ".txt";
  }
  stale_ = false;
  return *knowledge_;
}

PackKnowledge& EditedPack::roughKnowledge() { return knowledge_ ? *knowledge_ : knowledge(); }

void EditedPack::startCheck() {
  check.start({.overlay = overlay_, .changed = checkedOnce_ ? changed_ : std::set<std::string>()});
  waiting = false;
}

void EditedPack::checked() {
  checkedOnce_ = true;
  if (!waiting) changed_.clear();
}

}  // namespace orris
