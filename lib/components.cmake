# The parts of the library: ground, balls and union, which are the core, and components, which a build may leave out, so
# that nothing of them is in the library, its headers, its Fortran modules and its package. core.cmake and the
# component.cmake of each component's folder say what belongs to each.

# hsp_part(name STANDS_ON part... HEADERS header... SOURCES file... APART file... SHIMS shim... SHIMS_APART shim...
#          LEVELS unit level...)
#   STANDS_ON     parts whose headers its sources find, and those on which these stand
#   HEADERS       its headers in include/hardsphere; all others are the core's
#   SOURCES       in the folder of its name: those of a room are one unit
#   APART         those that are units of their own: programs that need none of them link less, whatever their linker
#   SHIMS         its sources of the interface in capi/shims/<name>, the core's in capi/shims/core: they are one unit
#   SHIMS_APART   those that are units of their own, too
#   LEVELS        rooms, units and shims that take less optimization than -O3: no frame waits for them, they compile
#                 sooner and are smaller. Kernels of such rooms take -O3, as a unit of their own
# All of it is kept in the cache, so that projects that carry this one as a subdirectory can make units, too.
function(hsp_part name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "STANDS_ON;HEADERS;SOURCES;APART;SHIMS;SHIMS_APART;LEVELS")
  set(ARG_PARTS "") # and those on which it stands, below it
  foreach(lower ${ARG_STANDS_ON})
    list(APPEND ARG_PARTS ${HSP_${lower}_PARTS})
  endforeach()
  list(APPEND ARG_PARTS ${name})
  list(REMOVE_DUPLICATES ARG_PARTS)
  list(APPEND ARG_SOURCES ${ARG_APART})
  list(TRANSFORM ARG_SOURCES PREPEND ${PROJECT_SOURCE_DIR}/lib/${name}/)
  list(TRANSFORM ARG_APART PREPEND ${PROJECT_SOURCE_DIR}/lib/${name}/)
  string(REGEX REPLACE "^(balls|union)$" core folder ${name})
  foreach(list PARTS HEADERS SOURCES APART SHIMS SHIMS_APART LEVELS)
    if(list MATCHES SHIMS)
      list(TRANSFORM ARG_${list} REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/capi/shims/${folder}/\\1.cpp")
    endif()
    set(HSP_${name}_${list} ${ARG_${list}} CACHE INTERNAL "Of the part ${name}")
  endforeach()
endfunction()

include(${CMAKE_CURRENT_LIST_DIR}/core.cmake)
# Each behind those that it stands on.
set(HSP_ALL_COMPONENTS residues curvature motion bricks boxes wide smooth space sight)
foreach(component ${HSP_ALL_COMPONENTS})
  include(${CMAKE_CURRENT_LIST_DIR}/${component}/component.cmake)
endforeach()

set(HSP_COMPONENTS ${HSP_ALL_COMPONENTS} CACHE STRING "Components of the library; without any it is the stable tier")
set(parts ground balls union)
foreach(component ${HSP_COMPONENTS})
  if(NOT component IN_LIST HSP_ALL_COMPONENTS)
    message(FATAL_ERROR "HSP_COMPONENTS: there is no component ${component}; there are ${HSP_ALL_COMPONENTS}")
  endif()
  list(APPEND parts ${HSP_${component}_PARTS})
endforeach()
list(REMOVE_DUPLICATES parts)
set(HSP_PARTS ${parts} CACHE INTERNAL "The parts that are built")
list(TRANSFORM parts PREPEND ${PROJECT_SOURCE_DIR}/lib/)
set(HSP_PART_FOLDERS ${parts} CACHE INTERNAL "Their folders in lib")
set(HSP_LEFT_OUT ${HSP_ALL_COMPONENTS})
list(REMOVE_ITEM HSP_LEFT_OUT ${HSP_PARTS})

# A program asks HSP_HAS_<COMPONENT> (hardsphere/components.h). Files of tests, fuzzing, benchmarks and examples belong to
# a component if a folder above them has its name or that of one of its rooms; those in a folder `whole` need all.
set(HSP_FOLDERS_LEFT_OUT "")
# The tests that take the whole are those of the program and of packages, too.
set(HSP_FOLDERS_BEYOND_CORE whole pictures interface packaging program python bindings clients portability mutation)
foreach(component ${HSP_ALL_COMPONENTS})
  file(GLOB rooms RELATIVE ${PROJECT_SOURCE_DIR}/lib/${component} ${PROJECT_SOURCE_DIR}/lib/${component}/*)
  list(APPEND HSP_FOLDERS_BEYOND_CORE ${component} ${rooms})
  if(component IN_LIST HSP_LEFT_OUT)
    list(APPEND HSP_FOLDERS_LEFT_OUT whole ${component} ${rooms})
  endif()
endforeach()
list(TRANSFORM HSP_LEFT_OUT REPLACE "(.+)" "HSP_HAS_\\1=0" OUTPUT_VARIABLE definitions)
string(TOUPPER "${definitions}" definitions)
set(HSP_COMPONENT_DEFINITIONS ${definitions} CACHE INTERNAL "Of the components that are left out")

# The sources of the Fortran modules and the table of functions that the laws go over: as they stand here, or of what is
# there, which takes Python and its pycparser.
set(HSP_FORTRAN_FOLDER ${PROJECT_SOURCE_DIR}/capi/fortran)
if(HSP_LEFT_OUT)
  set(HSP_FORTRAN_FOLDER ${PROJECT_BINARY_DIR}/fortran)
  execute_process(RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said
    COMMAND python3 ${PROJECT_SOURCE_DIR}/capi/interface/generate.py --of-parts ${HSP_FORTRAN_FOLDER} ${HSP_PARTS})
  if(HSP_FORTRAN AND NOT status EQUAL 0)
    message(STATUS "no Fortran modules of these components: ${said}")
    set(HSP_FORTRAN OFF)
  endif()
endif()

# hsp_lies_in(result file folder...): whether a folder above a file of the current one has one of these names.
function(hsp_lies_in result file)
  file(RELATIVE_PATH path ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR}/${file})
  list(JOIN ARGN "|" names)
  string(REGEX MATCH "(^|/)(${names}|/)/" found ${path})
  set(${result} ${found} PARENT_SCOPE)
endfunction()

# hsp_remove_left_out(list): from a list of files of the current folder those of components that are left out.
macro(hsp_remove_left_out list)
  list(JOIN HSP_FOLDERS_LEFT_OUT "|" names)
  list(FILTER ${list} EXCLUDE REGEX "(^|/)(${names}|/)/")
endmacro()
