# cmake -DTOPOLOGY=bench_topology -DGRADIENTS=bench_gradients -DWRITE_REPORT=write_report -P report_has_step_3.cmake: the
# way from these suites to the report, for crambin, without looking at times. It has 444 faces, van der Waals, and is one
# component without voids; solvent-accessible 244 faces with 720 arcs and one void, all of them simple.
set(folder ${CMAKE_CURRENT_BINARY_DIR}/report_has_step_3)
file(REMOVE_RECURSE ${folder})
file(MAKE_DIRECTORY ${folder})
foreach(suite ${TOPOLOGY} ${GRADIENTS})
  get_filename_component(name ${suite} NAME_WE)
  execute_process(COMMAND ${suite} --benchmark_filter=/crambin$ --benchmark_min_time=0.001 --benchmark_repetitions=2
      --benchmark_out_format=json --benchmark_out=${folder}/${name}.json
    OUTPUT_QUIET ERROR_QUIET RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${name} failed: ${status}")
  endif()
endforeach()
execute_process(COMMAND ${WRITE_REPORT} ${folder} OUTPUT_VARIABLE report ERROR_VARIABLE error RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "the report failed: ${status} ${error}")
endif()
string(REGEX REPLACE " +" " " report "${report}")

# A positive number with three significant digits, and one with a fixed number of decimals.
set(time "[0-9,.]*[1-9][0-9,.]*")
set(number "[0-9,]+[.]?[0-9]*")
foreach(row
    # Times, ratio, faces, simple faces, edges, cut edges, components, voids.
    "[|] crambin [|] 327 [|] ${time} [|] ${time} [|] ${time} [|] 1[.]36 [|] ${number} [|] ${number} [|] ${time} [|] 1 [|] 0 [|]\n"
    "[|] crambin [|] 327 [|] ${time} [|] ${time} [|] ${time} [|] 0[.]75 [|] 0[.]75 [|] 2[.]20 [|] 0[.]00 [|] 1 [|] 1 [|]\n"
    # Bytes, time and shares of queries in the box, time and share near the surface.
    "[|] crambin [|] 327 [|] ${time} [|] ${number} [|] ${time} [|] ${number} % [|] 0[.]00 % [|] ${time} [|] 0[.]00 % [|]\n"
    "[|] crambin [|] 327 [|] ${time} [|] ${number} [|] ${time} [|] ${number} % [|] ${number} % [|] ${time} [|] ${time} % [|]\n"
    # Boundary, measure, gradient, two ratios.
    "[|] crambin [|] 327 [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|]\n"
    # Frames.
    "[|] crambin [|] 327 [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|] ${time} [|]\n")
  if(NOT report MATCHES "${row}")
    message(FATAL_ERROR "the report lacks a row like ${row}\n${report}")
  endif()
endforeach()
