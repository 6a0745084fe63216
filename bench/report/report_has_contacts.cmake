# cmake -DSUITE=bench_contacts -DWRITE_REPORT=write_report -P report_has_contacts.cmake: the way from the suite to the
# report, for crambin, without looking at times. It has 1004 contacts and 837 triangles, van der Waals, and
# solvent-accessible 1991 and 3092.
include(${CMAKE_CURRENT_LIST_DIR}/report_of_suites.cmake)
run_suite(${SUITE} --benchmark_filter=/crambin$ --benchmark_min_time=0.001 --benchmark_repetitions=2)
write_report()

# Boundary, contacts, curvature, its gradient, three ratios, contacts, triangles, bytes.
set(times "${time} [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|] ${time}")
expect_row("[|] crambin [|] 327 [|] ${times} [|] 3[.]07 [|] 2[.]56 [|] ${time} [|]\n")
expect_row("[|] crambin [|] 327 [|] ${times} [|] 6[.]09 [|] 9[.]46 [|] ${time} [|]\n")
