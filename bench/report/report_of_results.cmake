# Steps that the tests of the report share. Each test has a folder of its own for results, ${folder}, which is empty at
# first.
get_filename_component(name ${CMAKE_SCRIPT_MODE_FILE} NAME_WE)
set(folder ${CMAKE_CURRENT_BINARY_DIR}/${name})
file(REMOVE_RECURSE ${folder})
file(MAKE_DIRECTORY ${folder})

# Sets `report` to the report about the folder's results, with single spaces.
function(write_report)
  execute_process(COMMAND ${WRITE_REPORT} ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/text ${folder}
    OUTPUT_VARIABLE report ERROR_VARIABLE error RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "the report failed: ${status} ${error}")
  endif()
  string(REGEX REPLACE " +" " " report "${report}")
  set(report "${report}" PARENT_SCOPE)
endfunction()
