// Where an #if or #endif belongs that a file lacks: of the places that its layout allows, the first one
// with which its programs compile.
#pragma once

#include <vector>

#include <orris/check/hints/trial_memo.h>
#include <orris/core/diagnostic.h>
#include <orris/pack/shader_pack.h>

namespace orris {

/// Moves what `found`, the diagnostics of making each of the `folders` of a pack, says of such a
/// place to one that was tried. Compiles, so it works in processes of its own; what such a process is
/// lost with stays as it was. `trials` lends and learns what the places were found to do.
void settleConditionals(const std::vector<ShaderPack>& folders, int jobs,
                        TrialMemo& trials, std::vector<Diagnostics>& found);

}  // namespace orris
