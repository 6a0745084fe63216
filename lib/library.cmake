<<<<<<< HEAD
# The library: the sources of its parts (components.cmake), as objects for tests and as what is installed, an archive or
# with BUILD_SHARED_LIBS a shared library. No program that links either needs the C++ run-time library.
=======
# The library: its sources, as objects for tests and as what is installed, an archive or with BUILD_SHARED_LIBS a shared
# library. No program that links either needs the C++ run-time library.

# In the order of the rooms.
set(HSP_LIBRARY_SOURCES
  lib/ground/core/elementary.cpp
  lib/ground/core/executor.cpp
  lib/ground/core/key_ranks.kernel.cpp
  lib/ground/exact/exact_predicates.cpp
  lib/balls/model/ball_set.cpp
  lib/balls/model/block_sweep.cpp
  lib/balls/model/cube_grid.cpp
  lib/balls/model/cube_index.cpp
  lib/balls/model/digit_sort.cpp
  lib/balls/model/grid_order.cpp
  lib/balls/model/halo.cpp
  lib/balls/model/meeting.cpp
  lib/balls/model/neighbour_lists.cpp
  lib/balls/model/ordered_balls.cpp
  lib/balls/model/packing_statistics.cpp
  lib/balls/model/pair_block.kernel.cpp
  lib/balls/model/queries.cpp
  lib/balls/model/query_hits.cpp
  lib/balls/model/query_hits.kernel.cpp
  lib/balls/model/rounded_block.kernel.cpp
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
  lib/space/cells/facet_parts.cpp
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
  lib/union/sphere/candidate_block.kernel.cpp
  lib/union/sphere/caps.cpp
  lib/union/sphere/cube_candidates.cpp
  lib/union/sphere/few_caps.kernel.cpp
  lib/union/sphere/exposed_caps.cpp
  lib/union/sphere/float_caps.kernel.cpp
  lib/union/sphere/great_circles.cpp
  lib/union/sphere/lane_search.cpp
  lib/union/sphere/near_balls.kernel.cpp
  lib/union/sphere/near_caps.cpp
  lib/union/sphere/outer_cell.cpp
  lib/union/sphere/outer_cell.kernel.cpp
  lib/union/sphere/pair_sweep.kernel.cpp
  lib/union/sphere/root_discriminants.kernel.cpp
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
  lib/union/topology/regions.cpp
  lib/union/topology/cut_arcs.cpp
  lib/union/topology/positions.cpp
  lib/union/topology/shell_volumes.cpp
  lib/union/topology/simple_faces.cpp
  lib/union/topology/subdivision.cpp
  lib/union/topology/topology_builder.cpp
  lib/union/topology/topology_check.cpp
  lib/union/topology/traversal.cpp
  lib/union/moving/ball_cells.cpp
  lib/union/moving/ball_group.cpp
  lib/union/moving/component_update.cpp
  lib/union/moving/moving_balls.cpp
  lib/union/contacts/chord_clipper.cpp
  lib/union/contacts/chord_cuts.kernel.cpp
  lib/union/contacts/chord_ends.cpp
  lib/union/contacts/chord_ends.kernel.cpp
  lib/union/contacts/chord_walk.cpp
  lib/union/contacts/contact_measures.cpp
  lib/union/contacts/contact_measures.kernel.cpp
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
  lib/union/periodic/surface_volume.cpp
  lib/union/periodic/windings.cpp
  lib/space/pores/ascent.cpp
  lib/space/pores/balls_around.cpp
  lib/space/pores/class_tree.cpp
  lib/space/pores/critical_points.cpp
  lib/space/pores/cube_halves.kernel.cpp
  lib/space/pores/gate_finder.cpp
  lib/space/pores/leaf_points.cpp
  lib/space/pores/plugs.cpp
  lib/space/pores/pockets.cpp
  lib/space/pores/point_records.cpp
  lib/space/pores/pore_balls.cpp
  lib/space/pores/pores_builder.cpp
  lib/space/pores/region_finder.cpp
  lib/space/pores/tangent_point.cpp
  lib/space/pores/tied_balls.cpp
  lib/space/pores/tunnel.cpp
  lib/space/pores/way_up.cpp
  lib/smooth/surface/arc_parts.cpp
  lib/smooth/surface/coincident_patches.cpp
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
  lib/sight/view/depth_rows.kernel.cpp
  lib/sight/view/occlusion.cpp
  lib/sight/view/piece_arcs.cpp
  lib/sight/view/projected_arcs.cpp
  lib/sight/view/view_builder.cpp
  lib/sight/view/view_frame.cpp
  lib/sight/view/view_rotation.cpp
  lib/sight/view/visible_piece.cpp
  lib/sight/maps/arc_finder.cpp
  lib/sight/maps/disc_grid.cpp
  lib/sight/maps/face_pole.cpp
  lib/sight/maps/map_builder.cpp
  lib/sight/maps/map_paths.cpp
  lib/sight/maps/seen_balls.cpp
  lib/sight/maps/stick_arcs.cpp
  lib/sight/maps/stick_map_builder.cpp
  lib/sight/maps/stick_outlines.cpp
  lib/sight/maps/stick_scene.cpp
  lib/sight/maps/strand_lines.cpp
  lib/sight/maps/stick_sweep.cpp
  lib/sight/maps/stick_view_builder.cpp
  lib/sight/maps/trigonometric_roots.cpp
  lib/sight/picture/byte_sink.cpp
  lib/sight/picture/deflate.cpp
  lib/sight/picture/eps_writer.cpp
  lib/sight/picture/escaped_text.cpp
  lib/sight/picture/ink.cpp
  lib/sight/picture/number_text.cpp
  lib/sight/picture/page.cpp
  lib/sight/picture/painted_paths.cpp
  lib/sight/picture/paint.cpp
  lib/sight/picture/palettes.cpp
  lib/sight/picture/pdf_writer.cpp
  lib/sight/picture/picture.cpp
  lib/sight/picture/prefix_code.cpp
  lib/sight/picture/svg_path.cpp
  lib/sight/picture/svg_writer.cpp
  capi/shims/hsp_status.cpp
  capi/shims/element_radii.cpp
  capi/shims/element_symbols.cpp
  capi/shims/hsp_element.cpp
  capi/shims/residue_radii.cpp
  capi/shims/hsp_residue.cpp
  capi/shims/hsp_model.cpp
  capi/shims/hsp_query.cpp
  capi/shims/hsp_areas.cpp
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
  capi/shims/hsp_topology_regions.cpp
  capi/shims/hsp_cells.cpp
  capi/shims/hsp_paths.cpp
  capi/shims/hsp_pores.cpp
  capi/shims/hsp_pores_pockets.cpp
  capi/shims/hsp_view.cpp
  capi/shims/hsp_view_records.cpp
  capi/shims/hsp_picture.cpp
  capi/shims/hsp_sticks.cpp
  capi/shims/hsp_sticks_map.cpp)

