# The library: its sources, as objects for tests and as what is installed, an archive or with BUILD_SHARED_LIBS a shared
# library. No program that links either needs the C++ run-time library.

# In the order of the rooms.
set(HSP_LIBRARY_SOURCES
  lib/core/elementary.cpp
  lib/core/key_places.cpp
  lib/core/key_places_avx2.cpp
  lib/exact/exact_predicates.cpp
  lib/model/ball_set.cpp
  lib/model/block_sweep.cpp
  lib/model/cube_grid.cpp
  lib/model/digit_sort.cpp
  lib/model/grid_order.cpp
  lib/model/element_radii.cpp
  lib/model/neighbour_lists.cpp
  lib/model/packing_statistics.cpp
  lib/model/pair_block_avx2.cpp
  lib/model/queries.cpp
  lib/model/query_hits.cpp
  lib/model/query_hits_avx2.cpp
  lib/model/rounded_block_avx2.cpp
  lib/model/row_directory.cpp
  lib/model/ray_query.cpp
  lib/model/set_digest.cpp
  lib/model/vertical_ray.cpp
  lib/poses/near_pairs.cpp
  lib/poses/near_pairs_avx2.cpp
  lib/poses/pose.cpp
  lib/poses/pose_queries.cpp
  lib/poses/rational_pose.cpp
  lib/poses/sphere_tree.cpp
  lib/cells/arrangement.cpp
  lib/cells/cell_location.cpp
  lib/cells/cube_contacts.cpp
  lib/cells/cube_cover.cpp
  lib/cells/empty_runs.cpp
  lib/cells/facet_overlay.cpp
  lib/cells/free_space_builder.cpp
  lib/cells/free_space_check.cpp
  lib/cells/power_cell.cpp
  lib/cells/power_polytope.cpp
  lib/cells/power_predicates.cpp
  lib/cells/side_facets.cpp
  lib/cells/wide_cells_avx2.cpp
  lib/paths/cell_crossing.cpp
  lib/paths/cell_search.cpp
  lib/paths/free_segments.cpp
  lib/paths/path_finder.cpp
  lib/paths/widest_probe.cpp
  lib/sphere/arc_geometry.cpp
  lib/sphere/cap_clusters.cpp
  lib/sphere/candidate_block_avx2.cpp
  lib/sphere/caps.cpp
  lib/sphere/cube_candidates.cpp
  lib/sphere/few_caps_avx2.cpp
  lib/sphere/float_caps_avx2.cpp
  lib/sphere/great_circles.cpp
  lib/sphere/lane_search.cpp
  lib/sphere/near_balls_avx2.cpp
  lib/sphere/pair_sweep_avx2.cpp
  lib/sphere/root_discriminants_avx2.cpp
  lib/sphere/vertex_finder.cpp
  lib/boundary/boundary_builder.cpp
  lib/boundary/boundary_check.cpp
  lib/boundary/boundary_part.cpp
  lib/boundary/boundary_worker.cpp
  lib/boundary/components.cpp
  lib/boundary/faces.cpp
  lib/boundary/half_edge_links.cpp
  lib/boundary/point_location.cpp
  lib/boundary/shells.cpp
  lib/topology/cells.cpp
  lib/topology/cut_arcs.cpp
  lib/topology/simple_faces.cpp
  lib/topology/subdivision.cpp
  lib/topology/topology_builder.cpp
  lib/topology/topology_check.cpp
  lib/topology/traversal.cpp
  lib/measure/arc_batches.cpp
  lib/measure/arc_kernel.cpp
  lib/measure/arc_kernel_avx2.cpp
  lib/measure/areas.cpp
  lib/measure/boundary_metric_check.cpp
  lib/measure/boundary_positions.cpp
  lib/measure/curvature.cpp
  lib/measure/edge_kernel.cpp
  lib/measure/edge_kernel_avx2.cpp
  lib/measure/gradients.cpp
  lib/measure/positions.cpp
  lib/measure/shell_volumes.cpp
  lib/measure/tangency.cpp
  lib/updates/ball_cells.cpp
  lib/updates/component_update.cpp
  lib/updates/moving_balls.cpp
  lib/contacts/chord_clipper.cpp
  lib/contacts/chord_kernel.cpp
  lib/contacts/chord_kernel_avx2.cpp
  lib/contacts/chord_parts.cpp
  lib/contacts/chord_parts_avx2.cpp
  lib/contacts/chord_walk.cpp
  lib/contacts/contact_measures.cpp
  lib/contacts/contact_measures_avx2.cpp
  lib/contacts/contacts_builder.cpp
  lib/contacts/contacts_check.cpp
  lib/periodic/periodic_box.cpp
  lib/periodic/periodic_check.cpp
  lib/periodic/periodic_images.cpp
  lib/periodic/periodic_measures.cpp
  lib/periodic/periodic_morphometry.cpp
  lib/periodic/periodic_queries.cpp
  lib/periodic/periodic_records.cpp
  lib/periodic/periodic_union.cpp
  lib/periodic/windings.cpp
  lib/surface/concave_patches.cpp
  lib/surface/covered_gaps.cpp
  lib/surface/crease_lengths.cpp
  lib/surface/cusped_circles.cpp
  lib/surface/cut_patches.cpp
  lib/surface/degenerate_balls.cpp
  lib/surface/flat_patches.cpp
  lib/surface/near_probes.cpp
  lib/surface/near_probes_avx2.cpp
  lib/surface/patch_corners.cpp
  lib/surface/probe_caps.cpp
  lib/surface/probe_grid.cpp
  lib/surface/probe_positions.cpp
  lib/surface/region_pieces.cpp
  lib/surface/saddle.cpp
  lib/surface/saddle_kernel.cpp
  lib/surface/saddle_kernel_avx2.cpp
  lib/surface/settled_circles.cpp
  lib/surface/surface_areas.cpp
  lib/surface/surface_gradients.cpp
  lib/surface/surface_builder.cpp
  lib/surface/surface_check.cpp
  lib/surface/surface_map.cpp
  lib/surface/surface_patches.cpp
  lib/surface/surface_positions.cpp
  lib/surface/surface_shells.cpp
  lib/surface/triangle_kernel.cpp
  lib/surface/triangle_kernel_avx2.cpp
  lib/surface/weighted_joints.cpp
  lib/mesh/boundary_curves.cpp
  lib/mesh/boundary_outline.cpp
  lib/mesh/concave_outline.cpp
  lib/mesh/convex_outline.cpp
  lib/mesh/flat_strips.cpp
  lib/mesh/mesh_builder.cpp
  lib/mesh/pinched_cells.cpp
  lib/mesh/pinched_patch.cpp
  lib/mesh/sphere_triangulation.cpp
  lib/mesh/saddle_band.cpp
  lib/mesh/saddle_grids.cpp
  lib/mesh/spherical_patch.cpp
  lib/mesh/surface_curves.cpp
  lib/mesh/surface_outline.cpp
  lib/mesh/surface_vertices.cpp
  lib/view/depth_buffer.cpp
  lib/view/depth_order.cpp
  lib/view/depth_rows.cpp
  lib/view/depth_rows_avx2.cpp
  lib/view/occlusion.cpp
  lib/view/piece_arcs.cpp
  lib/view/painted_paths.cpp
  lib/view/projected_arcs.cpp
  lib/view/view_builder.cpp
  lib/view/view_frame.cpp
  lib/view/view_rotation.cpp
  lib/view/visible_piece.cpp
  lib/visibility/arc_finder.cpp
  lib/visibility/crease_arcs.cpp
  lib/visibility/disc_grid.cpp
  lib/visibility/edge_distance.cpp
  lib/visibility/edge_geometry.cpp
  lib/visibility/face_pole.cpp
  lib/visibility/landings.cpp
  lib/visibility/map_builder.cpp
  lib/visibility/map_check.cpp
  lib/visibility/map_faces.cpp
  lib/visibility/map_linker.cpp
  lib/visibility/map_paths.cpp
  lib/visibility/map_queries.cpp
  lib/visibility/map_silhouettes.cpp
  lib/visibility/seen_balls.cpp
  lib/visibility/silhouette_arcs.cpp
  lib/visibility/trigonometric_roots.cpp
  lib/sticks/body_sight.cpp
  lib/sticks/drawing_order.cpp
  lib/sticks/region_arcs.cpp
  lib/sticks/region_builder.cpp
  lib/sticks/region_faces.cpp
  lib/sticks/region_linker.cpp
  lib/sticks/region_loops.cpp
  lib/sticks/region_outlines.cpp
  lib/sticks/stick_outlines.cpp
  lib/sticks/stick_sweep.cpp
  lib/sticks/stick_view_builder.cpp
  lib/picture/byte_sink.cpp
  lib/picture/deflate.cpp
  lib/picture/eps_writer.cpp
  lib/picture/escaped_text.cpp
  lib/picture/ink.cpp
  lib/picture/number_text.cpp
  lib/picture/page.cpp
  lib/picture/paint.cpp
  lib/picture/palettes.cpp
  lib/picture/pdf_writer.cpp
  lib/picture/picture.cpp
  lib/picture/prefix_code.cpp
  lib/picture/svg_path.cpp
  lib/picture/svg_writer.cpp
  capi/hsp_status.cpp
  capi/hsp_element.cpp
  capi/hsp_model.cpp
  capi/hsp_query.cpp
  capi/hsp_body.cpp
  capi/hsp_boundary.cpp
  capi/hsp_measure.cpp
  capi/hsp_gradient.cpp
  capi/hsp_curvature.cpp
  capi/hsp_contacts.cpp
  capi/hsp_periodic.cpp
  capi/hsp_periodic_boundary.cpp
  capi/hsp_periodic_curvature.cpp
  capi/hsp_periodic_queries.cpp
  capi/hsp_moving.cpp
  capi/hsp_surface.cpp
  capi/hsp_surface_records.cpp
  capi/hsp_map.cpp
  capi/hsp_map_records.cpp
  capi/hsp_mesh.cpp
  capi/hsp_topology.cpp
  capi/hsp_topology_records.cpp
  capi/hsp_topology_cells.cpp
  capi/hsp_cells.cpp
  capi/hsp_paths.cpp
  capi/hsp_view.cpp
  capi/hsp_view_records.cpp
  capi/hsp_picture.cpp
  capi/hsp_sticks.cpp
  capi/hsp_sticks_map.cpp)
