// Tables of version_hints.h: what GLSL has since when, and what core GLSL does not have.
#pragma once

#include <span>
#include <string_view>

namespace orris {

/// A name or construct as glslang quotes it: 'fma', 'std430', 'arrays of arrays'.
struct VersionFeature {
  std::string_view quoted;     ///< ending in '*': whatever begins so
  int since = 0;               ///< 0: no version has it, only the extension
  std::string_view extension;  ///< that has it, too; "" for none
};

/// A name of old GLSL and what to write instead.
struct RemovedName {
  std::string_view name;  ///< ending in '*': whatever begins so
  std::string_view advice;
};

const VersionFeature* findVersionFeature(std::string_view quoted);
/// Keywords that an older version reads as a name, so that the line is a syntax error.
std::span<const VersionFeature> newKeywords();
const RemovedName* findRemovedName(std::string_view name);

}  // namespace orris