# The wings: which sources are theirs, the interface's among them, and whose headers those of lib/ find. The part of
# the interface that no other pattern takes is union's.
set(ground_pattern "lib/ground/")
set(balls_pattern "lib/balls/|capi/shims/(element_(radii|symbols)|residue_radii|hsp_(status|element|residue|model|query|body))\\.cpp")
set(union_pattern "lib/union/|capi/shims/")
foreach(component ${HSP_ALL_COMPONENTS})
  list(JOIN HSP_${component}_HEADERS "|" headers)
  set(${component}_pattern "lib/${component}/|capi/shims/hsp_(${headers})")
endforeach()
set(ground_roots ground)
set(balls_roots ground balls)
set(union_roots ground balls union)
set(smooth_roots ground balls union smooth)
set(space_roots ground balls union space)
set(sight_roots ground balls union sight)
# In the cache, so that projects that carry this one as a subdirectory can call the function below, too.
set(sources ${HSP_LIBRARY_SOURCES})
set(wings "")
set(folders "")
foreach(wing ground balls smooth space sight union)
  set(own ${sources})
  list(FILTER own INCLUDE REGEX "^(${${wing}_pattern})")
  list(FILTER sources EXCLUDE REGEX "^(${${wing}_pattern})")
  if(NOT wing IN_LIST HSP_LEFT_OUT)
    list(TRANSFORM own PREPEND ${PROJECT_SOURCE_DIR}/)
    set(HSP_${wing}_SOURCES ${own} CACHE INTERNAL "The sources of the wing ${wing}")
    list(TRANSFORM ${wing}_roots PREPEND ${PROJECT_SOURCE_DIR}/lib/ OUTPUT_VARIABLE roots)
    set(HSP_${wing}_ROOTS ${roots} CACHE INTERNAL "Where its sources find headers")
    list(APPEND wings ${wing})
    list(APPEND folders ${PROJECT_SOURCE_DIR}/lib/${wing})
  endif()
