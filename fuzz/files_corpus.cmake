# cmake -DINPUTS=folder -DCORPUS=folder -P files_corpus.cmake
# Makes the corpus of fuzz_files.cpp: the molecules among the inputs of the program's tests, each behind the byte that
# chooses its format. Inputs of more than 16 KiB are left out: their length matters to the program, not to a fuzzer.
file(REMOVE_RECURSE ${CORPUS})
file(MAKE_DIRECTORY ${CORPUS})
set(digit 0)  # the digit is the format's number
file(READ ${CMAKE_CURRENT_LIST_DIR}/../capi/program/read/file_format.c table)
string(REGEX MATCHALL "FORMAT\\([a-z0-9]+\\)" formats ${table})
list(FILTER formats EXCLUDE REGEX "xtc|trr|dcd|nc")  # coordinates alone
foreach(entry ${formats})
  string(REGEX REPLACE "FORMAT\\(([a-z0-9]+)\\)" "\\1" format ${entry})
  file(WRITE ${CORPUS}.format ${digit})
  file(GLOB_RECURSE inputs RELATIVE ${INPUTS} ${INPUTS}/*.${format})
  foreach(input ${inputs})
    file(SIZE ${INPUTS}/${input} bytes)
    if(bytes LESS_EQUAL 16384)
      string(REPLACE "/" "-" name ${input})
      execute_process(COMMAND ${CMAKE_COMMAND} -E cat ${CORPUS}.format ${INPUTS}/${input}
        OUTPUT_FILE ${CORPUS}/${name} COMMAND_ERROR_IS_FATAL ANY)
    endif()
  endforeach()
  math(EXPR digit "${digit} + 1")
endforeach()
file(REMOVE ${CORPUS}.format)
