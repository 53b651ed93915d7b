# Installs the library so that find_package(brindle) finds brindle::brindle, wherever the prefix is
# moved to.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/brindle)
install(TARGETS brindle EXPORT brindle-targets)
# Headers of parts that this build leaves out declare what nobody could link.
get_property(left_out GLOBAL PROPERTY BRINDLE_HEADERS_LEFT_OUT)
foreach(header ${left_out})
  list(APPEND exclusions PATTERN ${header}.h EXCLUDE)
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/brindle DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        FILES_MATCHING PATTERN *.h ${exclusions})
install(EXPORT brindle-targets NAMESPACE brindle:: DESTINATION ${package_dir})

set(BRINDLE_INSTALLED_SHADERS ${CMAKE_INSTALL_DATADIR}/brindle/shaders)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/brindle-config.cmake.in
                              ${PROJECT_BINARY_DIR}/brindle-config.cmake
                              INSTALL_DESTINATION ${package_dir}
                              PATH_VARS BRINDLE_INSTALLED_SHADERS)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/brindle-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/brindle-config.cmake
              ${PROJECT_BINARY_DIR}/brindle-config-version.cmake
              ${PROJECT_SOURCE_DIR}/cmake/FindCHOLMOD.cmake
        DESTINATION ${package_dir})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
