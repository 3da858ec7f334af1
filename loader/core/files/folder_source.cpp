#include <orris/core/files/folder_source.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include <orris/core/limits.h>
#include <orris/core/files/pack_path.h>
#include <orris/core/files/read_file.h>
#include <orris/core/files/read_places.h>

namespace orris {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kFolderAbove = "/../";

class FolderSource : public FileSource {
 public:
  /// `pack` holds `root`; empty when nothing beside `root` is of the pack.
  FolderSource(const fs::path& root, const fs::path& pack, const PackLimits& limits)
      : root_(fs::canonical(root)),
        pack_(pack.empty() ? pack : fs::canonical(pack)),
        limits_(limits) {
    addVisiblePlaces(root_);
    if (!pack_.empty()) addVisiblePlaces(pack_);
  }

  /// Lists all files; false and a diagnostic when a limit is passed.
  bool scan(Diagnostics& diagnostics) {
    const bool ok = scanFolder("", 0, diagnostics);
    std::sort(paths_.begin(), paths_.end());
    return ok;
  }

  std::optional<std::string> read(std::string_view path) const override {
    if (!contains(path)) return std::nullopt;
    ReadFault ignored{};
    return readFileBelow(root_.string(), std::string(path.substr(1)), limits_.fileBytes, ignored);
  }

  std::optional<std::string> readResource(std::string_view path) const override {
    if (!isBesideShaders(path)) return read(path);
    // Whoever made the path may not have resolved it.
    const auto normal = resolvePackPath("/", path, AboveRoot::Beside);
    if (pack_.empty() || !normal || !isBesideShaders(*normal)) return std::nullopt;
    ReadFault ignored{};
    return readFileBelow(pack_.string(), normal->substr(kFolderAbove.size()), limits_.fileBytes,
                         ignored);
  }

  const std::vector<std::string>& files() const override { return paths_; }

 private:
  /// All of a folder but what is hidden. A link in it leads to what is in the list by itself, or not to the pack.
  static void addVisiblePlaces(const fs::path& folder) {
    std::vector<std::string> places;
    bool whole = true;
    std::error_code error;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
      if (isHiddenName(it->path().filename().native()))
        whole = false;
      else if (!it->is_symlink(error))
        places.push_back(it->path().string());
    }
    if (whole) places = {folder.string()};
    for (const std::string& place : places) addReadPlace(place);
  }

  bool scanFolder(const std::string& folder, int depth, Diagnostics& diagnostics) {
    if (depth > limits_.folderDepth)
      return tooLarge(folder, "folders nested deeper than {}", limits_.folderDepth, diagnostics);
    // Two links in each of n folders are walked 2^n times.
    if (++folders_ > limits::kPackFolders)
      return tooLarge(folder, "more than {} folders, counting links", limits::kPackFolders,
                      diagnostics);
    std::error_code error;
    for (fs::directory_iterator
             it(root_ / folder.substr(std::min<size_t>(1, folder.size())), error),
         end;
         !error && it != end; it.increment(error)) {
      if (!scanEntry(folder + "/" + it->path().filename().string(), *it, depth, diagnostics))
        return false;
    }
    if (error) {
      diagnostics.push_back(
          {.severity = Severity::Error,
           .id = "pack-unreadable",
           .at = {.file = folder.empty() ? "/" : folder},
           .message = fmt::format("cannot list the folder: {}", error.message())});
    }
    return !error;
  }

  bool scanEntry(const std::string& path, const fs::directory_entry& entry, int depth,
                 Diagnostics& diagnostics) {
    std::error_code error;
    if (isHiddenName(entry.path().filename().native())) return true;
    if (entry.is_symlink(error) && !isOfPack(entry.path().string())) {
      diagnostics.push_back(
          {.severity = Severity::Warning,
           .id = "symlink-outside",
           .at = {.file = path},
           .message = "this symbolic link leads nowhere, out of the pack or to what is hidden; it is ignored",
           .hint = "put the file itself into the pack"});
      return true;
    }
    if (entry.is_directory(error)) return scanFolder(path, depth + 1, diagnostics);
    if (!entry.is_regular_file(error)) return true;
    const size_t size = static_cast<size_t>(entry.file_size(error));
    if (size > limits_.fileBytes)
      return tooLarge(path, "a file larger than {} bytes", limits_.fileBytes, diagnostics);
    total_ += size;
    if (total_ > limits_.totalBytes)
      return tooLarge(path, "more than {} bytes of files", limits_.totalBytes, diagnostics);
    paths_.push_back(path);
    return paths_.size() <= limits_.files ||
           tooLarge(path, "more than {} files", limits_.files, diagnostics);
  }

  bool isOfPack(const std::string& path) const {
    return liesBelow(root_.string(), path) && !isHiddenBelow(root_.string(), path);
  }

  template <typename Limit>
  static bool tooLarge(const std::string& path, std::string_view what, Limit limit,
                       Diagnostics& diagnostics) {
    diagnostics.push_back({.severity = Severity::Error,
                           .id = "pack-too-large",
                           .at = {.file = path.empty() ? "/" : path},
                           .message = "the pack has " + fmt::format(fmt::runtime(what), limit)});
    return false;
  }

  fs::path root_, pack_;
  PackLimits limits_;
  std::vector<std::string> paths_;
  size_t total_ = 0, folders_ = 0;
};

}  // namespace

std::unique_ptr<FileSource> openFolder(const std::string& root, const std::string& pack,
                                       const PackLimits& limits, Diagnostics& diagnostics) {
  auto source = std::make_unique<FolderSource>(root, pack, limits);
  return source->scan(diagnostics) ? std::move(source) : nullptr;
}

}  // namespace orris