# Parts that a build may leave out: functions of theirs are then not in the library. What smooth, space and sight stand on
# is always there.
set(HSP_ALL_COMPONENTS smooth space sight)
set(HSP_COMPONENTS ${HSP_ALL_COMPONENTS} CACHE STRING "Parts of the library besides models, queries, unions and boxes")
set(HSP_smooth_SOURCES "lib/(surface|mesh)/|capi/hsp_(surface|mesh)")
set(HSP_space_SOURCES "lib/(cells|paths)/|capi/hsp_(cells|paths)")
set(HSP_sight_SOURCES "lib/(view|visibility|sticks|picture)/|capi/hsp_(view|map|sticks|picture)")
set(HSP_WHOLE ON)
foreach(component ${HSP_COMPONENTS})
  if(NOT component IN_LIST HSP_ALL_COMPONENTS)
    message(FATAL_ERROR "HSP_COMPONENTS: there is no component ${component}; there are ${HSP_ALL_COMPONENTS}")
  endif()
endforeach()
foreach(component ${HSP_ALL_COMPONENTS})
  if(NOT component IN_LIST HSP_COMPONENTS)
    set(HSP_WHOLE OFF)
    list(FILTER HSP_LIBRARY_SOURCES EXCLUDE REGEX "^(${HSP_${component}_SOURCES})")
  endif()
