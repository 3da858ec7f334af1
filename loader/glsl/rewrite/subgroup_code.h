// The GLSL of emulated subgroup operations (glsl/rewrite/subgroups.h).
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace orris {

/// Is `name` an operation that subgroupFunctions() knows?
bool isSubgroupFunction(std::string_view name);

/// Definitions of orris_NAME for each of `names`, for every type that it takes, and what they need.
/// `exchange`: between the invocations of a work group; else each invocation is alone.
std::string subgroupFunctions(const std::set<std::string>& names, bool exchange);

/// What stands for a built-in variable, gl_SubgroupSize and the others; "" for no such name.
std::string_view subgroupVariable(std::string_view name, bool exchange);

}  // namespace orris
