// What is known of a scene and a view of it, for options that choose by it (pack/options/auto_option.h).
#pragma once

#include <set>
#include <string>

#include <orris/pack/options/auto_option.h>
#include <orris/plan/frame/frame_state.h>
#include <orris/plan/scene/scene_data.h>

namespace orris {

/// The quantities named in `wanted`, of sceneQuantities(). `view` has picture, eye and light.
Quantities measureScene(const SceneData& scene, const FrameState& view,
                        const PackDirectives& directives, const std::set<std::string>& wanted);

}  // namespace orris
