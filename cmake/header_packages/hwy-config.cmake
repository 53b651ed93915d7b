# Highway's headers alone: with one instruction set there is nothing to choose at run time.
if(TARGET hwy::hwy)
  return()
endif()
add_library(hwy::hwy INTERFACE IMPORTED)
target_include_directories(hwy::hwy SYSTEM INTERFACE ${BRINDLE_HEADER_LINKS})
