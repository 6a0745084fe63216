/* How much room a line of text takes. */
#ifndef HARDSPHERE_TOOL_TEXT_WIDTH_H
#define HARDSPHERE_TOOL_TEXT_WIDTH_H

/* About how wide a text, in UTF-8, becomes in Helvetica of a size, without kerning. */
double text_width(const char *text, double size);

#endif
