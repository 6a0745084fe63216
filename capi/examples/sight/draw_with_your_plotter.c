/* A program that draws with a plotter of its own: it takes pieces, loops and arcs from the library and turns them into
 * plain polygons, painted one over the other. Caffeine as SVG on standard output:
 *   draw_with_your_plotter > caffeine.svg
 * Replace the printf calls by what your plotter wants. No memory is allocated. */
#include <hardsphere.h>
#include <math.h>
#include <stdio.h>

#define BALLS 24
#define ARCS (12 * BALLS + 64)

/* Atomic number and centre in angstrom. */
static const double caffeine[BALLS][4] = {
    {7, 1.047, 0.000, -1.312},  {6, -0.208, 0.000, -1.790}, {6, 2.176, 0.000, -2.246},   {6, 1.285, -0.001, 0.016},
    {7, -1.276, 0.000, -0.971}, {8, -0.384, 0.000, -2.993}, {6, -2.629, 0.000, -1.533},  {6, -1.098, 0.000, 0.402},
    {6, 0.193, 0.005, 0.911},   {7, -1.934, 0.000, 1.444},  {8, 2.428, 0.000, 0.437},    {7, 0.068, 0.000, 2.286},
    {6, -1.251, 0.000, 2.560},  {6, 1.161, 0.000, 3.261},   {1, 1.800, 0.001, -3.269},   {1, 2.783, 0.890, -2.082},
    {1, 2.783, -0.889, -2.083}, {1, -2.570, 0.000, -2.622}, {1, -3.162, -0.890, -1.198}, {1, -3.162, 0.889, -1.198},
    {1, -1.679, 0.000, 3.552},  {1, 1.432, -1.028, 3.503},  {1, 2.024, 0.513, 2.839},    {1, 0.839, 0.513, 4.167}};

static unsigned char model_memory[HSP_MODEL_BYTES(BALLS)];
static unsigned char view_memory[HSP_VIEW_BYTES(BALLS, BALLS, ARCS)];
static hsp_view_piece pieces[BALLS];
static hsp_view_loop loops[ARCS];
static hsp_view_arc arcs[ARCS];

static int32_t compute(hsp_view **view) {
  double xyz[BALLS][3];
  double radius[BALLS];
  for (int i = 0; i < BALLS; ++i) {
    for (int axis = 0; axis < 3; ++axis) xyz[i][axis] = caffeine[i][1 + axis];
    const int number = (int)caffeine[i][0];
    radius[i] = number == 1 ? 1.10 : number == 6 ? 1.70 : number == 7 ? 1.55 : 1.52;
  }
  hsp_model *model;
  hsp_view_options options;
  const hsp_view_limits limits = {.struct_size = sizeof limits, .balls = BALLS, .neighbours = BALLS, .arcs = ARCS};
  int32_t status = hsp_model_init(model_memory, sizeof model_memory, BALLS, &model);
  if (status == HSP_OK) status = hsp_model_set(model, BALLS, &xyz[0][0], radius, NULL, NULL);
  if (status == HSP_OK) status = hsp_view_options_init(&options, sizeof options);
  if (status == HSP_OK) status = hsp_view_options_turn(&options, 60, 25, 0); /* degrees: the rings lie across y */
  if (status == HSP_OK) status = hsp_view_init(view_memory, sizeof view_memory, &limits, view);
  if (status == HSP_OK) status = hsp_view_compute(*view, model, NULL, &options, NULL);
  return status;
}

/* Points along an arc, its end left out: that is where the next arc begins. y grows downwards on the page. */
static void plot_arc(const hsp_view_arc *arc) {
  const int steps = 1 + (int)(fabs(arc->to - arc->from) / 0.1);
  const double c = cos(arc->rotation);
  const double s = sin(arc->rotation);
  printf(" %.4f,%.4f", arc->start[0], -arc->start[1]);
  for (int i = 1; i < steps; ++i) {
    const double t = arc->from + (arc->to - arc->from) * i / steps;
    const double along = arc->semi_axis[0] * cos(t);
    const double across = arc->semi_axis[1] * sin(t);
    printf(" %.4f,%.4f", arc->centre[0] + along * c - across * s, -(arc->centre[1] + along * s + across * c));
  }
}

/* All loops of a piece are one path: the holes stay open. */
static void plot_piece(const hsp_view_piece *piece) {
  const uint32_t number = (uint32_t)caffeine[piece->ball][0];
  printf("<path data-ball=\"%u\" fill=\"#%06x\" d=\"", (unsigned)piece->ball,
         (unsigned)hsp_palette_colour(HSP_PALETTE_SOFT, number, 0));
  for (uint32_t l = piece->first_loop; l < piece->first_loop + piece->loops; ++l) {
    printf("M");
    for (uint32_t a = loops[l].first_arc; a < loops[l].first_arc + loops[l].arcs; ++a) plot_arc(&arcs[a]);
    printf("Z");
  }
  printf("\"/>\n");
}

int main(void) {
  hsp_view *view;
  hsp_view_info info;
  uint32_t count = 0;
  uint32_t needed = 0;
  int32_t status = compute(&view);
  if (status == HSP_OK) status = hsp_view_get_info(view, &info);
  if (status == HSP_OK) status = hsp_view_get_pieces(view, pieces, BALLS, &count);
  if (status == HSP_OK) status = hsp_view_get_loops(view, loops, ARCS, &needed);
  if (status == HSP_OK) status = hsp_view_get_arcs(view, arcs, ARCS, &needed);
  if (status != HSP_OK) {
    fprintf(stderr, "draw_with_your_plotter: %s\n", hsp_status_text(status));
    return 1;
  }
  printf("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"600\" viewBox=\"%.4f %.4f %.4f %.4f\" ", info.low[0] - 0.1,
         -info.high[1] - 0.1, info.high[0] - info.low[0] + 0.2, info.high[1] - info.low[1] + 0.2);
  printf("stroke=\"#23202b\" stroke-width=\"0.03\" stroke-linejoin=\"round\">\n");
  for (uint32_t i = 0; i < count; ++i) plot_piece(&pieces[i]); /* farthest first */
  printf("</svg>\n");
  return 0;
}
