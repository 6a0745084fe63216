# Headers that many sources include, compiled once with the option HSP_PRECOMPILED_GTEST; without it nothing.

# hsp_precompile(name HEADERS header... OPTIONS option... LIBRARIES library...): for sources that are compiled with the
# same options.
function(hsp_precompile name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "HEADERS;OPTIONS;LIBRARIES")
  if(NOT HSP_PRECOMPILED_GTEST)
    return()
  endif()
  set(nothing ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  file(TOUCH ${nothing})
  add_library(${name} OBJECT EXCLUDE_FROM_ALL ${nothing})
  target_compile_features(${name} PRIVATE cxx_std_20)
  target_compile_options(${name} PRIVATE ${ARG_OPTIONS})
  target_link_libraries(${name} PRIVATE ${ARG_LIBRARIES} hardsphere_warnings)
  target_precompile_headers(${name} PRIVATE ${ARG_HEADERS})
endfunction()

# The sources of a target begin with what hsp_precompile(name ...) has compiled.
function(hsp_reuse_precompiled target name)
  if(HSP_PRECOMPILED_GTEST)
    target_precompile_headers(${target} REUSE_FROM ${name})
  endif()
endfunction()
