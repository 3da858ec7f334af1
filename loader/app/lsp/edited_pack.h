// One pack as the editor sees it: its files with the edits that nobody has saved, and what is known of them.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/lsp/background_check.h"
#include <orris/check/hints/definition_index.h>
#include <orris/pack/shader_pack.h>

namespace orris {

/// What one reading of the pack says.
struct PackKnowledge {
  explicit PackKnowledge(ShaderPack loaded) : pack(std::move(loaded)), index(pack) {}
  ShaderPack pack;  ///< options, properties and screens; no sources
  std::string valuesFrom;  ///< the option file that set values, "" for none
  DefinitionIndex index;
};

class EditedPack {
 public:
  /// `root` holds `shaders`.
  EditedPack(std::string root, ValidateOptions options)
      : check(root, std::move(options)), root_(std::move(root)) {}

  const std::string& root() const { return root_; }
  /// The pack's path of a file below `shaders`; "" for others.
  std::string packPath(const std::string& file) const;
  std::string filePath(const std::string& packPath) const;

  void edit(const std::string& packPath, std::string text);
  void close(const std::string& packPath);
  void changedOnDisk(const std::string& packPath);
  const Overlay& overlay() const { return overlay_; }
  /// The text that counts; "" where there is none.
  std::string text(const std::string& packPath);

  /// Read again after an edit.
  PackKnowledge& knowledge();
  /// Of an earlier edit, where that will do; never slow but for the first time.
  PackKnowledge& roughKnowledge();

  BackgroundCheck check;
  bool waiting = false;  ///< edits have not been checked
  void startCheck();
  /// The whole pack was checked.
  void checked();

 private:
  std::shared_ptr<const FileSource> open();
  std::string root_;
  Overlay overlay_;
  std::set<std::string> changed_;  ///< since the last whole check
  bool checkedOnce_ = false;
  std::unique_ptr<PackKnowledge> knowledge_;
  bool stale_ = true;
};

/// The folder that holds the `shaders` of a file; "" for a file of no pack.
std::string packRootOf(const std::string& file);

}  // namespace orris
