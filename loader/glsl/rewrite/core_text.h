// The text of a program for a core-profile context, made of the text for a compatibility context, so
// that both draw the same picture. Old names become attributes and uniforms of the host, under Iris's
// names where Iris has such. Iris: CompatibilityTransformer, VanillaTransformer.
#pragma once

#include <vector>

#include <orris/glsl/compile/validate.h>

namespace orris {

/// The stages of one program, in their order, whole: what a stage reads, the one before declares.
/// - attributes and matrices of old GLSL -> iris_Position, iris_ModelView, ... (core_names.h)
/// - gl_FrontColor, gl_TexCoord, gl_FogFragCoord -> outputs and inputs of the stages; no vertex colour
///   is clamped. Built-in arrays of geometry and tessellation stages (gl_in[i].gl_TexCoord) stay.
/// - gl_FragData and gl_FragColor -> one array of outputs; the alpha test that a compatibility context
///   makes stands at the end of main, with uniforms iris_AlphaFunction and iris_AlphaReference
/// - the profile of #version -> core
std::vector<StageText> coreTexts(const std::vector<const StageText*>& stages);

}  // namespace orris
