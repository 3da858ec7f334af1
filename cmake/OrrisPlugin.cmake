# liborris.so: the C interface <orris/orris.h>, with all that it needs of the static libraries inside. Of
# its symbols only orris_* are seen from outside.
file(GLOB api_sources CONFIGURE_DEPENDS api/*.cpp)
add_library(orris_api SHARED ${api_sources})
target_include_directories(orris_api
  PRIVATE ${PROJECT_BINARY_DIR}/include
  PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/api/include>
         $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_link_libraries(orris_api PRIVATE orris_render orris_warnings ${CMAKE_DL_LIBS})
target_compile_definitions(orris_api PRIVATE ORRIS_VERSION="${PROJECT_VERSION}")
file(STRINGS api/include/orris/orris.h version REGEX "^#define ORRIS_API_VERSION ")
string(REGEX REPLACE ".* " "" version "${version}")
set_target_properties(orris_api PROPERTIES
  OUTPUT_NAME orris VERSION ${version}.${PROJECT_VERSION} SOVERSION ${version} EXPORT_NAME api
  LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}
  CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
  INSTALL_RPATH "$ORIGIN/orris"  # where the module of picture codecs lies
  LINK_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/api/symbols.map)
target_link_options(orris_api PRIVATE
  -Wl,--version-script=${CMAKE_CURRENT_SOURCE_DIR}/api/symbols.map)
set_property(GLOBAL APPEND PROPERTY ORRIS_FOLDERS api)
set_property(GLOBAL PROPERTY ORRIS_USES_api core image glsl pack world plan gl render)

file(RELATIVE_PATH up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)  # from there to the prefix
configure_file(${PROJECT_SOURCE_DIR}/cmake/orris.pc.in ${PROJECT_BINARY_DIR}/orris.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/orris.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
install(FILES api/include/orris/orris.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/orris)
