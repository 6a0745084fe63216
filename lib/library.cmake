# The library: its sources, as objects for tests and as what is installed, an archive or with BUILD_SHARED_LIBS a shared
# library. No program that links either needs the C++ run-time library.

# In the order of the rooms.
set(HSP_LIBRARY_SOURCES
  lib/ground/core/elementary.cpp
  lib/ground/core/key_places.kernel.cpp
  lib/ground/exact/exact_predicates.cpp
  lib/balls/model/ball_set.cpp
  lib/balls/model/block_sweep.cpp
  lib/balls/model/cube_grid.cpp
  lib/balls/model/digit_sort.cpp
  lib/balls/model/grid_order.cpp
  lib/balls/model/halo.cpp
  lib/balls/model/neighbour_lists.cpp
  lib/balls/model/packing_statistics.cpp
  lib/balls/model/pair_block_avx2.cpp
  lib/balls/model/queries.cpp
  lib/balls/model/query_hits.cpp
  lib/balls/model/query_hits_avx2.cpp
  lib/balls/model/rounded_block_avx2.cpp
  lib/balls/model/row_directory.cpp
  lib/balls/model/ray_query.cpp
  lib/balls/model/set_digest.cpp
  lib/balls/model/vertical_ray.cpp
  lib/balls/poses/near_pairs.kernel.cpp
  lib/balls/poses/pose.cpp
  lib/balls/poses/pose_queries.cpp
  lib/balls/poses/rational_pose.cpp
  lib/balls/poses/sphere_tree.cpp
  lib/space/cells/arrangement.cpp
  lib/space/cells/cell_location.cpp
  lib/space/cells/cube_contacts.cpp
  lib/space/cells/cube_cover.cpp
  lib/space/cells/empty_runs.cpp
  lib/space/cells/facet_overlay.cpp
  lib/space/cells/free_space_builder.cpp
  lib/space/cells/free_space_check.cpp
  lib/space/cells/power_cell.cpp
  lib/space/cells/power_cell.kernel.cpp
  lib/space/cells/power_polytope.cpp
  lib/space/cells/power_predicates.cpp
  lib/space/cells/side_facets.cpp
  lib/space/paths/cell_crossing.cpp
  lib/space/paths/cell_search.cpp
  lib/space/paths/free_segments.cpp
  lib/space/paths/path_finder.cpp
  lib/space/paths/widest_probe.cpp
  lib/union/sphere/arc_geometry.cpp
  lib/union/sphere/cap_clusters.cpp
  lib/union/sphere/candidate_block_avx2.cpp
  lib/union/sphere/caps.cpp
  lib/union/sphere/cube_candidates.cpp
  lib/union/sphere/few_caps_avx2.cpp
  lib/union/sphere/float_caps_avx2.cpp
  lib/union/sphere/great_circles.cpp
  lib/union/sphere/lane_search.cpp
  lib/union/sphere/near_balls_avx2.cpp
  lib/union/sphere/pair_sweep_avx2.cpp
  lib/union/sphere/root_discriminants_avx2.cpp
  lib/union/sphere/vertex_finder.cpp
  lib/union/boundary/boundary_builder.cpp
  lib/union/boundary/boundary_check.cpp
  lib/union/boundary/boundary_part.cpp
  lib/union/boundary/boundary_worker.cpp
  lib/union/boundary/components.cpp
  lib/union/boundary/faces.cpp
  lib/union/boundary/half_edge_links.cpp
  lib/union/boundary/point_location.cpp
  lib/union/boundary/shells.cpp
  lib/union/measure/arc_batches.cpp
  lib/union/measure/arc_sums.kernel.cpp
  lib/union/measure/areas.cpp
  lib/union/measure/boundary_metric_check.cpp
  lib/union/measure/boundary_positions.cpp
  lib/union/measure/curvature.cpp
  lib/union/measure/edge_sums.kernel.cpp
  lib/union/measure/gradients.cpp
  lib/union/measure/tangency.cpp
  lib/union/topology/cells.cpp
  lib/union/topology/cut_arcs.cpp
  lib/union/topology/positions.cpp
  lib/union/topology/shell_volumes.cpp
  lib/union/topology/simple_faces.cpp
  lib/union/topology/subdivision.cpp
  lib/union/topology/topology_builder.cpp
  lib/union/topology/topology_check.cpp
  lib/union/topology/traversal.cpp
  lib/union/moving/ball_cells.cpp
  lib/union/moving/component_update.cpp
  lib/union/moving/moving_balls.cpp
  lib/union/contacts/chord_clipper.cpp
  lib/union/contacts/chord_cuts.kernel.cpp
  lib/union/contacts/chord_parts.cpp
  lib/union/contacts/chord_parts_avx2.cpp
  lib/union/contacts/chord_walk.cpp
  lib/union/contacts/contact_measures.cpp
  lib/union/contacts/contact_measures_avx2.cpp
  lib/union/contacts/contacts_builder.cpp
  lib/union/contacts/contacts_check.cpp
  lib/union/periodic/periodic_box.cpp
  lib/union/periodic/periodic_check.cpp
  lib/union/periodic/periodic_images.cpp
  lib/union/periodic/periodic_measures.cpp
  lib/union/periodic/periodic_morphometry.cpp
  lib/union/periodic/periodic_queries.cpp
  lib/union/periodic/periodic_records.cpp
  lib/union/periodic/periodic_union.cpp
  lib/union/periodic/windings.cpp
  lib/smooth/surface/concave_patches.cpp
  lib/smooth/surface/covered_gaps.cpp
  lib/smooth/surface/crease_lengths.cpp
  lib/smooth/surface/cusped_circles.cpp
  lib/smooth/surface/cut_patches.cpp
  lib/smooth/surface/degenerate_balls.cpp
  lib/smooth/surface/flat_patches.cpp
  lib/smooth/surface/near_probes.kernel.cpp
  lib/smooth/surface/patch_corners.cpp
  lib/smooth/surface/probe_caps.cpp
  lib/smooth/surface/probe_grid.cpp
  lib/smooth/surface/probe_positions.cpp
  lib/smooth/surface/region_pieces.cpp
  lib/smooth/surface/saddle.cpp
  lib/smooth/surface/saddle_sums.kernel.cpp
  lib/smooth/surface/settled_circles.cpp
  lib/smooth/surface/surface_areas.cpp
  lib/smooth/surface/surface_gradients.cpp
  lib/smooth/surface/surface_builder.cpp
  lib/smooth/surface/surface_check.cpp
  lib/smooth/surface/surface_map.cpp
  lib/smooth/surface/surface_patches.cpp
  lib/smooth/surface/surface_positions.cpp
  lib/smooth/surface/surface_shells.cpp
  lib/smooth/surface/probe_triangles.kernel.cpp
  lib/smooth/surface/weighted_joints.cpp
  lib/smooth/mesh/boundary_curves.cpp
  lib/smooth/mesh/boundary_outline.cpp
  lib/smooth/mesh/concave_outline.cpp
  lib/smooth/mesh/convex_outline.cpp
  lib/smooth/mesh/flat_strips.cpp
  lib/smooth/mesh/mesh_builder.cpp
  lib/smooth/mesh/pinched_cells.cpp
  lib/smooth/mesh/pinched_patch.cpp
  lib/smooth/mesh/sphere_triangulation.cpp
  lib/smooth/mesh/saddle_band.cpp
  lib/smooth/mesh/saddle_grids.cpp
  lib/smooth/mesh/spherical_patch.cpp
  lib/smooth/mesh/surface_curves.cpp
  lib/smooth/mesh/surface_outline.cpp
  lib/smooth/mesh/surface_vertices.cpp
  lib/sight/view/depth_buffer.cpp
  lib/sight/view/depth_order.cpp
  lib/sight/view/depth_rows.cpp
  lib/sight/view/depth_rows_avx2.cpp
  lib/sight/view/occlusion.cpp
  lib/sight/view/piece_arcs.cpp
  lib/sight/view/painted_paths.cpp
  lib/sight/view/projected_arcs.cpp
  lib/sight/view/view_builder.cpp
  lib/sight/view/view_frame.cpp
  lib/sight/view/view_rotation.cpp
  lib/sight/view/visible_piece.cpp
  lib/sight/visibility/arc_finder.cpp
  lib/sight/visibility/crease_arcs.cpp
  lib/sight/visibility/disc_grid.cpp
  lib/sight/visibility/edge_distance.cpp
  lib/sight/visibility/edge_geometry.cpp
  lib/sight/visibility/face_pole.cpp
  lib/sight/visibility/landings.cpp
  lib/sight/visibility/map_builder.cpp
  lib/sight/visibility/map_check.cpp
  lib/sight/visibility/map_faces.cpp
  lib/sight/visibility/map_linker.cpp
  lib/sight/visibility/map_paths.cpp
  lib/sight/visibility/map_queries.cpp
  lib/sight/visibility/map_silhouettes.cpp
  lib/sight/visibility/seen_balls.cpp
  lib/sight/visibility/silhouette_arcs.cpp
  lib/sight/visibility/trigonometric_roots.cpp
  lib/sight/sticks/body_sight.cpp
  lib/sight/sticks/drawing_order.cpp
  lib/sight/sticks/region_arcs.cpp
  lib/sight/sticks/region_builder.cpp
  lib/sight/sticks/region_faces.cpp
  lib/sight/sticks/region_linker.cpp
  lib/sight/sticks/region_loops.cpp
  lib/sight/sticks/region_outlines.cpp
  lib/sight/sticks/stick_outlines.cpp
  lib/sight/sticks/stick_sweep.cpp
  lib/sight/sticks/stick_view_builder.cpp
  lib/sight/picture/byte_sink.cpp
  lib/sight/picture/deflate.cpp
  lib/sight/picture/eps_writer.cpp
  lib/sight/picture/escaped_text.cpp
  lib/sight/picture/ink.cpp
  lib/sight/picture/number_text.cpp
  lib/sight/picture/page.cpp
  lib/sight/picture/paint.cpp
  lib/sight/picture/palettes.cpp
  lib/sight/picture/pdf_writer.cpp
  lib/sight/picture/picture.cpp
  lib/sight/picture/prefix_code.cpp
  lib/sight/picture/svg_path.cpp
  lib/sight/picture/svg_writer.cpp
  capi/shims/hsp_status.cpp
  capi/shims/element_radii.cpp
  capi/shims/hsp_element.cpp
  capi/shims/hsp_model.cpp
  capi/shims/hsp_query.cpp
  capi/shims/hsp_body.cpp
  capi/shims/hsp_boundary.cpp
  capi/shims/hsp_measure.cpp
  capi/shims/hsp_gradient.cpp
  capi/shims/hsp_curvature.cpp
  capi/shims/hsp_contacts.cpp
  capi/shims/hsp_periodic.cpp
  capi/shims/hsp_periodic_boundary.cpp
  capi/shims/hsp_periodic_curvature.cpp
  capi/shims/hsp_periodic_queries.cpp
  capi/shims/hsp_moving.cpp
  capi/shims/hsp_surface.cpp
  capi/shims/hsp_surface_records.cpp
  capi/shims/hsp_map.cpp
  capi/shims/hsp_map_records.cpp
  capi/shims/hsp_mesh.cpp
  capi/shims/hsp_topology.cpp
  capi/shims/hsp_topology_records.cpp
  capi/shims/hsp_topology_cells.cpp
  capi/shims/hsp_cells.cpp
  capi/shims/hsp_paths.cpp
  capi/shims/hsp_view.cpp
  capi/shims/hsp_view_records.cpp
  capi/shims/hsp_picture.cpp
  capi/shims/hsp_sticks.cpp
  capi/shims/hsp_sticks_map.cpp)
