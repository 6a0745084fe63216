# cmake -DGENERATOR=program -DEXPECTED=file -P reproduce.cmake: the program must print exactly the file and exit with 0.
execute_process(COMMAND ${GENERATOR} OUTPUT_FILE ${CMAKE_CURRENT_BINARY_DIR}/sod_stand_in.pdb
  ERROR_VARIABLE figures RESULT_VARIABLE status)
message(STATUS "${figures}")
if(NOT status EQUAL 0)
  message(FATAL_ERROR "the generator failed: ${status}")
endif()
file(SHA256 ${CMAKE_CURRENT_BINARY_DIR}/sod_stand_in.pdb made)
file(SHA256 ${EXPECTED} expected)
if(NOT made STREQUAL expected)
  message(FATAL_ERROR "the generator no longer makes ${EXPECTED}: see ${CMAKE_CURRENT_BINARY_DIR}/sod_stand_in.pdb")
endif()
