# Installs the command, the libraries with their headers, and what find_package(Orris) reads:
# Orris::orris is everything, Orris::core, Orris::pack, ... are the single folders, Orris::api is liborris.so.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/Orris)

add_library(orris_all INTERFACE)
target_link_libraries(orris_all INTERFACE orris_validate orris_chart orris_trace)
set_target_properties(orris_all PROPERTIES EXPORT_NAME orris)
add_library(Orris::orris ALIAS orris_all)

get_property(folders GLOBAL PROPERTY ORRIS_FOLDERS)
foreach(folder IN LISTS folders)
  set_target_properties(orris_${folder} PROPERTIES EXPORT_NAME ${folder})
  add_library(Orris::${folder} ALIAS orris_${folder})
  install(TARGETS orris_${folder} EXPORT OrrisTargets)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/loader/${folder}
          DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/orris FILES_MATCHING PATTERN "*.h" PATTERN "include" EXCLUDE)
endforeach()
install(TARGETS orris_all EXPORT OrrisTargets)
install(TARGETS orris COMPONENT orris)

install(EXPORT OrrisTargets NAMESPACE Orris:: DESTINATION ${package_dir})
configure_package_config_file(cmake/OrrisConfig.cmake.in OrrisConfig.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(OrrisConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/OrrisConfig.cmake ${PROJECT_BINARY_DIR}/OrrisConfigVersion.cmake
              cmake/OrrisDependencies.cmake DESTINATION ${package_dir})
