/* How large a picture is, and what part of what is seen it shows. */
#ifndef HARDSPHERE_TOOL_PICTURE_FRAME_H
#define HARDSPHERE_TOOL_PICTURE_FRAME_H

#include "drawing.h"
#include "hardsphere.h"

/* Sets both sides of a picture of which one or both are given, with its margin and scale. What follows in px is whole:
 * a last row of which a part is covered is a pale line. A picture that is cropped becomes one with a fixed frame. */
void picture_frame_set(const struct drawing *drawing, const hsp_view_info *view, hsp_picture_options *options);

#endif
