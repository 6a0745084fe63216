# cmake -DWRITE_REPORT=write_report -P report_judges_goals.cmake: exponents, ratios and verdicts from made-up results.
# Step 3: van der Waals n^1 and ratios up to 0.5, solvent-accessible n^1.1 and a ratio of 0.7 at 1000 balls alone, which
# are too few to count. Gradients: a ratio of 0.4 at 10,000 balls. Three repetitions each, of which the median counts.
set(folder ${CMAKE_CURRENT_BINARY_DIR}/report_judges_goals)
file(REMOVE_RECURSE ${folder})
file(MAKE_DIRECTORY ${folder})
set(entries "")
function(add_results name)
  foreach(wrong 1 1 100)
    string(APPEND entries ",{\"run_type\": \"iteration\", \"run_name\": \"${name}\", \"cpu_time\": ${wrong},"
      " \"time_unit\": \"us\"")
    foreach(counter ${ARGN})
      string(REPLACE "=" "\": " counter "${counter}")
      if(wrong EQUAL 100 AND NOT counter MATCHES "atoms")
        string(APPEND counter "9")
      endif()
      string(APPEND entries ", \"${counter}")
    endforeach()
    string(APPEND entries "}")
  endforeach()
  set(entries "${entries}" PARENT_SCOPE)
endfunction()
set(v van_der_waals/compute)
set(s solvent_accessible/compute)
add_results(topology/${v}/a atoms=1000 topology_seconds=0.001 bytes=1000 topology_ratio=0.11)
add_results(topology/${v}/b atoms=10000 topology_seconds=0.01 bytes=10000 topology_ratio=0.51)
add_results(topology/${v}/c atoms=100000 topology_seconds=0.1 bytes=100000 topology_ratio=0.31)
add_results(topology/${v}/d atoms=1000000 topology_seconds=1.0 bytes=1000000 topology_ratio=0.21)
add_results(topology/${s}/a atoms=1000 topology_seconds=0.001 bytes=1000.0 topology_ratio=0.71)
add_results(topology/${s}/b atoms=10000 topology_seconds=0.0125893 bytes=9000.0 topology_ratio=0.12)
add_results(topology/${s}/c atoms=100000 topology_seconds=0.158489 bytes=81000.0 topology_ratio=0.11)
add_results(topology/${s}/d atoms=1000000 topology_seconds=1.99526 bytes=729000.0 topology_ratio=0.11)
add_results(gradients/${v}/a atoms=1000 gradient_ratio=0.91)
add_results(gradients/${v}/b atoms=10000 gradient_ratio=0.41)
add_results(gradients/${s}/b atoms=10000 gradient_ratio=0.06)
string(SUBSTRING "${entries}" 1 -1 entries)
file(WRITE ${folder}/made_up.json "{\"context\": {\"load_avg\": [1.75, 1, 1]}, \"benchmarks\": [${entries}]}")

execute_process(COMMAND ${WRITE_REPORT} ${folder} OUTPUT_VARIABLE report ERROR_VARIABLE error RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "the report failed: ${status} ${error}")
endif()
string(REGEX REPLACE " +" " " report "${report}")
foreach(text
    "| Step 3 / Steps 1 + 2, largest ratio | from 4,000 | 0.60 | 0.510 | 0.120 | goal |"
    "| exponent of Step 3's time | all | 1.05 | 1.000 | 1.100 | **missed** |"
    "| exponent of Step 3's time | from 4,000 | 1.05 | 1.000 | 1.100 | **missed** |"
    "| exponent of Step 3's memory | all | 1.05 | 1.000 | 0.954 | goal |"
    "| gradient / Steps 1 + 2, largest ratio | from 4,000 | 0.35 | 0.410 | 0.060 | **missed** |"
    "| with area and volume, v | - | - | 3,000 | | 900 | 500 | 330 | not measured |"
    "load average: 1.75 to 1.75" "The machine was busy")
  string(FIND "${report}" "${text}" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "the report lacks ${text}\n${report}")
  endif()
endforeach()
