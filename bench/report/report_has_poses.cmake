# cmake -DSUITE=bench_poses -DWRITE_REPORT=write_report -P report_has_poses.cmake: the way from this suite to the report,
# for 100 atoms of crambin, without looking at times. Nothing meets in free poses. Of 400 that overlap
# one has slid along what it touched.
include(${CMAKE_CURRENT_LIST_DIR}/report_of_suites.cmake)
run_suite(${SUITE} --benchmark_filter=/crambin_100$ --benchmark_min_time=0.001)
write_report()

# Hit, gap, pairs; hits and pairs a pose.
expect_row("[|] crambin_100 [|] 100 [|] free, 0[.]2 apart [|] ${time} [|] ${time} [|] ${time} [|] 0 [|] 0 [|]\n")
expect_row("[|] crambin_100 [|] 100 [|] overlap, 0[.]5 deep [|] ${time} [|] ${time} [|] ${time} [|] 0[.]998 [|] ${number} [|]\n")
expect_row("[|] crambin_100 [|] 100 [|] 5 apart [|] ${time} [|] ${time} [|] ${time} [|] 0 [|] 0 [|]\n")
# Preparing: us, ns per ball.
expect_row("[|] crambin_100 [|] 100 [|] ${time} [|] ${time} [|]\n")
