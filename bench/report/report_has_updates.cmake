# cmake -DSUITE=bench_updates -DWRITE_REPORT=write_report -P report_has_updates.cmake: the way from this suite to the
# report, for crambin, without looking at times.
include(${CMAKE_CURRENT_LIST_DIR}/report_of_suites.cmake)
run_suite(${SUITE} --benchmark_filter=/crambin$ --benchmark_min_time=0.001)
write_report()

# Balls that change, us a move, us of all anew, and their ratio.
foreach(move "one atom" "10 atoms that lie together" "100 atoms that lie together" "one atom, taken back")
  expect_row("[|] crambin [|] 327 [|] van der Waals [|] ${move} [|] ${number} [|] ${time} [|] ${time} [|] ${number} [|]\n")
  expect_row("[|] crambin [|] 327 [|] solvent-accessible [|] ${move} [|] ${number} [|] ${time} [|] ${time} [|] ${number} [|]\n")
endforeach()
