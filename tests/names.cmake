# One rule from file to target to test: tests/a/b/x_test.cpp is the target a_b_x and the test a_b_x of ctest.
set(HSP_TESTS_FOLDER ${CMAKE_CURRENT_LIST_DIR})

# The name that belongs to a file of the current folder: its path in tests/ with _ for /, without `_test` and ending.
function(hsp_name_test result file)
  file(RELATIVE_PATH name ${HSP_TESTS_FOLDER} ${CMAKE_CURRENT_SOURCE_DIR}/${file})
  string(REGEX REPLACE "(_test)?\\.[a-z0-9]+$" "" name ${name})
  string(REPLACE "/" "_" name ${name})
  set(${result} ${name} PARENT_SCOPE)
endfunction()

# hsp_label_test(name file): what the core needs has the label `core`: all but what lies in a folder of a component.
function(hsp_label_test name file)
  hsp_lies_in(beyond ${file} ${HSP_FOLDERS_BEYOND_CORE})
  if(NOT beyond)
    set_property(TEST ${name} APPEND PROPERTY LABELS core)
  endif()
endfunction()

# Tests that take longer than a few seconds: those of the names that this build has. They start first, so that no core
# waits for another at the end.
function(hsp_slow_tests)
  foreach(name ${ARGN})
    if(TEST ${name})
      set_property(TEST ${name} APPEND PROPERTY LABELS slow)
      set_tests_properties(${name} PROPERTIES COST 1000)
    endif()
  endforeach()
endfunction()

# A script that is a test; further arguments are the script's. VARIANT: one of several tests by the same script.
function(hsp_script_test file)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "VARIANT" "")
  hsp_name_test(name ${file})
  if(ARG_VARIANT)
    string(APPEND name _${ARG_VARIANT})
  endif()
  add_test(NAME ${name} COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/${file} ${ARG_UNPARSED_ARGUMENTS})
  # Projects that the scripts configure use the generator that is known to be there.
  set_tests_properties(${name} PROPERTIES ENVIRONMENT "CMAKE_GENERATOR=${CMAKE_GENERATOR}")
endfunction()
