# cmake -DSUITE=bench_section_3_alternatives -DWRITE_REPORT=write_report -P report_has_alternatives.cmake: the way from
# this suite to the report, for acetyl, without looking at times. Its 85 balls lie in 21 of 63 cubes.
include(${CMAKE_CURRENT_LIST_DIR}/report_of_suites.cmake)
run_suite(${SUITE} --benchmark_filter=/acetyl$ --benchmark_min_time=0.001)
write_report()

set(seven "")
foreach(structure RANGE 1 7)
  string(APPEND seven " ${time} [|]")
endforeach()
foreach(text
    "Building, ns per ball:.*[|] acetyl [|] 85 [|]${seven}\n"
    "Ball queries near atoms, ns:.*[|] acetyl [|] 85 [|]${seven}\n"
    "that meet, ns per ball:.*[|] acetyl [|] 85 [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|] - [|] - [|]\n"
    # 36 bytes of a ball and 4 of each of 22 or 64 groups, and 8 bytes for the key of each of 21 cubes.
    "Memory, bytes per ball:.*[|] acetyl [|] 85 [|] ${time} [|] ${time} [|] ${time} [|] 39[.]0 [|] 39[.]0 [|]"
    "empty are - of the ball queries in the box of caffeine, 66 % of acetyl,")
  string(REPLACE "\n " " " one_line "${report}")
  if(NOT report MATCHES "${text}" AND NOT one_line MATCHES "${text}")
    message(FATAL_ERROR "the report lacks ${text}\n${report}")
  endif()
endforeach()