# Parts that a build may leave out: functions of theirs are then not in the library. What smooth, space and sight stand on
# is always there.
set(HSP_ALL_COMPONENTS smooth space sight)
set(HSP_COMPONENTS ${HSP_ALL_COMPONENTS} CACHE STRING "Parts of the library besides models, queries, unions and boxes")
set(HSP_smooth_SOURCES "lib/smooth/|capi/shims/hsp_(surface|mesh)")
set(HSP_space_SOURCES "lib/space/|capi/shims/hsp_(cells|paths)")
set(HSP_sight_SOURCES "lib/sight/|capi/shims/hsp_(view|map|sticks|picture)")
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
# Kernels are compiled once more for each further target (lib/ground/lanes/target.hpp), the second ones for AVX2 alone.
foreach(kind KERNEL AVX2)
  string(TOLOWER "[._]${kind}[.]cpp$" ending)
  set(HSP_${kind}_SOURCES ${HSP_LIBRARY_SOURCES})
  list(FILTER HSP_${kind}_SOURCES INCLUDE REGEX "${ending}")
  set(HSP_${kind}_SOURCES ${HSP_${kind}_SOURCES} CACHE INTERNAL "Sources of the library that match ${ending}")
endforeach()
list(REMOVE_ITEM HSP_LIBRARY_SOURCES ${HSP_AVX2_SOURCES})
# In the cache, so that projects that carry this one as a subdirectory can call the function below, too.
set(HSP_LIBRARY_SOURCES ${HSP_LIBRARY_SOURCES} CACHE INTERNAL "The other sources of the library")
# Includes name the room, not the wing.
set(HSP_WING_FOLDERS ground balls union smooth space sight)
list(TRANSFORM HSP_WING_FOLDERS PREPEND ${PROJECT_SOURCE_DIR}/lib/)
set(HSP_WING_FOLDERS ${HSP_WING_FOLDERS} CACHE INTERNAL "The folders of the library's rooms")

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

