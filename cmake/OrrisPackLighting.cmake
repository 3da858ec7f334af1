# The reference pack inside of the library `trace`: all its files as they are, and its formulas of
# light as C++. GLSL and C++ with glm differ little in them: literals want an f, constants a static,
# arrays braces.
set(pack_folder ${PROJECT_SOURCE_DIR}/shaderpack/shaders)

function(orris_glsl_to_cpp file output)
  file(READ ${pack_folder}/${file} text)
  string(REGEX REPLACE "#if !defined INCLUDED_[A-Z_]+\n#define INCLUDED_[A-Z_]+\n" "" text "${text}")
  string(REGEX REPLACE "#endif\n*$" "" text "${text}")
  string(REGEX REPLACE "\n#include [^\n]*" "" text "${text}")
  string(REGEX REPLACE "(^|[^A-Za-z0-9_.])([0-9]+\\.[0-9]+(e-?[0-9]+)?|[0-9]+e-?[0-9]+)" "\\1\\2f"
         text "${text}")
  string(REGEX REPLACE "=[ \n]*(vec3|float)\\[[0-9]+\\]\\(([^;]*)\\);" "= {\\2};" text "${text}")
  string(REGEX REPLACE "\nconst (float|int) " "\nstatic constexpr \\1 " text "${text}")
  set(${output} "${text}" PARENT_SCOPE)
endfunction()

# One declaration of a file, by a regular expression that must match.
function(orris_glsl_part text pattern output)
  string(REGEX MATCH "${pattern}" part "${text}")
  if(NOT part)
    message(FATAL_ERROR "shaderpack: nothing matches ${pattern}; the library trace needs it")
  endif()
  set(${output} "${part}\n" PARENT_SCOPE)
endfunction()

set(functions "")
foreach(file include/math/color.glsl include/math/sampling.glsl include/blocks.glsl
        include/sky/sky.glsl include/brdf/direct.glsl include/brdf/glossy.glsl)
  orris_glsl_to_cpp(${file} text)
  if(file MATCHES "direct")
    # Which of the two reflects is chosen at run time.
    string(REGEX REPLACE "/// Radiance toward `v`.*" "" text "${text}")
  endif()
  string(APPEND functions "${text}\n")
endforeach()
orris_glsl_to_cpp(include/voxels/voxel.glsl text)
foreach(pattern "static constexpr float small_lamp_radius[^;]*;"
        "static constexpr float small_lamp_boost[^;]*;" "vec3 lamp_radiance[^}]*}")
  orris_glsl_part("${text}" "${pattern}" part)
  string(APPEND functions "${part}")
endforeach()
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/trace/reference_pack_functions.inc
     CONTENT "@functions@" @ONLY)

file(GLOB_RECURSE pack_files CONFIGURE_DEPENDS RELATIVE ${pack_folder} ${pack_folder}/*)
set(rows "")
foreach(file IN LISTS pack_files)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${pack_folder}/${file})
  file(READ ${pack_folder}/${file} text)
  string(APPEND rows "    {\"/${file}\", R\"orris(${text})orris\"},\n")
endforeach()
configure_file(trace/light/reference_pack_files.cpp.in trace/reference_pack_files.cpp @ONLY)
