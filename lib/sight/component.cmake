# Hidden parts removed from a direction, and pictures of the rest.
hsp_part(sight
  STANDS_ON union
  HEADERS view map sticks picture
  SOURCES
    view/covered_balls.cpp
    view/depth_buffer.cpp
    view/depth_order.cpp
    view/depth_rows.kernel.cpp
    view/occlusion.cpp
    view/piece_arcs.cpp
    view/projected_arcs.cpp
    view/view_builder.cpp
    view/view_frame.cpp
    view/view_rotation.cpp
    view/visible_piece.cpp
    maps/arc_finder.cpp
    maps/disc_grid.cpp
    maps/face_pole.cpp
    maps/map_builder.cpp
    maps/map_paths.cpp
    maps/seen_balls.cpp
    maps/stick_arcs.cpp
    maps/stick_map_builder.cpp
    maps/stick_outlines.cpp
    maps/stick_scene.cpp
    maps/strand_lines.cpp
    maps/stick_sweep.cpp
    maps/stick_view_builder.cpp
    maps/trigonometric_roots.cpp
    picture/byte_sink.cpp
    picture/deflate.cpp
    picture/eps_writer.cpp
    picture/escaped_text.cpp
    picture/ink.cpp
    picture/number_text.cpp
    picture/page.cpp
    picture/painted_paths.cpp
    picture/paint.cpp
    picture/palettes.cpp
    picture/pdf_writer.cpp
    picture/picture.cpp
    picture/prefix_code.cpp
    picture/svg_path.cpp
    picture/svg_writer.cpp
  SHIMS hsp_map hsp_map_records hsp_view hsp_view_records hsp_picture hsp_sticks hsp_sticks_map
  LEVELS shims -O1 view -O2)
