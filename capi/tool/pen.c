#include "pen.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

/* Capital a with ring: in UTF-8, and in ISO Latin 1 as PostScript has it in a string. */
static const char ring[] = "\xC3\x85";
static const char ring_of_postscript[] = "\\305";

static void put_colour(const struct pen *pen, uint32_t colour) {
  for (int shift = 16; shift >= 0; shift -= 8) {
    text_buffer_add(pen->out, "%.4g ", (double)(colour >> shift & 0xFF) / 255.0);
  }
  text_buffer_add(pen->out, "setrgbcolor\n");
}

void pen_begin(const struct pen *pen) {
  if (pen->postscript) {
    text_buffer_add(pen->out,
                    "gsave 1 setlinecap 1 setlinejoin\n/Helvetica findfont dup length dict begin{1 index/FID ne{def}"
                    "{pop pop}ifelse}forall\n/Encoding ISOLatin1Encoding def currentdict end/Written exch definefont "
                    "pop\n");
  } else {
    text_buffer_add(pen->out,
                    "<g font-family=\"Helvetica,Arial,sans-serif\" stroke-linecap=\"round\" "
                    "stroke-linejoin=\"round\">\n");
  }
}

void pen_end(const struct pen *pen) {
  text_buffer_add(pen->out, pen->postscript ? "grestore\n" : "</g>\n");
}

void pen_line(const struct pen *pen, const double from[2], const double to[2], double width, uint32_t colour) {
  if (pen->postscript) {
    put_colour(pen, colour);
    text_buffer_add(pen->out, "%.3f setlinewidth %.2f %.2f moveto %.2f %.2f lineto stroke\n", width, from[0],
                    pen->height - from[1], to[0], pen->height - to[1]);
  } else {
    text_buffer_add(pen->out, "<path stroke=\"#%06" PRIx32 "\" stroke-width=\"%.3f\" d=\"M%.2f %.2fL%.2f %.2f\"/>\n",
                    colour, width, from[0], from[1], to[0], to[1]);
  }
}

void pen_rectangle(const struct pen *pen, const double corner[2], double width, double height, uint32_t colour) {
  if (pen->postscript) {
    put_colour(pen, colour);
    text_buffer_add(pen->out, "%.2f %.2f %.2f %.2f rectfill\n", corner[0], pen->height - corner[1] - height, width,
                    height);
  } else {
    text_buffer_add(pen->out, "<rect x=\"%.2f\" y=\"%.2f\" width=\"%.2f\" height=\"%.2f\" fill=\"#%06" PRIx32 "\"/>\n",
                    corner[0], corner[1], width, height, colour);
  }
}

static bool is_ring(const char *c) {
  return strncmp(c, ring, 2) == 0;
}

static bool is_shown(char c) {
  return ' ' <= c && c <= '~';
}

static void put_string(const struct pen *pen, const char *text) {
  for (const char *c = text; *c != '\0'; ++c) {
    const char one[2] = {*c, '\0'};
    if (is_ring(c)) {
      text_buffer_add(pen->out, "%s", pen->postscript ? ring_of_postscript : ring);
      ++c;
    } else if (is_shown(*c) && pen->postscript) {
      text_buffer_add(pen->out, "%s%s", strchr("()\\", *c) != NULL ? "\\" : "", one);
    } else if (is_shown(*c)) {
      text_buffer_add_xml(pen->out, one);
    }
  }
}

static void write_postscript(const struct pen *pen, const struct pen_text *text) {
  text_buffer_add(pen->out, "/Written findfont %.3f scalefont setfont %.2f %.2f moveto (", text->size, text->x,
                  pen->height - text->y);
  put_string(pen, text->text);
  text_buffer_add(pen->out, ")\ndup stringwidth pop %.3g mul 0 rmoveto gsave %.3f setlinewidth\n", -text->anchor,
                  text->size / 5.0);
  put_colour(pen, text->seam);
  text_buffer_add(pen->out, "dup true charpath stroke grestore\n");
  put_colour(pen, text->colour);
  text_buffer_add(pen->out, "show\n");
}

void pen_write(const struct pen *pen, const struct pen_text *text) {
  if (pen->postscript) {
    write_postscript(pen, text);
    return;
  }
  const char *const anchor = text->anchor < 0.25 ? "start" : text->anchor < 0.75 ? "middle" : "end";
  for (int seam = 1; seam >= 0; --seam) {
    text_buffer_add(pen->out, "<text x=\"%.2f\" y=\"%.2f\" font-size=\"%.3f\" text-anchor=\"%s\" ", text->x, text->y,
                    text->size, anchor);
    if (seam == 1) {
      text_buffer_add(pen->out, "fill=\"none\" stroke=\"#%06" PRIx32 "\" stroke-width=\"%.3f\">", text->seam,
                      text->size / 5.0);
    } else {
      text_buffer_add(pen->out, "fill=\"#%06" PRIx32 "\">", text->colour);
    }
    put_string(pen, text->text);
    text_buffer_add(pen->out, "</text>\n");
  }
}

double pen_width(const char *text, double size) {
  double letters = 0.0;
  for (const char *c = text; *c != '\0'; ++c) {
    if (is_ring(c)) ++c;
    letters += 1.0;
  }
  return 0.6 * size * letters;
}
