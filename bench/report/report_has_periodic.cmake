# cmake -DSUITE=bench_periodic -DWRITE_REPORT=write_report -P report_has_periodic.cmake: the way from the suite to the
# report, for crambin, without looking at times. It touches its images, so that there are more contacts than without.
include(${CMAKE_CURRENT_LIST_DIR}/report_of_suites.cmake)
run_suite(${SUITE} --benchmark_filter=/crambin$ --benchmark_min_time=0.001)
write_report()

set(ratio "[0-9]+[.][0-9][0-9]")
string(REGEX MATCHALL "[|] crambin [|] 327 [|] [0-9][.][0-9][0-9] [|] ${time} [|] ${time} [|] ${ratio} [|] 1[.][0-9][0-9] [|] ${ratio} [|]\n"
  rows "${report}")
list(LENGTH rows count)
if(NOT count EQUAL 2)
  message(FATAL_ERROR "the report has ${count} rows of periodic boxes, not 2\n${report}")
endif()
