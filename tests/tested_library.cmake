# Tests and fuzz harnesses link the library compiled once more with HSP_CHECK_INDEX: an index out of range traps, and under
# the address sanitizer the arrays in a handle's memory lie between poisoned bytes. With HSP_COUNT_STAGES it counts what
# the predicates' stages answer, for one test. Programs in folders with the property
# HSP_SHIPPED_LIBRARY, benchmarks for instance, link the archive that is installed. Libraries that both kinds of programs
# use link hardsphere_tested, which is what suits the program. With HSP_CHECKED_LIBRARY the archive itself is checked.
# HSP_UNITY_CHECKED compiles the checked library alone in large units: where all is compiled once, as in CI.
include_guard(GLOBAL)

set(HSP_CHECKS HSP_CHECK_INDEX=1 HSP_COUNT_STAGES=1)
if(HSP_CHECKED_LIBRARY)
  target_compile_definitions(hardsphere_objects PUBLIC ${HSP_CHECKS})
  add_library(hardsphere_checked_objects ALIAS hardsphere_objects)
  add_library(hardsphere_checked ALIAS hardsphere)
else()
  hsp_library_objects(hardsphere_checked_objects ${HSP_CHECKS})
  if(HSP_UNITY_CHECKED)
    set_target_properties(hardsphere_checked_objects PROPERTIES UNITY_BUILD ON)
  endif()
  add_library(hardsphere_checked STATIC $<TARGET_OBJECTS:hardsphere_checked_objects>)
  set_target_properties(hardsphere_checked_objects hardsphere_checked PROPERTIES EXCLUDE_FROM_ALL ON)
  get_target_property(language hardsphere LINKER_LANGUAGE)
  set_target_properties(hardsphere_checked PROPERTIES LINKER_LANGUAGE ${language})
  target_include_directories(hardsphere_checked PUBLIC ${hardsphere_SOURCE_DIR}/include)
  target_link_libraries(hardsphere_checked PUBLIC m PRIVATE hardsphere_sanitizers)
endif()

define_property(TARGET PROPERTY HSP_SHIPPED_LIBRARY INHERITED BRIEF_DOCS "Whether a program links the installed archive"
  FULL_DOCS "Whether a program that links hardsphere_tested links hardsphere or hardsphere_checked")
add_library(hardsphere_tested INTERFACE)
target_link_libraries(hardsphere_tested INTERFACE
  $<IF:$<BOOL:$<TARGET_PROPERTY:HSP_SHIPPED_LIBRARY>>,hardsphere,hardsphere_checked>)
