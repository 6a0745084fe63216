# cmake -DSUITE=bench_paper_section_2 -DWRITE_REPORT=write_report -P report_has_section_2.cmake: the way from a suite to
# the report, without looking at times. The figures are the paper's (k 1.95, rho 0.76, max 16, aver. 5.5), then ours.
include(${CMAKE_CURRENT_LIST_DIR}/report_of_suites.cmake)
run_suite(${SUITE} --benchmark_min_time=0.001 --benchmark_repetitions=2 "--benchmark_filter=figures/|figure_4/[124]0/|free_space/.*/caffeine")
write_report()
expect_text("| caffeine | 24 | 2.17 | 2.171 | 0.71 | 0.711 | 10 | 10 | 4.5 | 4.500 |")
expect_text("| SOD (our stand-in) | 4,392 | 1.95 | 1.953 | 0.76 | 0.763 | 16 | 16 | 5.5 | 5.477 |")
# Cells of vertical decompositions: counts that other code found, too.
expect_row("[|] Figure 4 [|] 10 [|] 171 [|] 553 [|] [0-9]+ [|] [0-9]+ [|]")
expect_row("[|] Figure 4 [|] 20 [|] 501 [|] 1,070 [|] [0-9]+ [|] [0-9]+ [|]")
expect_row("[|] Figure 4 [|] 40 [|] 1,611 [|] 2,134 [|] [0-9]+ [|] [0-9,]+ [|]")
expect_row("[|] van_der_waals [|] caffeine [|] 24 [|] [0-9.]+ [|] [0-9.]+ [|] [0-9.]+ [|] [0-9.]+ [|] [0-9.]+ [|] [0-9-]+ [|]")

file(REMOVE ${folder}/bench_paper_section_2.json)
execute_process(COMMAND ${WRITE_REPORT} ${folder} OUTPUT_QUIET ERROR_QUIET RESULT_VARIABLE status)
if(status EQUAL 0)
  message(FATAL_ERROR "a report was written from a folder without results")
endif()