endforeach()
set(HSP_WINGS ${wings} CACHE INTERNAL "The wings that are built")
set(HSP_WING_FOLDERS ${folders} CACHE INTERNAL "The folders of their rooms")
>>>>>>> h2

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
# Where all would take -O3, some rooms and shims take less.
string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
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

if(NOT DEFINED CACHE{HSP_TARGETS_AARCH64})
  set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
  check_cxx_source_compiles("
    #if !defined(__aarch64__)
    #error not this processor
    #endif
    int main() { return 0; }" HSP_TARGETS_AARCH64)
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
  lib/union/sphere/root_discriminants.kernel.cpp)
list(TRANSFORM HSP_SOURCES_OF_LANES PREPEND ${PROJECT_SOURCE_DIR}/)
set(HSP_SOURCES_OF_LANES ${HSP_SOURCES_OF_LANES} CACHE INTERNAL "Sources with lanes of registers alone")

# hsp_add_to_unit(unit source target folders): for hsp_library_objects, a source to one of its units, or by itself.
function(hsp_add_to_unit unit source target folders)
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
  set(options "")
  if(target STREQUAL "avx2")
    set(options ${HSP_AVX2_OPTIONS})
  elseif(HSP_OPTIMIZED)
    list(FIND HSP_${part}_LEVELS ${room} at)
    if(at GREATER_EQUAL 0)
      math(EXPR at "${at} + 1")
      list(GET HSP_${part}_LEVELS ${at} options)
    endif()
  endif()
  set_source_files_properties(${file} PROPERTIES INCLUDE_DIRECTORIES "${folders}" COMPILE_OPTIONS "${options}")
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
      hsp_add_to_unit(${room} ${source} baseline "${roots}")
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
        hsp_add_to_unit(${unit} ${source} avx2 "${roots}")
      endif()
    endforeach()
    set(roots ${own_roots})
    list(APPEND roots ${hardsphere_SOURCE_DIR}/lib/balls ${hardsphere_SOURCE_DIR}/lib/union ${hardsphere_SOURCE_DIR}/include)
    foreach(shims core ${HSP_${part}_PARTS})
      list(APPEND roots ${hardsphere_SOURCE_DIR}/capi/shims/${shims})
    endforeach()
    set(room shims)
    foreach(source ${HSP_${part}_SHIMS} ${HSP_${part}_SHIMS_APART})
      set(unit ${part}_shims)
      if(source IN_LIST HSP_${part}_SHIMS_APART)
        get_filename_component(unit ${source} NAME_WE)
      endif()
      hsp_add_to_unit(${unit} ${source} baseline "${roots}")
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
  target_compile_definitions(${name} PUBLIC ${HSP_COMPONENT_DEFINITIONS}
    $<$<BOOL:${HSP_PORTABLE_LIMBS}>:HSP_PORTABLE_LIMBS=1> $<$<BOOL:${wide}>:HSP_AVX2=1> $<$<BOOL:${lanes}>:HSP_LANES=1> ${ARGN} PRIVATE HSP_TARGET=baseline)
  # -ffp-contract=off: the same bits with and without fused multiply-add. The vectorizer of g++ 12 does not obey it: it
  # makes fused instructions of complex products (vfmaddsub, fcmla), hence it is off. A section for each function and
  # table, so that the linker can leave out what a program does not call. -fno-gnu-unique: constants of headers are weak
  # symbols as functions are, which an archive of one object makes local. The rest keeps the C++ run time out.
  target_compile_options(${name} PUBLIC -ffp-contract=off PRIVATE
    $<$<CXX_COMPILER_ID:GNU>:-fno-tree-vectorize> $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>
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
# Each function and table has a section of its own: where the linker can, it leaves out what a program does not call.
set(HSP_PC_LINKS "")
if(NOT BUILD_SHARED_LIBS AND NOT HSP_SANITIZE)
  check_linker_flag(C -Wl,--gc-sections HSP_LINKER_COLLECTS_SECTIONS)
  if(HSP_LINKER_COLLECTS_SECTIONS)
    target_link_options(hardsphere INTERFACE -Wl,--gc-sections)
    set(HSP_PC_LINKS " -Wl,--gc-sections")
  endif()
endif()
