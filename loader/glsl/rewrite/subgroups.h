// Operations of GL_KHR_shader_subgroup_* for a driver that lacks them: rule subgroups.
#pragma once

#include <optional>

#include <orris/glsl/compile/validate.h>

namespace orris {

inline constexpr const char* kSubgroupsRule = "subgroups";

/// The text with functions of the host for the operations that it names (basic, vote, arithmetic,
/// ballot, shuffle, shuffle_relative, clustered, quad). A subgroup of a compute stage has 32
/// invocations, of another stage one. In a compute stage they exchange values by
/// shared memory between barriers, also in branches that not all invocations take: for the software
/// rasteriser, whose invocations run through all code side by side. nullopt: the text names none.
std::optional<StageText> emulateSubgroups(const StageText& stage);

}  // namespace orris
