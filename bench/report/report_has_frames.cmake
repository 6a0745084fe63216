# cmake -DSUITE=bench_paper_section_5_1 -DWRITE_REPORT=write_report -P report_has_frames.cmake: the way from the suite to
# the report for crambin, without looking at times; and verdicts from made-up results, in which the z-buffer of triangles
# takes twice the analytic one's time. Times in seconds there, three repetitions, of which the median counts.
include(${CMAKE_CURRENT_LIST_DIR}/report_of_suites.cmake)
run_suite(${SUITE} --benchmark_filter=/crambin/ --benchmark_repetitions=2)
write_report()
# A count of at least 100.
set(many "[0-9,]*[1-9][0-9,]*[0-9][0-9]")
expect_row("[|] crambin [|] 327 [|] 1[.]72 [|] 3[.]40 [|] 1[.]40 [|] 0[.]85 [|] 1[.]10 [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|]\n")
expect_row("[|] crambin [|] 0[.]412 [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|] ${many} [|] ${many} [|] ${many} [|] ${many} [|] ${many} [|]\n")
expect_row("[|] crambin [|] 327 [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|] ${many} [|] ${many} [|] ${many} [|]\n")
expect_row("[|] frame / z-buffer of triangles, the five molecules [|] 1[.]00 [|] ${time} [|] ${time} [|] ${time} [|] [^|]+ [|]\n")

file(REMOVE ${folder}/bench_paper_section_5_1.json)
set(entries "")
function(add_result name atoms h g g_alone)
  foreach(wrong 0 0 9)
    string(APPEND entries ",{\"run_type\": \"iteration\", \"run_name\": \"${name}\", \"cpu_time\": 1, \"time_unit\": \"us\", "
      "\"atoms\": ${atoms}, \"analytic_seconds\": ${atoms}, \"h_seconds\": ${atoms}, \"g_seconds\": 1, "
      "\"g_alone_seconds\": 1, \"triangle_ratio\": 2, \"h_ratio\": ${wrong}${h}, \"g_ratio\": ${wrong}${g}, "
      "\"g_alone_ratio\": ${wrong}${g_alone}}")
  endforeach()
  set(entries "${entries}" PARENT_SCOPE)
endfunction()
add_result(section_5_1/caffeine 24 0.5 0.25 1)
add_result(section_5_1/sod_stand_in 4392 1.5 2 2)
add_result(frames/caffeine 24 0.5 0.75 2.5)
add_result(frames/sod_stand_in 4392 0.25 3.25 0.5)
add_result(frames/sod_stand_in_x8 35136 0.25 0.5 0.5)
string(SUBSTRING "${entries}" 1 -1 entries)
string(REGEX REPLACE ": 0+([0-9])" ": \\1" entries "${entries}")
file(WRITE ${folder}/made_up.json "{\"context\": {}, \"benchmarks\": [${entries}]}")
write_report()
expect_row("[|] frame / z-buffer of triangles, the five molecules [|] 1[.]00 [|] 0[.]750 [|] 1[.]000 [|] 1[.]000 [|] goal [|]\n")
expect_row("[|] frame / analytic z-buffer, the five molecules [|] 3[.]00 [|] 1[.]500 [|] 2[.]000 [|] 2[.]000 [|] goal [|]\n")
expect_row("[|] frame / analytic z-buffer, every size [|] 3[.]00 [|] 0[.]500 [|] 3[.]250 [|] 2[.]500 [|] [*][*]missed[*][*] [|]\n")
expect_row("[|] fitted exponent of n [|] all [|] 1[.]000 [|] 1[.]000 [|] 0[.]000 [|] 0[.]000 [|]")
