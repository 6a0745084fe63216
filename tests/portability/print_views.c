#include <inttypes.h>
#include <stdio.h>

#include "interface_bits.h"
#include "picture_sink.h"
#include "view_result.h"

static void print_info(const hsp_view_info *info) {
  printf("view %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32, info->kind, info->pieces, info->loops, info->arcs);
  print_doubles(info->origin, 3);
  print_doubles(info->right, 3);
  print_doubles(info->up, 3);
  print_doubles(info->towards, 3);
  print_doubles(info->low, 2);
  print_doubles(info->high, 2);
  print_doubles(&info->depth_low, 1);
  print_doubles(&info->depth_high, 1);
  end_line();
}

static void print_records(const view_result *v) {
  uint32_t i;
  for (i = 0; i < v->info.pieces; ++i) {
    const hsp_view_piece *piece = &v->pieces[i];
    printf("piece %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIu32, piece->ball, piece->first_loop,
           piece->loops, piece->first_arc, piece->arcs);
    print_doubles(piece->centre, 2);
    print_doubles(&piece->depth, 1);
    print_doubles(&piece->radius, 1);
    end_line();
  }
  for (i = 0; i < v->info.loops; ++i) {
    printf("loop %" PRIu32 " %" PRIu32 " %" PRIu32 "\n", v->loops[i].piece, v->loops[i].first_arc, v->loops[i].arcs);
  }
  for (i = 0; i < v->info.arcs; ++i) {
    const hsp_view_arc *arc = &v->arcs[i];
    printf("view arc %" PRIu32 " %" PRIu32, arc->piece, arc->other_ball);
    print_doubles(arc->centre, 2);
    print_doubles(arc->semi_axis, 2);
    print_doubles(&arc->rotation, 1);
    print_doubles(&arc->from, 1);
    print_doubles(&arc->to, 1);
    print_doubles(arc->start, 2);
    print_doubles(arc->end, 2);
    end_line();
  }
}

/* Every format in every style, as number of bytes and their FNV-1a hash (Fowler, Noll, Vo). */
static void print_pictures(const view_result *v) {
  hsp_picture_options options;
  uint32_t format, style;
  print_status("picture options", hsp_picture_options_init(&options, (uint32_t)sizeof options));
  end_line();
  for (format = HSP_FORMAT_SVG; format <= HSP_FORMAT_PDF; ++format) {
    for (style = HSP_STYLE_FLAT; style <= HSP_STYLE_SOFT; ++style) {
      uint64_t hash = UINT64_C(0xCBF29CE484222325), bytes = 0;
      picture_sink sink;
      size_t i;
      options.format = format;
      options.style = style;
      options.unit = style % 2;
      picture_sink_start(&sink, SIZE_MAX);
      print_status("picture", hsp_picture_write(v->view, NULL, &options, "a <title>", "\xC3\xA9t\xC3\xA9",
                                                picture_sink_take, &sink, &bytes));
      for (i = 0; i < sink.count; ++i) hash = (hash ^ (unsigned char)sink.bytes[i]) * UINT64_C(0x100000001B3);
      printf(" %" PRIu32 " %" PRIu32 " %" PRIu64 " %016" PRIx64 "\n", format, style, bytes, hash);
      picture_sink_release(&sink);
    }
  }
}

static void print_view(const computed *c, uint32_t pieces, uint32_t flags, double x, double y, double z) {
  hsp_view_options options;
  view_result v;
  int32_t status = hsp_view_options_init(&options, (uint32_t)sizeof options);
  if (status == HSP_OK) status = hsp_view_options_turn(&options, x, y, z);
  print_status("turned", status);
  print_doubles(options.towards, 3);
  print_doubles(options.up, 3);
  end_line();
  options.pieces = pieces;
  options.flags = flags;
  status = view_result_make(c, &options, pieces == HSP_PIECES_OUTSIDE_ALL, &v);
  print_status("view", status);
  printf(" %" PRIu32 " %" PRIu32 "\n", v.needed.neighbours, v.needed.arcs);
  if (status == HSP_OK) {
    print_info(&v.info);
    print_records(&v);
    print_pictures(&v);
  }
  view_result_release(&v);
}

void print_views(const computed *c) {
  uint32_t number, chain;
  print_view(c, HSP_PIECES_OUTSIDE_FARTHER, HSP_VIEW_ALL_BALLS, 0, 0, 0);
  print_view(c, HSP_PIECES_OUTSIDE_FARTHER, 0, -90, 0, 180);
  print_view(c, HSP_PIECES_OUTSIDE_FARTHER, 0, 25, -35, 10.5);
  print_view(c, HSP_PIECES_OUTSIDE_ALL, HSP_VIEW_ALL_BALLS, 300, 123.25, 1);
  printf("palettes");
  for (number = 0; number < 119; number += 6) {
    for (chain = 0; chain < 3; ++chain) printf(" %06" PRIx32, hsp_palette_colour(chain, number, chain));
  }
  end_line();
}
