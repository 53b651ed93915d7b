# The library's shaders for renderers of others, put together from the files that it draws with itself:
# DIALECT/pattern_vertex.glsl and DIALECT/pattern_fragment.glsl in the folder BRINDLE_DRAWING_SHADERS.
set(BRINDLE_DRAWING_SHADERS ${PROJECT_BINARY_DIR}/shaders)
set(shader_folder ${PROJECT_SOURCE_DIR}/src/brindle/render/shaders)

function(brindle_joined_shaders output)
  # Only GLSL 4 knows `precise`.
  set(joined "")
  if(NOT output MATCHES "/450/")
    set(joined "#define precise\n\n")
  endif()
  foreach(name ${ARGN})
    set(file ${shader_folder}/${name}.glsl)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} text)
    string(APPEND joined "${text}\n")
  endforeach()
  # Parts of a picture are the renderer's affair.
  string(REGEX REPLACE "uniform vec4 tile;[^\n]*" "const vec4 tile = vec4(1.0, 1.0, 0.0, 0.0);" joined
                       "${joined}")
  file(CONFIGURE OUTPUT ${output} CONTENT "@joined@" @ONLY)
endfunction()

foreach(dialect 330 300es 450)
  set(access pattern_buffers_${dialect} pattern_access)
  brindle_joined_shaders(${BRINDLE_DRAWING_SHADERS}/${dialect}/pattern_vertex.glsl ${access})
  brindle_joined_shaders(${BRINDLE_DRAWING_SHADERS}/${dialect}/pattern_fragment.glsl ${access}
                         surface_point fragment_phase stripe_coverage stripe_pattern light)
endforeach()
install(DIRECTORY ${BRINDLE_DRAWING_SHADERS}/ DESTINATION ${CMAKE_INSTALL_DATADIR}/brindle/shaders)
