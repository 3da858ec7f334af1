// The token rewrites that make pack sources compile in a compatibility-profile context. Each is a
// named rule; what fired is reported. Contract: contract/README "Profiles and the patcher",
// real-packs.md section 3.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orris/glsl/tokens/token.h>

namespace orris {

enum class Stage { Vertex, TessControl, TessEvaluation, Geometry, Fragment, Compute };
const char* stageExtension(Stage stage);  ///< "vsh", "tcs", "tes", "gsh", "fsh", "csh"
const char* stageName(Stage stage);       ///< "vertex", ...

/// A rule that changed something: rule name, times, and the first place.
struct AppliedRule {
  std::string rule;
  int count = 0;
  SourceLocation first;
};

/// What rewriting did and found.
struct RewriteResult {
  std::vector<AppliedRule> rules;
  /// A fragment stage that writes gl_FragData or gl_FragColor: only these take the fixed-function
  /// alpha test (Iris injects its discard only there).
  bool writesFragData = false;
};

/// A name that the host declares in a stage that uses it without declaring it.
struct HostName {
  std::string_view name;
  std::string_view declaration;  ///< GLSL, whole
  std::optional<Stage> stage{};  ///< the only one to have it; none: all
};

/// Applies all rules in order; edits `stream` in place. `moreNames` are host names of this kind of
/// program besides those that every program has. The rules, by the name reported:
/// - extensions: #extension lines that core GLSL 4.50 contains are dropped
/// - attribute-varying: attribute, varying -> in, out (in two stages); float-literals: 1f -> 1.0f
/// - texture-functions: texture2D, shadow2D, texelFetch2D, ... -> the GLSL 4.50 names
/// - texture-name: a sampler named texture or gcolor -> gtexture, other variables -> orris_texture
/// - reserved-names: words newer GLSL reserves, used as names (sample) -> orris_<word>
/// - stray-semicolon, unused-functions: empty declarations, functions named nowhere else are dropped
/// - shared-bounds: indices of shared variables that are no literals stay inside of their arrays
/// - global-const: `const` is dropped from globals whose initialiser is not constant
/// - mix-bool: mix(vecN, vecN, bool) -> orris_mix with its overloads
/// - entity-id: uint(... mc_Entity ...) -> uint(max(... mc_Entity ..., 0.0)) in vertex stages
/// - zero-init: variables declared without a value, small arrays and structs included, are zero
/// - out-color: an output outColorN without layout gets location N
/// - frag-data: gl_FragData and gl_FragColor beside outputs of the pack's own -> orris_FragDataN
/// - host-names: names Iris provides (entityId, vaPosition, ...) used without declaration
/// - version: "450 compatibility"; compute: the pack's version, at least 430
RewriteResult rewrite(TokenStream& stream, Stage stage, std::span<const HostName> moreNames = {});

}  // namespace orris