endforeach()
if(NOT HSP_WHOLE AND (HSP_TOOL OR HSP_TESTS OR HSP_BENCH OR HSP_FUZZ OR HSP_FORTRAN))
  message(FATAL_ERROR "Without all of HSP_COMPONENTS there are no program, Fortran module, tests, benchmarks and fuzzing: "
    "set HSP_TOOL, HSP_FORTRAN, HSP_TESTS, HSP_BENCH and HSP_FUZZ to OFF")
endif()
list(TRANSFORM HSP_LIBRARY_SOURCES PREPEND ${PROJECT_SOURCE_DIR}/)
# In the cache, so that projects that carry this one as a subdirectory can call the function below, too.
set(HSP_LIBRARY_SOURCES ${HSP_LIBRARY_SOURCES} CACHE INTERNAL "The sources of the library")
set(HSP_AVX2_SOURCES ${HSP_LIBRARY_SOURCES})
list(FILTER HSP_AVX2_SOURCES INCLUDE REGEX "_avx2\\.cpp$")
set(HSP_AVX2_SOURCES ${HSP_AVX2_SOURCES} CACHE INTERNAL "Those compiled for AVX2")

# Position-independent code as CMAKE_POSITION_INDEPENDENT_CODE says. Without it: so that shared libraries, Python modules
# for instance, can contain the archive, but not for machines without an operating system.
set(HSP_POSITION_INDEPENDENT ON)
if(DEFINED CMAKE_POSITION_INDEPENDENT_CODE AND NOT BUILD_SHARED_LIBS)
  set(HSP_POSITION_INDEPENDENT ${CMAKE_POSITION_INDEPENDENT_CODE})
