#include "draw/text_width.h"

double text_width(const char *text, double size) {
  double letters = 0.0;
  for (const char *c = text; *c != '\0'; ++c) {
    if (((unsigned char)*c & 0xC0) != 0x80) letters += 1.0; /* where a character begins */
  }
  return 0.6 * size * letters;
}
