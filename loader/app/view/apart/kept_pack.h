// What a window goes on with when the process that draws for it dies: the pack as it was when it last drew a
// frame, in memory that outlives that process.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <orris/pack/shader_pack.h>
#include <orris/world/world.h>

namespace orris {

/// A pack and where its viewer stood.
struct KeptState {
  std::vector<std::string> files;            ///< all there were, sorted
  std::map<std::string, std::string> texts;  ///< pack path -> text, of programs and properties
  OptionValues values;                       ///< that are not the default
  std::optional<Camera> camera;              ///< absent in another world than the first
};

/// Made before the process that draws is forked. That one writes, the next one reads; who watches them asks
/// canGoOn() alone, for what is here comes from a process that may have been taken over.
class KeptPack {
 public:
  KeptPack();
  ~KeptPack();
  KeptPack(const KeptPack&) = delete;
  KeptPack& operator=(const KeptPack&) = delete;

  /// The pack has drawn a frame; `camera` as in KeptState.
  void drew(const std::shared_ptr<const ShaderPack>& pack, const std::optional<Camera>& camera);
  /// Something else than the pack that is kept is being read, built or drawn for the first time.
  void setAtRisk(bool risk);

  /// Is there a pack that is not the one which the process died of?
  bool canGoOn() const;
  /// nullopt: none is kept.
  std::optional<KeptState> state() const;
  /// Files that are newer have not been read by the process that died.
  std::filesystem::file_time_type riskSince() const;

 private:
  struct Shared;
  Shared* shared_ = nullptr;  ///< nullptr: there is no memory, and nothing is kept
  std::shared_ptr<const ShaderPack> last_;
};

/// The files of `state`; those that are no texts of it are read from `below`.
std::shared_ptr<const FileSource> keptFiles(const KeptState& state, std::shared_ptr<const FileSource> below);

}  // namespace orris
