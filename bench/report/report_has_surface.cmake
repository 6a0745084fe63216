# cmake -DSUITE=bench_surface -DWRITE_REPORT=write_report -P report_has_surface.cmake: the way from the suite to the
# report, for crambin, without looking at times. Its surface has 1.47 concave patches an atom, of which others cut 7.9 %.
# The library's errors are of the order of roundings, those of other programs are what they print.
include(${CMAKE_CURRENT_LIST_DIR}/report_of_suites.cmake)
run_suite(${SUITE} --benchmark_filter=/crambin$|/1CRN$ --benchmark_min_time=0.001 --benchmark_repetitions=2)
write_report()

# Boundary, surface, measure, gradient, beyond, gradient's share, bytes, concave patches, cut ones.
expect_row("[|] crambin [|] 327 [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|] -?${number} % [|] ${time} [|] 1[.]47 [|] 7[.]9 % [|]\n")
# Triangles, time, rate, bytes.
expect_row("[|] crambin [|] 327 [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|]\n")
# Errors of 1CRN's area and volume; 4HHB's file need not be there.
expect_row("[|] hardsphere [|] (0|[0-9.]+e-1[2-6]) [|] (0|[0-9.]+e-1[2-6]) [|] - [|] - [|]\n")
expect_row("[|] MSROLL 3.9.3 [|] 5.03e-8 [|] 5.81e-8 [|] 1.28e-3 [|] 6.94e-5 [|]\n")
expect_row("[|] BALL 1.5 [|] 1.94e-5 [|] 1.13e-4 [|] 3.45e-4 [|] 2.38e-3 [|]\n")
