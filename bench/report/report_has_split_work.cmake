# cmake -DSUITE=bench_split_work -DWRITE_REPORT=write_report -P report_has_split_work.cmake: the way from the suite to the
# report, for crambin, without looking at times.
include(${CMAKE_CURRENT_LIST_DIR}/report_of_suites.cmake)
run_suite(${SUITE} --benchmark_filter=/crambin$ --benchmark_min_time=0.001 --benchmark_repetitions=2)
write_report()

# Times of one thread, and how many times as fast as alone.
set(ratio "[0-9]+[.][0-9][0-9]")
string(REGEX MATCHALL "[|] crambin [|] 327 [|] ${time} [|] ${time} [|] ${time} [|] ${ratio} [|] ${ratio} [|]\n" rows "${report}")
list(LENGTH rows count)
if(NOT count EQUAL 2)
  message(FATAL_ERROR "the report has ${count} rows of split work, not 2\n${report}")
endif()
