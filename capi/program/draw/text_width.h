/* How much room a line of text takes. */
#pragma once

/* How wide a text, in UTF-8, becomes in Helvetica of a size, without kerning; and in fonts that stand in for it, about.
 */
double text_width_exact(const char *text, double size);
double text_width(const char *text, double size);
