#include <orris/core/files/file_source.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include <orris/core/files/folder_source.h>
#include <orris/core/files/pack_path.h>
#include <orris/core/files/pack_search.h>
#include <orris/core/files/read_file.h>
#include <orris/core/files/zip_source.h>

namespace orris {
namespace {

namespace fs = std::filesystem;

class MemorySource : public FileSource {
 public:
  explicit MemorySource(std::map<std::string, std::string> files) {
    for (auto& [path, bytes] : files) {
      if (const auto normal = resolvePackPath("/", path, AboveRoot::Beside)) {
        files_.insert_or_assign(*normal, std::move(bytes));
      }
    }
    for (const auto& entry : files_) {
      if (!isBesideShaders(entry.first)) paths_.push_back(entry.first);
    }
  }
  std::optional<std::string> read(std::string_view path) const override {
    return isBesideShaders(path) ? std::nullopt : MemorySource::readResource(path);
  }
  std::optional<std::string> readResource(std::string_view path) const override {
    const auto found = files_.find(path);
    return found == files_.end() ? std::nullopt : std::optional(found->second);
  }
  const std::vector<std::string>& files() const override { return paths_; }

 private:
  std::map<std::string, std::string, std::less<>> files_;
  std::vector<std::string> paths_;
};

std::unique_ptr<FileSource> refuse(const std::string& path, std::string message, std::string hint,
                                   Diagnostics& diagnostics) {
  diagnostics.push_back({.severity = Severity::Error,
                         .id = "pack-unreadable",
                         .at = {.file = path},
                         .message = std::move(message),
                         .hint = std::move(hint)});
  return nullptr;
}

constexpr size_t kPacksNamed = 5;

/// The folder is no pack itself; what it holds may be.
std::unique_ptr<FileSource> refuseFolder(const std::string& path, Diagnostics& diagnostics) {
  const std::vector<std::string> packs = findPacks(path);
  if (packs.empty()) {
    return refuse(path, "no shader pack: the folder has no folder named shaders",
                  "give the folder that holds shaders/", diagnostics);
  }
  const size_t named = std::min(packs.size(), kPacksNamed);
  std::string names = fmt::format("{}", fmt::join(packs.begin(), packs.begin() + named, ", "));
  if (named < packs.size()) names += fmt::format(" and {} more", packs.size() - named);
  if (packs.size() == 1) {
    return refuse(path, "no shader pack itself, but it holds one", "give " + names, diagnostics);
  }
  return refuse(path, fmt::format("no shader pack itself, but it holds {}", packs.size()),
                "give one of " + names + "; orris validate --recursive checks all", diagnostics);
}

/// Absent when the folder is no pack.
std::optional<fs::path> rootInside(const fs::path& folder) {
  std::error_code error;
  if (fs::is_directory(folder / "shaders", error)) return folder / "shaders";
  fs::path named = folder.has_filename() ? folder : folder.parent_path();
  if (named == "." || named == "..") named = fs::canonical(named, error);
  return named.filename() == "shaders" ? std::optional(folder) : std::nullopt;
}

}  // namespace

bool isBesideShaders(std::string_view path) { return path.starts_with("/../"); }

std::optional<std::string> FileSource::readResource(std::string_view path) const {
  return isBesideShaders(path) ? std::nullopt : read(path);
}

bool FileSource::contains(std::string_view path) const {
  return std::binary_search(files().begin(), files().end(), path);
}

std::unique_ptr<FileSource> memorySource(std::map<std::string, std::string> files) {
  return std::make_unique<MemorySource>(std::move(files));
}

std::unique_ptr<FileSource> openPack(const std::string& path, Diagnostics& diagnostics,
                                     const PackLimits& limits) {
  std::error_code error;
  if (!fs::exists(path, error)) {
    return refuse(path, "no such shader pack", "give a folder or a .zip", diagnostics);
  }
  if (!fs::is_directory(path, error)) {
    if (!fs::is_regular_file(path, error))
      return refuse(path, "no shader pack: neither a folder nor a file", "give a folder or a .zip",
                    diagnostics);
    return openPackZip(path, limits, diagnostics);
  }
  const auto root = rootInside(path);
  if (!root) return refuseFolder(path, diagnostics);
  // A path that the user wrote may be a link to anywhere; what a pack brings along may not.
  if (!liesBelow(path, root->string()) || isHiddenBelow(path, root->string())) {
    return refuse((fs::path(path) / "shaders").string(),
                  "this symbolic link leads out of the pack or to what is hidden; it is not followed",
                  "put the folder itself into the pack, or give the folder that it leads to",
                  diagnostics);
  }
  const bool given = fs::equivalent(*root, path, error);
  return openFolder(root->string(), given ? "" : path, limits, diagnostics);
}

}  // namespace orris
