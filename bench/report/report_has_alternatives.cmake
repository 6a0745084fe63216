# cmake -DSUITE=bench_section_3_alternatives -DWRITE_REPORT=write_report -P report_has_alternatives.cmake: the way from
# this suite to the report, for acetyl, without looking at times. Its 85 balls lie in 21 of 63 cubes.
set(folder ${CMAKE_CURRENT_BINARY_DIR}/report_has_alternatives)
file(REMOVE_RECURSE ${folder})
file(MAKE_DIRECTORY ${folder})
execute_process(COMMAND ${SUITE} --benchmark_filter=/acetyl$ --benchmark_min_time=0.001 --benchmark_out_format=json
    --benchmark_out=${folder}/suite.json
  OUTPUT_QUIET ERROR_QUIET RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "the suite failed: ${status}")
endif()
execute_process(COMMAND ${WRITE_REPORT} ${folder} OUTPUT_VARIABLE report ERROR_VARIABLE error RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "the report failed: ${status} ${error}")
endif()
string(REGEX REPLACE " +" " " report "${report}")

# A positive number with three significant digits.
set(time "[0-9,.]*[1-9][0-9,.]*")
set(seven "")
foreach(structure RANGE 1 7)
  string(APPEND seven " ${time} [|]")
endforeach()
foreach(text
    "Building, ns per ball:.*[|] acetyl [|] 85 [|]${seven}\n"
    "Ball queries near atoms, ns:.*[|] acetyl [|] 85 [|]${seven}\n"
    "that meet, ns per ball:.*[|] acetyl [|] 85 [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|] - [|] - [|]\n"
    # 36 bytes of a ball and 4 of each of 22 or 64 groups, and 8 bytes for the key of each of 21 cubes.
    "Memory, bytes per ball:.*[|] acetyl [|] 85 [|] ${time} [|] ${time} [|] ${time} [|] 39[.]0 [|] 39[.]0 [|]"
    "empty are - of the ball queries in the box of caffeine, 66 % of acetyl,")
  string(REPLACE "\n " " " one_line "${report}")
  if(NOT report MATCHES "${text}" AND NOT one_line MATCHES "${text}")
    message(FATAL_ERROR "the report lacks ${text}\n${report}")
  endif()
endforeach()
