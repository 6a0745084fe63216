# cmake -DPROGRAM=program -DEXPECTED=file -DDRAWN=file -P redraw.cmake: the program must print exactly the file expected.
execute_process(COMMAND ${PROGRAM} OUTPUT_FILE ${DRAWN} RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "the program failed: ${status}")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${DRAWN} ${EXPECTED} RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${DRAWN} is not what ${EXPECTED} holds")
endif()
