# cmake -DSUITE=bench_surface -DWRITE_REPORT=write_report -P report_has_surface.cmake: the way from the suite to the
# report, for crambin, without looking at times. Its surface has 1.47 concave patches an atom, of
# which others cut 7.9 %.
set(folder ${CMAKE_CURRENT_BINARY_DIR}/report_has_surface)
file(REMOVE_RECURSE ${folder})
file(MAKE_DIRECTORY ${folder})
execute_process(COMMAND ${SUITE} --benchmark_filter=/crambin$ --benchmark_min_time=0.001 --benchmark_repetitions=2
    --benchmark_out_format=json --benchmark_out=${folder}/surface.json
  OUTPUT_QUIET ERROR_QUIET RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "the suite failed: ${status}")
endif()
execute_process(COMMAND ${WRITE_REPORT} ${folder} OUTPUT_VARIABLE report ERROR_VARIABLE error RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "the report failed: ${status} ${error}")
endif()
string(REGEX REPLACE " +" " " report "${report}")

# A positive number with three significant digits, and one with a fixed number of decimals.
set(time "[0-9,.]*[1-9][0-9,.]*")
set(number "[0-9,]+[.]?[0-9]*")
foreach(row
    # Boundary, surface, measure, gradient, beyond, gradient's share, bytes, concave patches, cut ones.
    "[|] crambin [|] 327 [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|] -?${number} % [|] ${time} [|] 1[.]47 [|] 7[.]9 % [|]\n"
    # Triangles, time, rate, bytes.
    "[|] crambin [|] 327 [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|]\n")
  if(NOT report MATCHES "${row}")
    message(FATAL_ERROR "the report lacks a row like ${row}\n${report}")
  endif()
endforeach()