# Kernels for AVX2 beside those of the target's baseline, chosen at run time (lib/ground/lanes/target.hpp). Small targets do
# without.
option(HSP_WIDE_CODE "Code for wider registers too, chosen at run time" ON)
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

if(NOT DEFINED CACHE{HSP_TARGETS_AARCH64})
  set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
  check_cxx_source_compiles("
    #if !defined(__aarch64__)
    #error not this processor
    #endif
    int main() { return 0; }" HSP_TARGETS_AARCH64)
  unset(CMAKE_TRY_COMPILE_TARGET_TYPE)
endif()

# hsp_add_kernels(name target source... OPTIONS option...): kernels once more, in the namespace of a further target of the
# library. With HSP_UNITY_BUILD all of a target are one unit.
function(hsp_add_kernels name target)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" OPTIONS)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${name}.dir)
  set(text "#undef HSP_TARGET\n#define HSP_TARGET ${target}\n")
  foreach(source ${arg_UNPARSED_ARGUMENTS})
    if(HSP_UNITY_BUILD)
      set(unit ${folder}/Unity/${target}.cpp)
      string(APPEND text "#include \"${source}\"\n")
    else()
      file(RELATIVE_PATH unit ${hardsphere_SOURCE_DIR}/lib ${source})
      set(unit ${folder}/kernels/${target}/${unit})
      file(CONFIGURE OUTPUT ${unit} CONTENT "${text}#include \"${source}\"\n" @ONLY)
    endif()
    list(APPEND units ${unit})
  endforeach()
  list(REMOVE_DUPLICATES units)
  if(HSP_UNITY_BUILD)
    file(CONFIGURE OUTPUT ${units} CONTENT "${text}" @ONLY)
  endif()
  target_sources(${name} PRIVATE ${units})
  set_source_files_properties(${units} TARGET_DIRECTORY ${name} PROPERTIES COMPILE_OPTIONS "${arg_OPTIONS}"
    SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# hsp_library_objects(name definition...): the library compiled as objects, with further definitions. The archive is made
# of hardsphere_objects. Tests of inner parts link to a library of objects and compile what its headers define alike.
# With HSP_UNITY_BUILD a room is one unit, the interface another, the kernels of each further target a third: most of the
# time that a source takes alone goes into its headers.
function(hsp_library_objects name)
  add_library(${name} OBJECT ${HSP_LIBRARY_SOURCES})
  target_compile_features(${name} PUBLIC cxx_std_20)
  set_target_properties(${name} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ${HSP_POSITION_INDEPENDENT}
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON UNITY_BUILD ${HSP_UNITY_BUILD} UNITY_BUILD_MODE GROUP)
  foreach(source ${HSP_LIBRARY_SOURCES})
    string(REGEX REPLACE ".*/([a-z]+)/[a-z_0-9.]+\\.cpp$" "\\1" room ${source})
    set_source_files_properties(${source} TARGET_DIRECTORY ${name} PROPERTIES UNITY_GROUP ${room})
  endforeach()
  target_include_directories(${name} PUBLIC ${hardsphere_SOURCE_DIR}/include ${HSP_WING_FOLDERS}
    PRIVATE ${hardsphere_SOURCE_DIR}/capi/shims)
  target_compile_definitions(${name} PUBLIC $<$<BOOL:${HSP_PORTABLE_LIMBS}>:HSP_PORTABLE_LIMBS=1> ${ARGN}
    PRIVATE HSP_TARGET=baseline)
  if(HSP_WIDE_CODE AND HSP_COMPILES_AVX2 AND NOT "HSP_AVX2=0" IN_LIST ARGN)
    target_compile_definitions(${name} PUBLIC HSP_AVX2=1)
    hsp_add_kernels(${name} avx2 ${HSP_KERNEL_SOURCES} ${HSP_AVX2_SOURCES} OPTIONS ${HSP_AVX2_OPTIONS})
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
