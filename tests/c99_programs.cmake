# Programs of tests in C99.
include(${CMAKE_CURRENT_LIST_DIR}/names.cmake)

# The settings of programs that hold C99 tests.
function(hsp_c99_program name)
  set_target_properties(${name} PROPERTIES C_STANDARD 99 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF)
  # The header is held to more than the rest: pedantic and warning-free in every build.
  target_compile_options(${name} PRIVATE -pedantic -Wstrict-prototypes -Werror)
  target_link_libraries(${name} PRIVATE hsp_interface_checks hardsphere_warnings hardsphere_sanitizers ${ARGN})
endfunction()

# A test that is a program of its own.
function(hsp_c99_test file)
  hsp_name_test(name ${file})
  add_executable(${name} ${file})
  hsp_c99_program(${name} ${ARGN})
  add_test(NAME ${name} COMMAND ${name})
endfunction()

# The main functions of all files, FILE_test.c, in one program, which runs the one that is named. Each is a test of ctest.
function(hsp_c99_tests program)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "LIBRARIES")
  set(sources "")
  set(functions "")
  set(rows "")
  foreach(file ${ARG_UNPARSED_ARGUMENTS})
    hsp_name_test(name ${file}_test.c)
    list(APPEND sources ${file}_test.c)
    set_source_files_properties(${file}_test.c PROPERTIES COMPILE_DEFINITIONS main=${name})
    string(APPEND functions "int ${name}(void);\n")
    string(APPEND rows "    {\"${name}\", ${name}},\n")
    add_test(NAME ${name} COMMAND ${program} ${name})
    set_tests_properties(${name} PROPERTIES SKIP_RETURN_CODE 77)
  endforeach()
  configure_file(${CMAKE_CURRENT_FUNCTION_LIST_DIR}/c99_main.c.in ${CMAKE_CURRENT_BINARY_DIR}/${program}.c @ONLY)
  add_executable(${program} ${sources} ${CMAKE_CURRENT_BINARY_DIR}/${program}.c)
  hsp_c99_program(${program} ${ARG_LIBRARIES})
endfunction()
