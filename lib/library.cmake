# The library: the sources of its parts (components.cmake), as objects for tests and as what is installed, an archive or
# with BUILD_SHARED_LIBS a shared library. No program that links either needs the C++ run-time library.

# Position-independent code as CMAKE_POSITION_INDEPENDENT_CODE says. Without it: so that shared libraries, Python modules
# for instance, can contain the archive, but not for machines without an operating system.
set(HSP_POSITION_INDEPENDENT ON)
if(DEFINED CMAKE_POSITION_INDEPENDENT_CODE AND NOT BUILD_SHARED_LIBS)
  set(HSP_POSITION_INDEPENDENT ${CMAKE_POSITION_INDEPENDENT_CODE})
elseif(CMAKE_SYSTEM_NAME STREQUAL "Generic")
  set(HSP_POSITION_INDEPENDENT OFF)
endif()
set(HSP_POSITION_INDEPENDENT ${HSP_POSITION_INDEPENDENT} CACHE INTERNAL "Whether the library is position-independent")

# A project that carries this one may have no build type, or one like Debug that optimizes nothing. Its library is optimized
# all the same, unless its flags say how.
set(HSP_OPTIMIZATION "")
string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
if(NOT PROJECT_IS_TOP_LEVEL AND NOT CMAKE_CXX_FLAGS MATCHES "(^| )-O")
  foreach(type ${CMAKE_CONFIGURATION_TYPES})
    string(TOUPPER ${type} upper)
    if(NOT "${CMAKE_CXX_FLAGS_${upper}}" MATCHES "(^| )-O")
      list(APPEND HSP_OPTIMIZATION $<$<CONFIG:${type}>:-O3>)
    endif()
  endforeach()
  if(NOT CMAKE_CONFIGURATION_TYPES AND NOT "${CMAKE_CXX_FLAGS_${build_type}}" MATCHES "(^| )-O")
    set(HSP_OPTIMIZATION -O3)
  endif()
endif()
set(HSP_OPTIMIZATION ${HSP_OPTIMIZATION} CACHE INTERNAL "Optimization of the library where its project has none")
# Where all would take -O3, some rooms and shims take less.
set(HSP_OPTIMIZED OFF)
if("${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}} ${HSP_OPTIMIZATION}" MATCHES "(^| )-O3( |$)")
  set(HSP_OPTIMIZED ON)
endif()
set(HSP_OPTIMIZED ${HSP_OPTIMIZED} CACHE INTERNAL "Whether units may have a level of optimization of their own")

