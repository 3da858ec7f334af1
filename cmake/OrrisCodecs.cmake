# The module of picture codecs, which orris_image loads at the first picture that is no PNG. Programs find it by their
# run path: in the build tree, installed, and those of others that link the installed libraries.
set(codecs_dir ${CMAKE_INSTALL_LIBDIR}/orris)
set(codecs_file orris-image-codecs.so)

# By pkg-config: its CMake files name things that Debian does not install with them.
pkg_check_modules(OpenImageIO REQUIRED IMPORTED_TARGET OpenImageIO)
add_library(orris_image_codecs MODULE image/codecs/openimageio_codecs.cpp)
target_include_directories(orris_image_codecs PRIVATE ${PROJECT_BINARY_DIR}/include)
target_link_libraries(orris_image_codecs PRIVATE PkgConfig::OpenImageIO orris_warnings)
set_target_properties(orris_image_codecs PROPERTIES
  PREFIX "" OUTPUT_NAME orris-image-codecs LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})

target_compile_definitions(orris_image PRIVATE ORRIS_CODECS_MODULE="${codecs_file}")
add_dependencies(orris_image orris_image_codecs)
target_link_options(orris_image INTERFACE
  $<INSTALL_INTERFACE:-Wl,-rpath,$<INSTALL_PREFIX>/${codecs_dir}>)
install(TARGETS orris_image_codecs LIBRARY DESTINATION ${codecs_dir} COMPONENT orris)
