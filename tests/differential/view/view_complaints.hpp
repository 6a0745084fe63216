// The invariants of views, which are written in C, over the oracles' balls. Complaints for complaint_about_smallest.
#pragma once

#include <string>

#include "view_run.hpp"

// The first invariant of the records that does not hold, for all_choices, and whether their order is that of integers.
std::string view_invariant_broken(const oracle::Balls &balls, const Direction &towards, const Direction &up = {});

// Whether the regions of pieces, G and H and of all balls, are as defined at so many points of each ball.
std::string view_regions_disagree(const oracle::Balls &balls, uint32_t points, const Direction &towards);

// Whether the records of all_choices change with the order of the balls.
std::string view_orders_disagree(const oracle::Balls &balls, const Direction &towards);

// Whether the front parts of the whole boundary have another area in the view plane than the back parts.
std::string opposite_areas_disagree(const oracle::Balls &balls, const Direction &towards);

// Whether pieces follow each other from back to front by integers, and arcs of G-pieces lie on farther balls. For
// all_choices.
std::string depths_disagree(const oracle::Balls &balls, const Direction &towards);