# Kernels for AVX2 beside those of the target's baseline, chosen at run time (lib/ground/lanes/target.hpp). Small targets do
# without.
option(HSP_WIDE_CODE "Searches in lanes of registers, and kernels for wider ones too, chosen at run time" ON)
set(HSP_AVX2_OPTIONS "-mavx2;-mfma;-mpopcnt" CACHE INTERNAL "Options of the kernels for AVX2")
if(HSP_WIDE_CODE AND NOT DEFINED CACHE{HSP_COMPILES_AVX2})
  string(JOIN " " CMAKE_REQUIRED_FLAGS ${HSP_AVX2_OPTIONS})
  set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
  check_cxx_source_compiles("
    #if !defined(__x86_64__) || !defined(__GNUC__)
    #error not this processor
    #endif
    #include <cpuid.h>
    #include <immintrin.h>
    __m256d sum(__m256d a, __m256d b) { return _mm256_fmadd_pd(a, b, b); }" HSP_COMPILES_AVX2)
  unset(CMAKE_REQUIRED_FLAGS)
  unset(CMAKE_TRY_COMPILE_TARGET_TYPE)
endif()

# Whether registers of the baseline hold several numbers, so that what is searched for in lanes is, for every target.
if(HSP_WIDE_CODE AND NOT DEFINED CACHE{HSP_BASELINE_HAS_LANES})
  set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
  check_cxx_source_compiles("
    #if !defined(__SSE2__) && !defined(__aarch64__) && !defined(__wasm_simd128__)
    #error one number for each register
    #endif
    int main() { return 0; }" HSP_BASELINE_HAS_LANES)
  unset(CMAKE_TRY_COMPILE_TARGET_TYPE)
endif()

set(HSP_SOURCES_OF_LANES
  lib/balls/model/pair_block.kernel.cpp
  lib/balls/model/query_hits.kernel.cpp
  lib/balls/model/rounded_block.kernel.cpp
  lib/union/contacts/contact_measures.kernel.cpp
  lib/union/sphere/candidate_block.kernel.cpp
  lib/union/sphere/cube_candidates.cpp
  lib/union/sphere/few_caps.kernel.cpp
  lib/union/sphere/float_caps.kernel.cpp
  lib/union/sphere/lane_search.cpp
  lib/union/sphere/near_balls.kernel.cpp
  lib/union/sphere/pair_sweep.kernel.cpp
  lib/union/sphere/pairs_of_few.cpp
  lib/union/sphere/root_discriminants.kernel.cpp)
list(TRANSFORM HSP_SOURCES_OF_LANES PREPEND ${PROJECT_SOURCE_DIR}/)
set(HSP_SOURCES_OF_LANES ${HSP_SOURCES_OF_LANES} CACHE INTERNAL "Sources with lanes of registers alone")

# The same bits with and without fused multiply-add, and in a project that is compiled with -Ofast, or with parts of it like
# -ffinite-math-only.
set(HSP_IEEE_OPTIONS -fno-unsafe-math-optimizations -fno-finite-math-only -ffp-contract=off
  CACHE INTERNAL "Arithmetic of IEEE 754 as it is written")

# hsp_add_to_unit(unit source target folders options): for hsp_library_objects, a source to one of its units, or by itself.
function(hsp_add_to_unit unit source target folders options)
  set(file ${source})
  if(HSP_UNITY_BUILD OR NOT target STREQUAL "baseline")
    set(file ${HSP_UNIT_FOLDER}/${unit}.cpp)
    set(text "${HSP_TEXT_${unit}}")
    if(NOT text AND NOT target STREQUAL "baseline")
      set(text "#undef HSP_TARGET\n#define HSP_TARGET ${target}\n")
    endif()
    set(HSP_TEXT_${unit} "${text}#include \"${source}\"\n" PARENT_SCOPE)
    set(HSP_UNITS ${HSP_UNITS} ${unit} PARENT_SCOPE)
  endif()
  set(HSP_FILES ${HSP_FILES} ${file} PARENT_SCOPE)
  set_source_files_properties(${file} PROPERTIES INCLUDE_DIRECTORIES "${folders}" COMPILE_OPTIONS "${options}")
endfunction()

# hsp_level_of(level part name...): the optimization of the first of the names that has one of its own, of a unit or room
# of a part, or of its `shims`; empty if that of all holds.
function(hsp_level_of level part)
  set(${level} "" PARENT_SCOPE)
  foreach(name ${ARGN})
    list(FIND HSP_${part}_LEVELS ${name} at)
    if(HSP_OPTIMIZED AND at GREATER_EQUAL 0)
      math(EXPR at "${at} + 1")
      list(GET HSP_${part}_LEVELS ${at} found)
      set(${level} ${found} PARENT_SCOPE)
      return()
    endif()
  endforeach()
endfunction()

# hsp_library_objects(name definition...): the library compiled as objects, with further definitions. The archive is made
# of hardsphere_objects. Tests of inner parts link to a library of objects and compile what its headers define alike.
#
# A source finds the headers of its part and of those that the part stands on. So the compiler holds the order of parts, and
# a test that of the rooms within one (tests/packaging/include_direction.sh). Sources of lib/ do not find the interface's.
# Those of the interface find the core's as well.
#
# Kernels, *.kernel.cpp, are compiled once more for each further target, in its namespace (lib/ground/lanes/target.hpp).
# HSP_SOURCES_OF_LANES are there where registers of the baseline hold several numbers.
#
# With HSP_UNITY_BUILD a room is one unit, the interface to a part another, and the kernels for a further target three more,
# those of ground and balls, of union, of components: most of the time that a source takes alone goes into its headers.
# Those of the baseline are in the units of their rooms.
function(hsp_library_objects name)
  set(wide OFF)
  if(HSP_WIDE_CODE AND HSP_COMPILES_AVX2 AND NOT "HSP_AVX2=0" IN_LIST ARGN)
    set(wide ON)
  endif()
  # Without an operating system linkers collect sections, and units apart share less code.
  set(apart ON)
  if(CMAKE_SYSTEM_NAME STREQUAL "Generic")
    set(apart OFF)
  endif()
  set(lanes OFF)
  if(HSP_WIDE_CODE AND HSP_BASELINE_HAS_LANES AND NOT "HSP_LANES=0" IN_LIST ARGN)
    set(lanes ON)
  endif()
  set(HSP_FILES "")
  set(HSP_UNITS "")
  set(HSP_UNIT_FOLDER ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${name}.dir/Unity)
  foreach(part ${HSP_PARTS})
    list(TRANSFORM HSP_${part}_PARTS PREPEND ${hardsphere_SOURCE_DIR}/lib/ OUTPUT_VARIABLE own_roots)
    foreach(source ${HSP_${part}_SOURCES})
      set(roots ${own_roots})
      if(source IN_LIST HSP_SOURCES_OF_LANES AND NOT lanes)
        continue()
      endif()
      string(REGEX MATCH "([a-z]+)/([a-z_0-9]+)(\\.kernel)?\\.cpp$" file ${source})
      set(room ${CMAKE_MATCH_1})
      hsp_level_of(level ${part} ${room}_${CMAKE_MATCH_2} ${room})
      set(unit ${room})
      if(source IN_LIST HSP_${part}_APART AND apart)
        set(unit ${room}_${CMAKE_MATCH_2})
      elseif(level AND CMAKE_MATCH_3)
        set(unit ${room}_kernels)
        set(level "")
      endif()
      hsp_add_to_unit(${unit} ${source} baseline "${roots}" "${level}")
      if(wide AND CMAKE_MATCH_3)
        set(unit union_avx2)
        if(NOT HSP_UNITY_BUILD)
          set(unit ${room}_${CMAKE_MATCH_2}_avx2)
        elseif(part MATCHES "^(ground|balls)$")
          set(unit balls_avx2)
        elseif(NOT part STREQUAL "union")
          set(unit components_avx2)
          set(roots ${HSP_PART_FOLDERS})
        endif()
        hsp_add_to_unit(${unit} ${source} avx2 "${roots}" "${HSP_AVX2_OPTIONS}")
      endif()
    endforeach()
    set(roots ${own_roots})
    list(APPEND roots ${hardsphere_SOURCE_DIR}/lib/balls ${hardsphere_SOURCE_DIR}/lib/union ${hardsphere_SOURCE_DIR}/include)
    foreach(shims core ${HSP_${part}_PARTS})
      list(APPEND roots ${hardsphere_SOURCE_DIR}/capi/shims/${shims})
    endforeach()
    hsp_level_of(level ${part} shims)
    foreach(source ${HSP_${part}_SHIMS} ${HSP_${part}_SHIMS_APART})
      set(unit ${part}_shims)
      if(source IN_LIST HSP_${part}_SHIMS_APART AND apart)
        get_filename_component(unit ${source} NAME_WE)
      endif()
      hsp_add_to_unit(${unit} ${source} baseline "${roots}" "${level}")
    endforeach()
  endforeach()
  list(REMOVE_DUPLICATES HSP_FILES)
  list(REMOVE_DUPLICATES HSP_UNITS)
  foreach(unit ${HSP_UNITS})
    file(CONFIGURE OUTPUT ${HSP_UNIT_FOLDER}/${unit}.cpp CONTENT "${HSP_TEXT_${unit}}" @ONLY)
  endforeach()
  add_library(${name} OBJECT ${HSP_FILES})
  target_compile_features(${name} PUBLIC cxx_std_20)
  set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ${HSP_POSITION_INDEPENDENT}
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_include_directories(${name} INTERFACE ${hardsphere_SOURCE_DIR}/include ${HSP_PART_FOLDERS})
  target_compile_definitions(${name} PUBLIC ${HSP_COMPONENT_DEFINITIONS} HSP_NO_CONTRACTION=1
    $<$<BOOL:${HSP_PORTABLE_LIMBS}>:HSP_PORTABLE_LIMBS=1> $<$<BOOL:${wide}>:HSP_AVX2=1> $<$<BOOL:${lanes}>:HSP_LANES=1> ${ARGN} PRIVATE HSP_TARGET=baseline)
  # The vectorizer of g++ 12 does not obey -ffp-contract=off: it makes fused instructions of complex products (vfmaddsub,
  # fcmla), hence it is off. HSP_NO_CONTRACTION: both are given. Projects for microcontrollers may have constants of single
  # precision; the library has not.
  # A section for each function and table, so that the linker can leave out what a program does not call.
  # -fno-gnu-unique: constants of headers are weak symbols as functions are, which an archive of one object makes local.
  # The rest keeps the C++ run time out.
  target_compile_options(${name} PUBLIC ${HSP_IEEE_OPTIONS} PRIVATE
    $<$<CXX_COMPILER_ID:GNU>:-fno-single-precision-constant>
    $<$<CXX_COMPILER_ID:GNU>:-fno-tree-vectorize> $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>
    ${HSP_OPTIMIZATION} -ffunction-sections -fdata-sections -fno-math-errno -fno-exceptions -fno-rtti
    -fno-threadsafe-statics -fno-asynchronous-unwind-tables -fstack-usage)
  target_link_libraries(${name} PRIVATE hardsphere_warnings hardsphere_sanitizers)
endfunction()
# Checked, an index out of range traps, under the address sanitizer the arrays in a handle's memory lie between poisoned
# bytes, and what the predicates' stages answer is counted.
set(HSP_CHECKS "")
if(HSP_CHECKED_LIBRARY)
  set(HSP_CHECKS HSP_CHECK_INDEX=1 HSP_COUNT_STAGES=1)
endif()
hsp_library_objects(hardsphere_objects ${HSP_CHECKS})

# One relocatable object, in which everything but hsp_* is local: nothing else can clash in a user's link, but a linker
# that does not collect sections takes the whole. It takes GNU ld (lld lacks --force-group-allocation; Apple's linker and that
# for wasm know no such thing) and GNU objcopy. Objects for optimization at link time are left as they are.
set(HSP_COMPILER ${CMAKE_CXX_COMPILER})
if(CMAKE_CXX_COMPILER_TARGET)
  list(APPEND HSP_COMPILER --target=${CMAKE_CXX_COMPILER_TARGET})
endif()
set(HSP_LINK_OBJECT ${HSP_COMPILER} -r -nostdlib -fuse-ld=bfd -Wl,--force-group-allocation)
set(HSP_KEEP_SYMBOLS ${CMAKE_OBJCOPY} --wildcard --keep-global-symbol=hsp_*)
function(hsp_can_link_single_object result)
  set(${result} OFF PARENT_SCOPE)
  string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
  if(HSP_SANITIZE OR CMAKE_INTERPROCEDURAL_OPTIMIZATION OR NOT CMAKE_OBJCOPY
      OR "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}}" MATCHES "-flto")
    return()
  endif()
  set(folder ${PROJECT_BINARY_DIR}/CMakeFiles/single_object)
  file(WRITE ${folder}/probe.cpp "extern \"C\" int hsp_probe() { return 0; }\n")
  separate_arguments(flags UNIX_COMMAND "${CMAKE_CXX_FLAGS}")
  foreach(command "${HSP_COMPILER};${flags};-c;probe.cpp;-o;probe.o" "${HSP_LINK_OBJECT};-o;linked.o;probe.o"
      "${HSP_KEEP_SYMBOLS};linked.o")
    execute_process(COMMAND ${command} WORKING_DIRECTORY ${folder} RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
    if(NOT status EQUAL 0)
      return()
    endif()
  endforeach()
  set(${result} ON PARENT_SCOPE)
endfunction()
# hsp_link_object(object objects command...): makes the object of a library of objects, and has the command change it.
function(hsp_link_object object objects)
  add_custom_command(OUTPUT ${object}
    COMMAND ${HSP_LINK_OBJECT} -o ${object} $<TARGET_OBJECTS:${objects}>
    COMMAND ${ARGN}
    DEPENDS ${objects} $<TARGET_OBJECTS:${objects}>
    COMMAND_EXPAND_LISTS VERBATIM)
  set_source_files_properties(${object} PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)
endfunction()
option(HSP_SINGLE_OBJECT "Make the archive of one object with nothing but hsp_* in its symbol table" OFF)

if(BUILD_SHARED_LIBS)
  add_library(hardsphere SHARED $<TARGET_OBJECTS:hardsphere_objects>)
  target_compile_definitions(hardsphere_objects PRIVATE HSP_BUILD_SHARED=1)
  if(WIN32)
    target_compile_definitions(hardsphere INTERFACE HSP_USE_SHARED=1)
    target_link_options(hardsphere PRIVATE $<$<CXX_COMPILER_ID:GNU>:-static-libgcc>) # there is none beside it
  endif()
  set_target_properties(hardsphere PROPERTIES VERSION ${PROJECT_VERSION}
    SOVERSION ${HSP_ABI_NUMBER})
elseif(HSP_SINGLE_OBJECT)
  hsp_can_link_single_object(works)
  if(NOT works)
    message(FATAL_ERROR "HSP_SINGLE_OBJECT takes GNU ld and GNU objcopy, and neither -flto nor sanitizers")
  endif()
  set(object ${CMAKE_CURRENT_BINARY_DIR}/hardsphere.o)
  hsp_link_object(${object} hardsphere_objects ${HSP_KEEP_SYMBOLS} ${object})
  add_library(hardsphere STATIC ${object})
else()
  add_library(hardsphere STATIC $<TARGET_OBJECTS:hardsphere_objects>)
endif()
add_library(hardsphere::hardsphere ALIAS hardsphere)
# With C as the linker language a C or Fortran program links without the C++ run-time library.
if(HSP_SANITIZE)
  set_target_properties(hardsphere PROPERTIES LINKER_LANGUAGE CXX)
  target_link_options(hardsphere PUBLIC $<BUILD_INTERFACE:-fsanitize=${HSP_SANITIZE}>)
else()
  set_target_properties(hardsphere PROPERTIES LINKER_LANGUAGE C)
endif()
target_include_directories(hardsphere PUBLIC
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_compile_definitions(hardsphere PUBLIC "$<BUILD_INTERFACE:${HSP_COMPONENT_DEFINITIONS}>")
# Systems that have no libm of its own find sqrt in their C library.
if(UNIX AND NOT APPLE)
  target_link_libraries(hardsphere PUBLIC m)
endif()
# Each function and table has a section of its own: where the linker can, it leaves out what a program does not call, and of
# a shared library what none of its functions calls.
set(HSP_PC_LINKS "")
if(NOT HSP_SANITIZE)
  check_linker_flag(C -Wl,--gc-sections HSP_LINKER_COLLECTS_SECTIONS)
  if(HSP_LINKER_COLLECTS_SECTIONS AND BUILD_SHARED_LIBS)
    target_link_options(hardsphere PRIVATE -Wl,--gc-sections)
  elseif(HSP_LINKER_COLLECTS_SECTIONS)
    target_link_options(hardsphere INTERFACE -Wl,--gc-sections)
    set(HSP_PC_LINKS " -Wl,--gc-sections")
  endif()
endif()
