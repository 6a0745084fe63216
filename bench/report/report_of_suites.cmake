# What the tests of the report share. Results are in a folder of the script's own, ${folder}, which is empty at first.
get_filename_component(name ${CMAKE_SCRIPT_MODE_FILE} NAME_WE)
set(folder ${CMAKE_CURRENT_BINARY_DIR}/${name})
file(REMOVE_RECURSE ${folder})
file(MAKE_DIRECTORY ${folder})

# A positive number with three significant digits, and one with a fixed number of decimals.
set(time "[0-9,.]*[1-9][0-9,.]*")
set(number "[0-9,]+[.]?[0-9]*")

# run_suite(SUITE ARGUMENT...): its results into the folder.
function(run_suite suite)
  get_filename_component(suite_name ${suite} NAME_WE)
  execute_process(COMMAND ${suite} ${ARGN} --benchmark_out_format=json --benchmark_out=${folder}/${suite_name}.json
    OUTPUT_QUIET ERROR_QUIET RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${suite_name} failed: ${status}")
  endif()
endfunction()

# Sets `report` to the report about the folder's results, with single spaces.
function(write_report)
  execute_process(COMMAND ${WRITE_REPORT} ${folder} OUTPUT_VARIABLE report ERROR_VARIABLE error RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "the report failed: ${status} ${error}")
  endif()
  string(REGEX REPLACE " +" " " report "${report}")
  set(report "${report}" PARENT_SCOPE)
endfunction()

function(expect_row row)
  if(NOT report MATCHES "${row}")
    message(FATAL_ERROR "the report lacks a row like ${row}\n${report}")
  endif()
endfunction()

function(expect_text text)
  string(FIND "${report}" "${text}" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "the report lacks ${text}\n${report}")
  endif()
endfunction()
