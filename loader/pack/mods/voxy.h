// The part of a pack that the mod Voxy takes: voxy.json lists what it must declare, and
// voxy_opaque.glsl and voxy_translucent.glsl define voxy_emitFragment(), which it calls.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <orris/glsl/tokens/token.h>

namespace orris {

inline constexpr std::string_view kVoxyInterfaceFile = "voxy.json";
inline constexpr int kVoxyVersion = 450;  ///< of GLSL; the mod uses a newer one, which adds little
inline constexpr std::string_view kVoxyPrograms[] = {"voxy_opaque", "voxy_translucent"};

/// Is it a file that Voxy reads, in whatever folder?
bool isVoxyFile(std::string_view path);

/// What voxy.json asks for.
struct VoxyInterface {
  std::vector<std::string> uniforms;
  std::vector<std::pair<std::string, std::string>> samplers;  ///< name, GLSL type
  std::vector<std::pair<std::string, std::string>> buffers;   ///< binding, "{members} name"
};

/// From the preprocessed file. It is no strict JSON (texts run over lines, keys may lack quotes), so
/// only the three lists are looked for.
VoxyInterface readVoxyInterface(const TokenStream& json);

/// What stands before the pack's code, GLSL. nullopt when `typeOf` knows no type ("") of a uniform in
/// the list: then nothing can be said about the program.
std::optional<std::string> voxyPrelude(
    const VoxyInterface& interface, const std::function<std::string(const std::string&)>& typeOf);

/// The fragment shader around the pack's `patch`, and the vertex shader beside it.
TokenStream voxyFragment(TokenStream patch, const std::string& prelude);
TokenStream voxyVertex();
/// After the rewrites: what the mod compiles has the core profile.
void keepVoxyVersion(TokenStream& stream);

}  // namespace orris
