# The Debian package `orris`: cpack -G DEB in the build folder. It holds the command with its man page
# and completion, the documents, the reference pack and the small worlds; the libraries and headers
# are for cmake --install.
include(GNUInstallDirs)
set(doc_dir ${CMAKE_INSTALL_DATADIR}/doc/orris)
set(package_files ${PROJECT_BINARY_DIR}/package)

# Debian's policy wants man page and changelog compressed, without a time stamp inside.
function(orris_compress input output)
  execute_process(COMMAND gzip -9nc ${input} OUTPUT_FILE ${package_files}/${output}
                  COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(maintainer "Orris maintainers <maintainers@orris.invalid>")
string(TIMESTAMP date "%a, %d %b %Y 00:00:00 +0000" UTC)  # SOURCE_DATE_EPOCH, when set
file(MAKE_DIRECTORY ${package_files})
file(WRITE ${package_files}/changelog
     "orris (${PROJECT_VERSION}) stable; urgency=low\n\n  * Release ${PROJECT_VERSION}.\n\n"
     " -- ${maintainer}  ${date}\n")
orris_compress(${package_files}/changelog changelog.gz)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS docs/orris.1)
orris_compress(${PROJECT_SOURCE_DIR}/docs/orris.1 orris.1.gz)

install(FILES ${package_files}/orris.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1
        COMPONENT orris)
install(FILES share/orris.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
        RENAME orris COMPONENT orris)
install(FILES ${package_files}/changelog.gz DESTINATION ${doc_dir} COMPONENT orris)
install(FILES LICENSE DESTINATION ${doc_dir} RENAME copyright COMPONENT orris)
install(DIRECTORY docs/ DESTINATION ${doc_dir} COMPONENT orris
        FILES_MATCHING PATTERN "*.md" PATTERN "*.json" PATTERN "*.yml" PATTERN "*.png" PATTERN "*.csv")
install(DIRECTORY shaderpack worlds DESTINATION ${CMAKE_INSTALL_DATADIR}/orris COMPONENT orris)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL orris)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PACKAGE_CONTACT ${maintainer})
set(CPACK_DEBIAN_ORRIS_PACKAGE_NAME orris)
set(CPACK_DEBIAN_ORRIS_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_ORRIS_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_HOMEPAGE ${PROJECT_HOMEPAGE_URL})
set(CPACK_COMPONENT_ORRIS_DESCRIPTION
    "Validates, renders and measures Minecraft shader packs made for Iris and
OptiFine, without a game, a window or a GPU.")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Opened at run time, so that dpkg-shlibdeps does not see them; one of the two ways is enough.
set(CPACK_DEBIAN_ORRIS_PACKAGE_DEPENDS "libosmesa6 | libgl1-mesa-dri")
set(CPACK_DEBIAN_ORRIS_PACKAGE_RECOMMENDS "libegl1, libegl-mesa0, libgl1-mesa-dri, graphviz, gnuplot-nox")
include(CPack)
