# What is there is taken: CMake's own file of it would bring all of /usr/include.
set(PACKAGE_VERSION ${PACKAGE_FIND_VERSION})
set(PACKAGE_VERSION_COMPATIBLE TRUE)
