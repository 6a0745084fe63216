// What holds for the records of every view. Each function returns what does not hold, or nothing.
#ifndef HARDSPHERE_TESTS_VIEW_VIEW_LAWS_HPP
#define HARDSPHERE_TESTS_VIEW_VIEW_LAWS_HPP

#include <string>

#include "view_run.hpp"

/// The axes are orthonormal, right-handed and those that the options ask for.
std::string axes_disagree(const ViewRecords &view, const ViewChoice &choice);

/// Ranges of loops and arcs, the box and the depths of hsp_view_info, places of centres; no ball of radius 0 and no
/// ball twice.
std::string records_disagree(const ViewRecords &view, const LibraryScene &scene, const ViewChoice &choice);

/// Loops are closed bit for bit; starts and ends agree with the arcs' equations to 1e-9 of the radius; silhouettes are
/// the balls', other arcs lie on the front hemispheres of their balls and on the spheres of the balls across.
std::string arcs_disagree(const ViewRecords &view, const LibraryScene &scene);

/// The area within every piece lies between 0 and that of the disc.
std::string areas_disagree(const ViewRecords &view);

/// Pieces follow each other from back to front, by integers; arcs of G-pieces are across farther balls.
std::string depths_disagree(const ViewRecords &view, const oracle::Balls &balls, const ViewChoice &choice);

/// With pieces of all balls: points of front hemispheres belong to their ball's piece if and only if they are outside
/// the balls that cut it, that is, for G-pieces the farther ones and for H-pieces all. `points` of each ball are tried
/// along a side of its square. Points within 1e-6 of the radius of a sphere or of an arc are not judged, and neither
/// are those that only balls inside other balls hold, which need not be used for cutting, nor such balls themselves.
std::string members_disagree(const oracle::Balls &balls, std::size_t points, const Direction &towards,
                             const Direction &up = {});

/// All of the above but members_disagree, for all_choices.
std::string view_laws_broken(const oracle::Balls &balls, const Direction &towards, const Direction &up = {});

/// The records of all views do not change with the order of the balls, bit for bit, but for ids.
std::string view_orders_disagree(const oracle::Balls &balls, const Direction &towards, const Direction &up = {});

/// The front parts of the whole boundary have the same area in the view plane as the back parts.
std::string opposite_areas_disagree(const oracle::Balls &balls, const Direction &towards);

#endif
