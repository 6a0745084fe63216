/* Sizes that the charts of pores share, in px. */
#pragma once

#include "draw/chart.h"

enum { LEFT = 88, TOP = 20, WIDTH = 640, RIGHT = 40, LEGEND_ROW = 24, MARGIN_BELOW = 20 };
enum { BELOW = CHART_NAME_BELOW + LEGEND_ROW + 8 }; /* the line of the first row of a legend */

/* For lines of swatches to be long enough for rings, dashes and dots. */
enum { SWATCH = 28, BEHIND_SWATCH = 6 };
