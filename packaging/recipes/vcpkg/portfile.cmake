# The library alone. Not run yet: there is no vcpkg where it was written; CMake has read it with
# functions of vcpkg that do nothing.
vcpkg_download_distfile(archive
  URLS "@URL@"
  FILENAME "@NAME@-@VERSION@.tar.gz"
  SHA512 @SHA512@)
vcpkg_extract_source_archive(SOURCE_PATH ARCHIVE "${archive}")
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS -DBRINDLE_APPS=OFF -DBRINDLE_TESTS=OFF -DBRINDLE_GL=OFF -DBRINDLE_C=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/brindle)
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
