# cmake -DSUITE=bench_surface -DWRITE_REPORT=write_report -P report_has_surface.cmake: the way from the suite to the
# report, for crambin, without looking at times. Its surface has 1.47 concave patches an atom, of which others cut 7.9 %.
include(${CMAKE_CURRENT_LIST_DIR}/report_of_suites.cmake)
run_suite(${SUITE} --benchmark_filter=/crambin$ --benchmark_min_time=0.001 --benchmark_repetitions=2)
write_report()

# Boundary, surface, measure, gradient, beyond, gradient's share, bytes, concave patches, cut ones.
expect_row("[|] crambin [|] 327 [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|] -?${number} % [|] ${time} [|] 1[.]47 [|] 7[.]9 % [|]\n")
# Triangles, time, rate, bytes.
expect_row("[|] crambin [|] 327 [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|]\n")
