# Packages of this system that are headers alone, for compilers of other systems: these must not see all
# of /usr/include, which has the system's own headers, too.
set(BRINDLE_SYSTEM_HEADERS /usr/include CACHE PATH "Where hwy, nanoflann.hpp and nlohmann are")
set(BRINDLE_HEADER_LINKS ${CMAKE_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${BRINDLE_HEADER_LINKS})
foreach(name hwy nanoflann.hpp nlohmann)
  file(CREATE_LINK ${BRINDLE_SYSTEM_HEADERS}/${name} ${BRINDLE_HEADER_LINKS}/${name} SYMBOLIC)
endforeach()
foreach(package hwy nanoflann nlohmann_json)
  set(${package}_DIR ${CMAKE_CURRENT_LIST_DIR}/header_packages)
endforeach()
set(Eigen3_DIR ${BRINDLE_SYSTEM_HEADERS}/../share/eigen3/cmake CACHE PATH "Eigen")