elseif(CMAKE_SYSTEM_NAME STREQUAL "Generic")
  set(HSP_POSITION_INDEPENDENT OFF)
endif()
set(HSP_POSITION_INDEPENDENT ${HSP_POSITION_INDEPENDENT} CACHE INTERNAL "Whether the library is position-independent")

# A project that carries this one may have no build type. Its library is optimized all the same, unless its flags say how.
set(HSP_OPTIMIZATION "")
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES AND NOT CMAKE_CXX_FLAGS MATCHES "(^| )-O")
  set(HSP_OPTIMIZATION -O3)
endif()
set(HSP_OPTIMIZATION ${HSP_OPTIMIZATION} CACHE INTERNAL "Optimization of the library where there is no build type")

# Code for AVX2 beside that of the target's baseline, chosen at run time (lib/core/processor.hpp): in files *_avx2.cpp,
# which are empty without the definition HSP_AVX2. Small targets do without.
option(HSP_WIDE_CODE "Code for wider registers too, chosen at run time" ON)
set(HSP_AVX2_OPTIONS "-mavx2;-mfma;-mpopcnt" CACHE INTERNAL "Options of the files for AVX2")
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

if(NOT DEFINED CACHE{HSP_TARGETS_AARCH64})
  set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
  check_cxx_source_compiles("
    #if !defined(__aarch64__)
    #error not this processor
    #endif
    int main() { return 0; }" HSP_TARGETS_AARCH64)
  unset(CMAKE_TRY_COMPILE_TARGET_TYPE)
endif()

# hsp_library_objects(name definition...): the library compiled as objects, with further definitions. The archive is made
# of hardsphere_objects. Tests of inner parts link to a library of objects and compile what its headers define alike.
# With HSP_UNITY_BUILD a room is one unit, the interface another, the code for AVX2 a third: most of the time that a
# source takes alone goes into its headers.
function(hsp_library_objects name)
  set(sources ${HSP_LIBRARY_SOURCES})
  set(avx2_sources ${HSP_AVX2_SOURCES})
  if(HSP_UNITY_BUILD)
    # CMake leaves sources with options of their own out of its units.
    list(REMOVE_ITEM sources ${avx2_sources})
    list(TRANSFORM avx2_sources REPLACE "(.+)" "#include \"\\1\"\n" OUTPUT_VARIABLE lines)
    list(JOIN lines "" lines)
    set(avx2_sources ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${name}.dir/Unity/avx2.cpp)
    file(CONFIGURE OUTPUT ${avx2_sources} CONTENT "${lines}" @ONLY)
    list(APPEND sources ${avx2_sources})
  endif()
  add_library(${name} OBJECT ${sources})
  target_compile_features(${name} PUBLIC cxx_std_20)
  set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ${HSP_POSITION_INDEPENDENT}
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON UNITY_BUILD ${HSP_UNITY_BUILD} UNITY_BUILD_MODE GROUP)
  foreach(source ${HSP_LIBRARY_SOURCES})
    string(REGEX REPLACE ".*/(lib/)?([a-z]+)/[a-z_0-9]+\\.cpp$" "\\2" room ${source})
    set_source_files_properties(${source} TARGET_DIRECTORY ${name} PROPERTIES UNITY_GROUP ${room})
  endforeach()
  target_include_directories(${name} PUBLIC ${hardsphere_SOURCE_DIR}/include ${hardsphere_SOURCE_DIR}/lib
    PRIVATE ${hardsphere_SOURCE_DIR}/capi)
  target_compile_definitions(${name} PUBLIC $<$<BOOL:${HSP_PORTABLE_LIMBS}>:HSP_PORTABLE_LIMBS=1> ${ARGN})
  if(HSP_WIDE_CODE AND HSP_COMPILES_AVX2 AND NOT "HSP_AVX2=0" IN_LIST ARGN)
    target_compile_definitions(${name} PUBLIC HSP_AVX2=1)
    set_source_files_properties(${avx2_sources} TARGET_DIRECTORY ${name} PROPERTIES
      COMPILE_OPTIONS "${HSP_AVX2_OPTIONS}")
  endif()
  # -ffp-contract=off: the same bits with and without fused multiply-add. The vectorizer of g++ 12 does not obey it: it
  # makes fused instructions of complex products (vfmaddsub, fcmla), hence it is off. A section for each function and
  # table, so that the linker can leave out what a program does not call. The rest keeps the C++ run time out.
  target_compile_options(${name} PUBLIC -ffp-contract=off PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-tree-vectorize>
    ${HSP_OPTIMIZATION} -ffunction-sections -fdata-sections -fno-math-errno -fno-exceptions -fno-rtti
    -fno-threadsafe-statics -fno-asynchronous-unwind-tables -fstack-usage)
  # For Arm's 64-bit processors g++ 12 leaves out calls of functions that write to nothing but an object of the caller, if
  # its optimization of induction variables has made a difference of the object's address (PrefixCode::number_words).
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND HSP_TARGETS_AARCH64)
    target_compile_options(${name} PRIVATE -fno-ivopts)
  endif()
  target_link_libraries(${name} PRIVATE hardsphere_warnings hardsphere_sanitizers)
