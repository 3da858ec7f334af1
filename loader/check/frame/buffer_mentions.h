// Which buffers the files of a pack mention in any branch, under any option and in any folder: what
// a check asks before it calls a buffer unused. Nothing is preprocessed.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include <orris/pack/shader_pack.h>
#include <orris/plan/schedule/program_uses.h>

namespace orris {

struct BufferMentions {
  std::set<int> color, shadowColor;            ///< sampled or loaded: named outside declarations
  std::set<int> colorImages, shadowImages;     ///< the same through colorimgN
  std::set<int> keptColor, keptShadow;         ///< some line sets <buffer>Clear to false
  std::set<int> mipmapped, shadowMipmapped;    ///< some line sets <buffer>MipmapEnabled to true
  std::map<std::string, std::set<int>> drawn;  ///< by file: what RENDERTARGETS, DRAWBUFFERS list
  std::set<int> drawnAnywhere;  ///< by files that a program of any folder reads
  /// Formats that some line gives, upper case; a word that is no format when a macro stands there.
  std::map<int, std::set<std::string>> formats, shadowFormats;
  bool pasted = false;  ///< some macro pastes buffer names together (colortex ## N)
};

/// Can the file hold GLSL, by its name?
bool isShaderText(std::string_view path);

/// Reads every text file of the pack, those that nothing includes too.
BufferMentions findBufferMentions(const ShaderPack& pack);

}  // namespace orris
