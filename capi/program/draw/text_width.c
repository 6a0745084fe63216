#include "draw/text_width.h"

#include <stdint.h>
#include <string.h>

/* Widths of the characters of Helvetica from ' ' to '~', and of further ones in pictures, in thousandths of the size,
 * by Adobe's font metrics. All others are taken to be as wide as a digit. */
static const uint16_t widths[] = {
    278,  278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278, /* to '/' */
    556,  556, 556, 556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, /* to '?' */
    1015, 667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667, 556, 833, 722, 778, /* to 'O' */
    667,  778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469, 556, /* to '_' */
    333,  556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500, 222, 833, 556, 556, /* to 'o' */
    556,  556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584};     /* to '~' */
static const uint16_t digit = 556, angstrom = 667, square = 333;

/* Fonts that stand in for it are a little wider. */
static const double air = 1.05;

double text_width_exact(const char *text, double size) {
  uint32_t sum = 0;
  for (const char *c = text; *c != '\0'; ++c) {
    if (((unsigned char)*c & 0xC0) == 0x80) continue; /* goes on with a character */
    if (*c >= ' ' && *c <= '~') {
      sum += widths[*c - ' '];
    } else {
      sum += strncmp(c, "\xC3\x85", 2) == 0 ? angstrom : strncmp(c, "\xC2\xB2", 2) == 0 ? square : digit;
    }
  }
  return sum / 1000.0 * size;
}

double text_width(const char *text, double size) {
  return air * text_width_exact(text, size);
}
