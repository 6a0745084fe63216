#include "draw/text_width.h"

#include <stdint.h>

/* Of Helvetica's characters from the blank to the tilde, in thousandths of a size; of others as of digits. */
static const uint16_t widths[] = {278,  278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278,
                                  556,  556, 556, 556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556,
                                  1015, 667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667, 556, 833, 722, 778,
                                  667,  778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469, 556,
                                  333,  556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500, 222, 833, 556, 556,
                                  556,  556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584};
static const uint16_t digit = 556;

/* Fonts that stand in for it are a little wider. */
static const double air = 1.05;

double text_width(const char *text, double size) {
  uint32_t sum = 0;
  for (const char *c = text; *c != '\0'; ++c) {
    const unsigned char byte = (unsigned char)*c;
    if ((byte & 0xC0) == 0x80) continue; /* goes on with a character */
    sum += byte >= ' ' && byte <= '~' ? widths[byte - ' '] : digit;
  }
  return air * size * sum / 1000.0;
}
