# What nearly every source includes, compiled once for all targets that are compiled alike: with the same options and, where
# both define a macro, with the same value (-Winvalid-pch says when they are not taken). Sources go on to include what they
# use: the preset `dev` and what inherits it have no precompiled headers, and a test compiles each source alone
# (tests/compile_alone.py).
set(orris_headers <algorithm> <array> <cmath> <chrono> <filesystem> <functional> <map> <memory> <optional> <set> <span>
    <string> <vector> <fmt/format.h> <glm/glm.hpp>)

# A compiler cache keeps nothing that was compiled with them.
if(CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
endif()

# The first target of a kind compiles the headers of the kind, and those given after it; the others take them over.
function(orris_precompiled target kind)
  get_property(owner GLOBAL PROPERTY ORRIS_PRECOMPILED_${kind})
  if(owner)
    target_precompile_headers(${target} REUSE_FROM ${owner})
  else()
    target_precompile_headers(${target} PRIVATE ${orris_headers} ${ARGN})
    set_property(GLOBAL PROPERTY ORRIS_PRECOMPILED_${kind} ${target})
  endif()
endfunction()
