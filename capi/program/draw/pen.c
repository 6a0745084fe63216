#include "draw/pen.h"

#include <inttypes.h>
#include <stdbool.h>
#include <string.h>

#include "draw/text_width.h"
#include "hardsphere.h"

/* Characters beyond ASCII: in UTF-8, and in a string of PostScript or PDF, where ISO Latin 1 and Windows agree. */
struct letter {
  const char *utf8; /* two bytes */
  const char *in_string;
};
static const struct letter letters[] = {{"\xC3\x85", "\\305"}, {"\xC2\xB2", "\\262"}};
enum { LETTERS = sizeof letters / sizeof letters[0] };

static void put_colour(const struct pen *pen, uint32_t colour, const char *command) {
  for (int shift = 16; shift >= 0; shift -= 8) {
    text_buffer_add(pen->out, "%.4g ", (double)(colour >> shift & 0xFF) / 255.0);
  }
  text_buffer_add(pen->out, "%s\n", command);
}

void pen_begin(const struct pen *pen) {
  if (pen->language == HSP_FORMAT_EPS) {
    text_buffer_add(pen->out,
                    "gsave 1 setlinecap 1 setlinejoin\n/Helvetica findfont dup length dict begin{1 index/FID ne{def}"
                    "{pop pop}ifelse}forall\n/Encoding ISOLatin1Encoding def currentdict end/Written exch definefont "
                    "pop\n");
  } else if (pen->language == HSP_FORMAT_PDF) {
    text_buffer_add(pen->out, "q .75 0 0 .75 0 0 cm 1 J 1 j\n");
  } else {
    text_buffer_add(pen->out,
                    "<g font-family=\"Helvetica,Arial,sans-serif\" stroke-linecap=\"round\" "
                    "stroke-linejoin=\"round\">\n");
  }
}

void pen_end(const struct pen *pen) {
  static const char *const ends[] = {"</g>\n", "grestore\n", "Q\n"};
  text_buffer_add(pen->out, "%s", ends[pen->language]);
}

void pen_line(const struct pen *pen, const double from[2], const double to[2], double width, uint32_t colour) {
  if (pen->language == HSP_FORMAT_EPS) {
    put_colour(pen, colour, "setrgbcolor");
    text_buffer_add(pen->out, "%.3f setlinewidth %.2f %.2f moveto %.2f %.2f lineto stroke\n", width, from[0],
                    pen->height - from[1], to[0], pen->height - to[1]);
  } else if (pen->language == HSP_FORMAT_PDF) {
    put_colour(pen, colour, "RG");
    text_buffer_add(pen->out, "%.3f w %.2f %.2f m %.2f %.2f l S\n", width, from[0], pen->height - from[1], to[0],
                    pen->height - to[1]);
  } else {
    text_buffer_add(pen->out, "<path stroke=\"#%06" PRIx32 "\" stroke-width=\"%.3f\" d=\"M%.2f %.2fL%.2f %.2f\"/>\n",
                    colour, width, from[0], from[1], to[0], to[1]);
  }
}

void pen_rectangle(const struct pen *pen, const double corner[2], double width, double height, uint32_t colour) {
  if (pen->language == HSP_FORMAT_SVG) {
    text_buffer_add(pen->out, "<rect x=\"%.2f\" y=\"%.2f\" width=\"%.2f\" height=\"%.2f\" fill=\"#%06" PRIx32 "\"/>\n",
                    corner[0], corner[1], width, height, colour);
    return;
  }
  const bool postscript = pen->language == HSP_FORMAT_EPS;
  put_colour(pen, colour, postscript ? "setrgbcolor" : "rg");
  text_buffer_add(pen->out, "%.2f %.2f %.2f %.2f %s\n", corner[0], pen->height - corner[1] - height, width, height,
                  postscript ? "rectfill" : "re f");
}

void pen_swatch(const struct pen *pen, const double corner[2], double letter, uint32_t colour, uint32_t frame) {
  pen_swatch_of(pen, corner, letter, &colour, 1, frame);
}

double pen_swatch_width(size_t colours) {
  return colours < 2 ? 0.9 : 0.45 * (double)colours;
}

