# cmake -DSUITE=bench_split_work -DWRITE_REPORT=write_report -P report_has_split_work.cmake: the way from the suite to the
# report, for crambin, without looking at times.
set(folder ${CMAKE_CURRENT_BINARY_DIR}/report_has_split_work)
file(REMOVE_RECURSE ${folder})
file(MAKE_DIRECTORY ${folder})
execute_process(COMMAND ${SUITE} --benchmark_filter=/crambin$ --benchmark_min_time=0.001 --benchmark_repetitions=2
    --benchmark_out_format=json --benchmark_out=${folder}/split_work.json
  OUTPUT_QUIET ERROR_QUIET RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "the suite failed: ${status}")
endif()
execute_process(COMMAND ${WRITE_REPORT} ${folder} OUTPUT_VARIABLE report ERROR_VARIABLE error RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "the report failed: ${status} ${error}")
endif()
string(REGEX REPLACE " +" " " report "${report}")

# Times of one thread, and how many times as fast as alone.
set(time "[0-9,.]*[1-9][0-9,.]*")
set(ratio "[0-9]+[.][0-9][0-9]")
string(REGEX MATCHALL "[|] crambin [|] 327 [|] ${time} [|] ${time} [|] ${time} [|] ${ratio} [|] ${ratio} [|]\n" rows "${report}")
list(LENGTH rows count)
if(NOT count EQUAL 2)
  message(FATAL_ERROR "the report has ${count} rows of split work, not 2\n${report}")
endif()
