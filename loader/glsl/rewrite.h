// The token rewrites that make pack sources compile in a compatibility-profile context. Each is a
// named rule; what fired is reported. Contract: contract/README "Profiles and the patcher",
// real-packs.md section 3.
#pragma once

#include <string>
#include <vector>

#include "glsl/token.h"

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

/// Applies all rules in order; edits `stream` in place. Rules: version, attribute-varying,
/// texture-functions, texture-name, host-names, unused-functions, global-const, mix-bool,
/// interface-repair and what else a real pack turns out to need. Every version becomes
/// "450 compatibility" (compute: the pack's, at least 430).
RewriteResult rewrite(TokenStream& stream, Stage stage);

}  // namespace orris