void pen_swatch_of(const struct pen *pen, const double corner[2], double letter, const uint32_t *colour, size_t colours,
                   uint32_t frame) {
  const double behind[2] = {corner[0] - 0.06 * letter, corner[1] - 0.06 * letter};
  const double wide = pen_swatch_width(colours);
  pen_rectangle(pen, behind, (wide + 0.12) * letter, 1.02 * letter, frame);
  /* Each to the end, so that no light comes between two. */
  for (size_t k = 0; k < colours; ++k) {
    const double begin = wide / (double)colours * (double)k;
    const double at[2] = {corner[0] + begin * letter, corner[1]};
    pen_rectangle(pen, at, (wide - begin) * letter, 0.9 * letter, colour[k]);
  }
}

/* NULL for all others. */
static const struct letter *find_letter(const char *c) {
  for (int k = 0; k < LETTERS; ++k) {
    if (strncmp(c, letters[k].utf8, 2) == 0) return &letters[k];
  }
  return NULL;
}

static bool is_shown(char c) {
  return ' ' <= c && c <= '~';
}

static void put_string(const struct pen *pen, const char *text) {
  for (const char *c = text; *c != '\0'; ++c) {
    const char one[2] = {*c, '\0'};
    const struct letter *const letter = find_letter(c);
    if (letter != NULL) {
      text_buffer_add(pen->out, "%s", pen->language == HSP_FORMAT_SVG ? letter->utf8 : letter->in_string);
      ++c;
    } else if (is_shown(*c) && pen->language != HSP_FORMAT_SVG) {
      text_buffer_add(pen->out, "%s%s", strchr("()\\", *c) != NULL ? "\\" : "", one);
    } else if (is_shown(*c)) {
      text_buffer_add_xml(pen->out, one);
    }
  }
}

static bool has_seam(const struct pen_text *text) {
  return text->seam != text->colour;
}

static void write_postscript(const struct pen *pen, const struct pen_text *text) {
  text_buffer_add(pen->out, "/Written findfont %.3f scalefont setfont %.2f %.2f moveto (", text->size, text->x,
                  pen->height - text->y);
  put_string(pen, text->text);
  text_buffer_add(pen->out, ")\ndup stringwidth pop %.3g mul 0 rmoveto\n", -text->anchor);
  if (has_seam(text)) {
    text_buffer_add(pen->out, "gsave %.3f setlinewidth\n", text->size / 5.0);
    put_colour(pen, text->seam, "setrgbcolor");
    text_buffer_add(pen->out, "dup true charpath stroke grestore\n");
  }
  put_colour(pen, text->colour, "setrgbcolor");
  text_buffer_add(pen->out, "show\n");
}

/* The outlines of the letters, then the letters. */
static void write_pdf(const struct pen *pen, const struct pen_text *text) {
  const double x = text->x - text->anchor * text_width_exact(text->text, text->size);
  put_colour(pen, text->seam, "RG");
  put_colour(pen, text->colour, "rg");
  for (int seam = has_seam(text) ? 1 : 0; seam >= 0; --seam) {
    if (seam == 1) text_buffer_add(pen->out, "%.3f w\n", text->size / 5.0);
    text_buffer_add(pen->out, "BT /F1 %.3f Tf %d Tr %.2f %.2f Td (", text->size, seam, x, pen->height - text->y);
    put_string(pen, text->text);
    text_buffer_add(pen->out, ") Tj ET\n");
  }
}

void pen_write(const struct pen *pen, const struct pen_text *text) {
  if (pen->language == HSP_FORMAT_EPS) {
    write_postscript(pen, text);
    return;
  }
  if (pen->language == HSP_FORMAT_PDF) {
    write_pdf(pen, text);
    return;
  }
  /* A text that ends at a point begins where it does by the widths of Helvetica, as in PDF: some programs end its ink
   * there, and so a 1, which is narrower than its place, too far to the right. */
  const bool ends = text->anchor >= 0.75;
  const double x = ends ? text->x - text_width_exact(text->text, text->size) : text->x;
  const char *const anchor = ends || text->anchor < 0.25 ? "start" : "middle";
  for (int seam = has_seam(text) ? 1 : 0; seam >= 0; --seam) {
    text_buffer_add(pen->out, "<text x=\"%.2f\" y=\"%.2f\" font-size=\"%.3f\" text-anchor=\"%s\" ", x, text->y,
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
