# Writes one unit for the compiler that holds several test files whose names clash, each in a namespace of its own:
#   cmake -DUNIT=unit.cpp "-DFILES=a_test.cpp;b_test.cpp" -P unit_of_files.cmake
# What they include comes before, so that none of it is in those namespaces: headers say #pragma once.
set(included "")
set(text "")
foreach(file ${FILES})
  file(STRINGS ${file} lines REGEX "^#include ")
  list(APPEND included ${lines})
  get_filename_component(name ${file} NAME_WE)
  string(APPEND text "namespace in_${name} {\n#include \"${file}\"\n}  // namespace in_${name}\n")
endforeach()
list(REMOVE_DUPLICATES included)
list(JOIN included "\n" included)
file(WRITE ${UNIT} "${included}\n${text}")