endfunction()
# Checked, an index out of range traps, under the address sanitizer the arrays in a handle's memory lie between poisoned
# bytes, and what the predicates' stages answer is counted.
set(HSP_CHECKS "")
if(HSP_CHECKED_LIBRARY)
  set(HSP_CHECKS HSP_CHECK_INDEX=1 HSP_COUNT_STAGES=1)
endif()
hsp_library_objects(hardsphere_objects ${HSP_CHECKS})

# An archive of one relocatable object, in which everything but hsp_* is local: nothing else can clash in a user's link.
# That takes GNU ld (lld lacks --force-group-allocation; Apple's linker and that for wasm know no such thing) and GNU
# objcopy. Objects for optimization at link time are left as they are.
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
if(NOT BUILD_SHARED_LIBS AND NOT DEFINED CACHE{HSP_SINGLE_OBJECT})
  hsp_can_link_single_object(HSP_SINGLE_OBJECT_WORKS)
endif()
option(HSP_SINGLE_OBJECT "Make the archive of one object with nothing but hsp_* in its symbol table"
  ${HSP_SINGLE_OBJECT_WORKS})

if(BUILD_SHARED_LIBS)
  add_library(hardsphere SHARED $<TARGET_OBJECTS:hardsphere_objects>)
  target_compile_definitions(hardsphere_objects PRIVATE HSP_BUILD_SHARED=1)
  set_target_properties(hardsphere PROPERTIES VERSION ${PROJECT_VERSION}
    SOVERSION ${HSP_ABI_NUMBER})
elseif(HSP_SINGLE_OBJECT)
  set(HSP_OBJECT ${CMAKE_CURRENT_BINARY_DIR}/hardsphere.o)
  add_custom_command(OUTPUT ${HSP_OBJECT}
    COMMAND ${HSP_LINK_OBJECT} -o ${HSP_OBJECT} $<TARGET_OBJECTS:hardsphere_objects>
    COMMAND ${HSP_KEEP_SYMBOLS} ${HSP_OBJECT}
    DEPENDS hardsphere_objects $<TARGET_OBJECTS:hardsphere_objects>
    COMMAND_EXPAND_LISTS VERBATIM)
  add_library(hardsphere STATIC ${HSP_OBJECT})
  set_source_files_properties(${HSP_OBJECT} PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)
else()
  add_library(hardsphere STATIC $<TARGET_OBJECTS:hardsphere_objects>)
endif()
add_library(hardsphere::hardsphere ALIAS hardsphere)
target_link_libraries(hardsphere PRIVATE $<BUILD_INTERFACE:hardsphere_sanitizers>)
# With C as the linker language a C or Fortran program links without the C++ run-time library.
if(HSP_SANITIZE)
  set_target_properties(hardsphere PROPERTIES LINKER_LANGUAGE CXX)
else()
  set_target_properties(hardsphere PROPERTIES LINKER_LANGUAGE C)
endif()
target_include_directories(hardsphere PUBLIC
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
# Systems that have no libm of its own find sqrt in their C library.
if(UNIX AND NOT APPLE)
  target_link_libraries(hardsphere PUBLIC m)
endif()
