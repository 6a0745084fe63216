# The programs that print bit patterns, for the native build and for every target alike.
set(HSP_PORTABILITY_HERE ${CMAKE_CURRENT_LIST_DIR})
get_target_property(HSP_LIBRARY_ROOT hardsphere_objects SOURCE_DIR)

add_executable(interface_bits ${HSP_PORTABILITY_HERE}/interface_bits.c ${HSP_PORTABILITY_HERE}/print_bits.c
  ${HSP_PORTABILITY_HERE}/print_gradients.c ${HSP_PORTABILITY_HERE}/print_topology.c
  ${HSP_PORTABILITY_HERE}/print_periodic.c ${HSP_PORTABILITY_HERE}/print_views.c
  ${HSP_PORTABILITY_HERE}/print_maps.c)
set_target_properties(interface_bits PROPERTIES C_STANDARD 99 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF)
target_link_libraries(interface_bits PRIVATE hsp_interface_checks hardsphere_warnings)
if(NOT COMMAND hsp_in_host_environments)
  add_subdirectory(${HSP_PORTABILITY_HERE}/../support/host host)
endif()
hsp_in_host_environments(interface_bits)
# The ball sets are computed, too, and have to be the same.
target_compile_options(hsp_interface_checks PRIVATE -ffp-contract=off)

add_executable(arc_tangent_bits ${HSP_PORTABILITY_HERE}/arc_tangent_bits.cpp $<TARGET_OBJECTS:hardsphere_objects>)
target_compile_features(arc_tangent_bits PRIVATE cxx_std_20)
target_compile_definitions(arc_tangent_bits PRIVATE HSP_NO_CONTRACTION=1) # the object that computes is the library's
target_include_directories(arc_tangent_bits PRIVATE ${HSP_LIBRARY_ROOT}/lib/ground)
target_link_libraries(arc_tangent_bits PRIVATE hardsphere_warnings)
