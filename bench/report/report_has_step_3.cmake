# cmake -DTOPOLOGY=bench_topology -DGRADIENTS=bench_gradients -DWRITE_REPORT=write_report -P report_has_step_3.cmake: the
# way from these suites to the report, for crambin, without looking at times. It has 444 faces, van der Waals, and is one
# component without voids; solvent-accessible 244 faces with 720 arcs and one void, all of them simple.
include(${CMAKE_CURRENT_LIST_DIR}/report_of_suites.cmake)
foreach(suite ${TOPOLOGY} ${GRADIENTS})
  run_suite(${suite} --benchmark_filter=/crambin$ --benchmark_min_time=0.001 --benchmark_repetitions=2)
endforeach()
write_report()

# Times, ratio, faces, simple faces, edges, cut edges, components, voids.
expect_row("[|] crambin [|] 327 [|] ${time} [|] ${time} [|] ${time} [|] 1[.]36 [|] ${number} [|] ${number} [|] ${time} [|] 1 [|] 0 [|]\n")
expect_row("[|] crambin [|] 327 [|] ${time} [|] ${time} [|] ${time} [|] 0[.]75 [|] 0[.]75 [|] 2[.]20 [|] 0[.]00 [|] 1 [|] 1 [|]\n")
# Bytes, time and shares of queries in the box, time and share near the surface.
expect_row("[|] crambin [|] 327 [|] ${time} [|] ${number} [|] ${time} [|] ${number} % [|] 0[.]00 % [|] ${time} [|] 0[.]00 % [|]\n")
expect_row("[|] crambin [|] 327 [|] ${time} [|] ${number} [|] ${time} [|] ${number} % [|] ${number} % [|] ${time} [|] ${time} % [|]\n")
# Boundary, measure, gradient, two ratios.
expect_row("[|] crambin [|] 327 [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|]\n")
# Frames.
expect_row("[|] crambin [|] 327 [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|]\n")
