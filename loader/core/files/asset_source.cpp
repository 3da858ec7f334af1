#include <orris/core/files/asset_source.h>

#include <filesystem>

#include <orris/core/files/folder_source.h>
#include <orris/core/files/read_file.h>
#include <orris/core/files/zip_source.h>

namespace orris {
namespace {

namespace fs = std::filesystem;

constexpr PackLimits kAssetLimits = {
    .fileBytes = std::size_t{64} << 20, .totalBytes = std::size_t{4} << 30, .files = 262144};

std::unique_ptr<FileSource> refuseAssets(const std::string& path, std::string message,
                                         Diagnostics& diagnostics) {
  diagnostics.push_back(
      {.severity = Severity::Error,
       .id = "resource-pack-unreadable",
       .at = {.file = path},
       .message = std::move(message),
       .hint = "give the folder that holds assets/, a zip of it, or the game's own .jar"});
  return nullptr;
}

std::unique_ptr<FileSource> openAssetFolder(const std::string& path, Diagnostics& diagnostics) {
  std::error_code error;
  const fs::path given = fs::canonical(path, error), inside = given / "assets";
  if (given.filename() == "assets") return openFolder(given, "", kAssetLimits, diagnostics);
  if (!fs::is_directory(inside, error))
    return refuseAssets(path, "no resource pack: the folder has no folder named assets",
                        diagnostics);
  if (!liesBelow(given, inside))
    return refuseAssets(path, "the symbolic link assets leads out of the pack", diagnostics);
  return openFolder(inside, "", kAssetLimits, diagnostics);
}

}  // namespace

std::unique_ptr<FileSource> openAssets(const std::string& path, Diagnostics& diagnostics) {
  std::error_code error;
  if (fs::is_directory(path, error)) return openAssetFolder(path, diagnostics);
  if (!fs::is_regular_file(path, error))
    return refuseAssets(path, "no such folder or file", diagnostics);
  auto source = openZipBelow(path, "/assets", kAssetLimits, diagnostics);
  if (source && source->files().empty())
    return refuseAssets(path, "no resource pack: the zip has no folder named assets", diagnostics);
  return source;
}

}  // namespace orris
