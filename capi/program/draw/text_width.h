/* The width of a line of text. */
#pragma once

/* The width of a text, in UTF-8, in Helvetica of a size, without kerning; and the approximate width in fonts that are
 * used in its place. */
double text_width_exact(const char *text, double size);
double text_width(const char *text, double size);
