// What a pack is without its sources: the first thing that a check reads.
#pragma once

#include <memory>

#include <orris/pack/shader_pack.h>
#include <orris/validate/validate_pack.h>

namespace orris {

struct PackOutline {
  std::shared_ptr<const FileSource> files;
  HostVersions versions;
  Diagnostics diagnostics;
  std::shared_ptr<const ShaderPack> pack;  ///< nullptr: it cannot be read at all
  LoadRequest request;                     ///< for its programs
};

std::shared_ptr<const PackOutline> readOutline(const HostVersions& versions,
                                               const ValidateOptions& options,
                                               const Checker& checker,
                                               const std::shared_ptr<const FileSource>& files);

}  // namespace orris
