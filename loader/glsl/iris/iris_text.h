// The text that Iris hands to the driver: core GLSL of the author's version, with Iris's own
// attributes and uniforms in place of the built-ins of old GLSL. It is what a program is judged by;
// what a compatibility context draws with is made by rewrite(). Contract: contract/README "Profiles
// and the patcher". Iris: TransformPatcher.
#pragma once

#include <span>

#include <orris/glsl/rewrite/rewrite.h>

namespace orris {

/// Which of Iris's patchers takes a program.
enum class IrisPatch {
  None,        ///< none: Iris does not draw it
  Fullscreen,  ///< begin, shadowcomp, prepare, deferred, composite, final
  Compute,     ///< all compute shaders
  Vanilla,     ///< gbuffers and shadow with the game's attributes
  Terrain,     ///< terrain and its shadow, with Sodium's packed attributes
  DistantHorizons
};

struct IrisProgram {
  IrisPatch patch = IrisPatch::None;
  bool entities = false;  ///< its vertices name an entity and have an overlay colour
  bool lines = false;     ///< gbuffers_line: Iris takes it for core GLSL whatever it says
  bool clouds = false;    ///< gbuffers_clouds: no attributes, its vertices come from a buffer
  bool generic = false;   ///< dh_generic, which has uniforms of its own
};

/// Does Iris take a stage for core GLSL (names such as vaPosition), not for compatibility GLSL (names
/// such as gl_Vertex)? From its #version line. Compute shaders have one kind only.
bool isCoreForIris(const TokenStream& stream, const IrisProgram& program);

/// Iris sends no stage with a lower version.
inline constexpr int kLeastIrisVersion = 330;

/// As rewrite(), into the text that Iris makes. The rules of rewrite() that Iris has too keep their
/// names: attribute-varying, float-literals, texture-functions, texture-name, reserved-names,
/// (here noise1 to noise4, too), stray-semicolon, unused-functions, out-color, host-names. Others:
/// - iris-extensions: an #extension that a later version of GLSL contains raises the version to it
/// - iris-const: `const` is dropped where the initialiser names a const parameter, and where it calls
///   a function that glslang does not fold
/// - iris-frag-data: gl_FragColor and gl_FragData[n] -> iris_FragDataN
/// - iris-entity: an int mc_Entity of terrain becomes a uint made of an int; in a fragment stage any
///   becomes a uint input
/// - iris-names: built-ins of compatibility GLSL that Iris knows -> its own; others stay, and core
///   GLSL has no such name. What Iris declares by itself and the author declares, too, is there twice
/// - iris-version: the author's version, at least 330, and core
RewriteResult rewriteAsIris(TokenStream& stream, Stage stage, const IrisProgram& program,
                            std::span<const HostName> moreNames = {});

}  // namespace orris
