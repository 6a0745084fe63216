#include "draw/mesh_page.h"

#include <math.h>

#include "draw/colour_mixed.h"
#include "draw/look.h"
#include "draw/pocket_colours.h"
#include "hardsphere.h"
#include "read/vectors.h"

static const uint32_t inside_colour = 0xC9B79C;
static const uint32_t void_colour = 0x14747A;
static const double element_share = 0.7; /* the rest is grey */
static const uint32_t grey = 0xD2CDC3;

enum { CARBON = 6 };

/* ---- where things are ---- */

int32_t mesh_rounded(double value) {
  return (int32_t)floor(value + 0.5);
}

void mesh_find_frame(const struct mesh_parts *parts, struct frame *frame) {
  const double wide = parts->high[0] - parts->low[0];
  const double high = parts->high[1] - parts->low[1];
  const double around = PAGE_MARGIN * (wide > high ? wide : high);
  const double across = wide + 2.0 * around;
  *frame = (struct frame){1.0, 0.0, 0.0, mesh_rounded(10.0 * PICTURE_WIDTH), mesh_rounded(10.0 * PICTURE_WIDTH), 0};
  if (!(across > 0.0)) return; /* nothing is seen */
  frame->scale = 10.0 * PICTURE_WIDTH / across;
  frame->left = parts->low[0] - around;
  frame->top = parts->high[1] + around;
  frame->height = 10 * mesh_rounded(ceil(frame->scale * (high + 2.0 * around) / 10.0)); /* whole px */
  frame->strip = mesh_rounded(2.0 * PAGE_LETTER);
}

void mesh_place(const struct frame *frame, const double *at, int32_t page[2]) {
  page[0] = mesh_rounded((at[0] - frame->left) * frame->scale);
  page[1] = mesh_rounded((frame->top - at[1]) * frame->scale);
}

void mesh_turn(const double axis[3][3], const double *from, double to[3]) {
  for (int k = 0; k < 3; ++k) to[k] = dot(axis[k], from);
}

/* ---- sides and colours ---- */

static int pocket_side(uint8_t pocket, int side) {
  return SIDES + 2 * (pocket - 1) + (side == OF_VOID ? 1 : 0);
}

int mesh_pocket_of(int side) {
  return side < SIDES ? 0 : (side - SIDES) / 2 + 1;
}

int mesh_plain_side(int side) {
  return side < SIDES ? side : (side - SIDES) % 2 == 1 ? OF_VOID : OUTSIDE;
}

bool mesh_faces_viewer(const struct mesh_picture *picture, uint32_t triangle) {
  return picture->faces[triangle] !=
         mesh_parts_is_of_void(&picture->parts, picture->mesh->corners[3 * (size_t)triangle]);
}

int mesh_side_of(const struct mesh_picture *picture, uint32_t triangle) {
  const struct mesh_pockets *const pockets = picture->view->pockets;
  const uint8_t pocket = pockets == NULL                        ? 0
                         : triangle < picture->view->of_outside ? pockets->of_triangle[triangle]
                                                                : pockets->of_patch[picture->mesh->patches[triangle]];
  const bool of_void = mesh_parts_is_of_void(&picture->parts, picture->mesh->corners[3 * (size_t)triangle]);
  const int side = of_void ? OF_VOID : !picture->faces[triangle] ? INSIDE : OUTSIDE;
  return pocket > 0 && side != INSIDE ? pocket_side(pocket, side) : side;
}

static uint32_t colour_number(struct mesh_picture *picture, uint32_t colour) {
  uint32_t k = 0;
  while (k < picture->colours && picture->colour[k] != colour) ++k;
  if (k == MOST_COLOURS) return k - 1; /* more than there are elements */
  if (k == picture->colours) picture->colour[picture->colours++] = colour;
  return k;
}

uint32_t mesh_element_of(const struct mesh_picture *picture, uint32_t ball) {
  const struct atom_label *label = &picture->molecule->label[ball];
  return label->element.text[0] == '\0' ? CARBON : element_atomic_number(label->element);
}

uint32_t mesh_element_colour(uint32_t number) {
  return colour_mixed(grey, hsp_palette_colour(HSP_PALETTE_SOFT, number, 0), element_share);
}

uint32_t mesh_plain_colour(int side) {
  return side == INSIDE ? inside_colour : side == OF_VOID ? void_colour : grey;
}

uint32_t mesh_page_colour(const struct mesh_picture *picture) {
  return picture->view->dark ? DARK_PAGE : UINT32_C(0xFFFFFF);
}

uint32_t mesh_text_colour(const struct mesh_picture *picture) {
  return picture->view->dark ? DARK_PAGE_TEXT : LINE_COLOUR;
}

uint32_t mesh_pocket_colour(int pocket) {
  return pocket == OTHER_POCKETS ? other_pockets_colour : pocket_colours[pocket - 1];
}

uint32_t mesh_colour_of(struct mesh_picture *picture, uint32_t ball, int side) {
  if (mesh_pocket_of(side) > 0) return colour_number(picture, mesh_pocket_colour(mesh_pocket_of(side)));
  if (side == INSIDE) return colour_number(picture, inside_colour);
  if (picture->view->pockets != NULL) return colour_number(picture, grey);
  if (side == OF_VOID) return colour_number(picture, void_colour);
  if (picture->view->cut) return colour_number(picture, grey);
  if (ball == BETWEEN_ATOMS) return colour_number(picture, BETWEEN_COLOUR);
  return colour_number(picture, mesh_element_colour(mesh_element_of(picture, ball)));
}
