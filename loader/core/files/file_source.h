// Bytes by pack path, wherever they come from: a folder, a zip, or memory (tests, fuzzers).
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <orris/core/diagnostic.h>

namespace orris {

/// Read-only files by normalised path ("/lib/a.glsl"); the root is the pack's `shaders` folder.
/// Case-sensitive. A symbolic link that leaves the root is not followed. Safe to read from several
/// threads.
class FileSource {
 public:
  virtual ~FileSource() = default;
  virtual std::optional<std::string> read(std::string_view path) const = 0;
  /// All file paths, sorted.
  virtual const std::vector<std::string>& files() const = 0;
  bool contains(std::string_view path) const;
  /// What a texture or buffer names (AboveRoot::Beside): as read(), and "/../assets/a.png" is a file
  /// of the pack beside its `shaders` folder. files() lists none of those.
  virtual std::optional<std::string> readResource(std::string_view path) const;
};

/// Is it a file beside the `shaders` folder, "/../assets/a.png"?
bool isBesideShaders(std::string_view path);

/// What openPack() accepts at most.
struct PackLimits {
  std::size_t fileBytes = std::size_t{64} << 20;
  std::size_t totalBytes = std::size_t{1} << 30;
  std::size_t zipBytes = std::size_t{256} << 20;  ///< as it lies on the disk; it is held in memory
  std::size_t files = 65536;
  int folderDepth = 32;
};

/// Files held in memory. Paths that leave the folder of the root are left out.
std::unique_ptr<FileSource> memorySource(std::map<std::string, std::string> files);

/// Opens a pack: a folder with `shaders/` inside (or that is itself named `shaders`), or a zip whose
/// first directory named `shaders` is the root. The pack is what holds `shaders/`; of a path that is
/// itself the `shaders` folder nothing beside it is read. Limits: 64 MiB a file, 1 GiB in all, 65536
/// files, 256 MiB for the zip itself.
/// nullptr and a diagnostic when it cannot be opened.
std::unique_ptr<FileSource> openPack(const std::string& path, Diagnostics& diagnostics,
                                     const PackLimits& limits = {});

}  // namespace orris
