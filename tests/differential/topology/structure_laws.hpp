// What the header promises about every topology, tested on the records that the interface hands out. Lengths are
// lattice steps.
#ifndef HARDSPHERE_TESTS_TOPOLOGY_STRUCTURE_LAWS_HPP
#define HARDSPHERE_TESTS_TOPOLOGY_STRUCTURE_LAWS_HPP

#include <string>

#include "topology_run.hpp"

/// The algebra of quarter-edges (properties 1 to 5), the flat arrays against the functions, origins in one ring for
/// every vertex and every simple face, at least two edges around a face, no edge with one face on both sides.
std::string algebra_broken(const LibraryTopology &topology);

/// One record by its id is what the array of all has, and there are no others.
std::string records_disagree(const LibraryTopology &topology);

/// Vertices, edges and simple faces against the boundary that they come from: its vertices come first, every arc and
/// circle is one chain of edges, extra edges cut one maximal face, and every maximal face with L loops falls apart into
/// discs: interior vertices - extra edges + simple faces = 2 - L.
std::string pieces_broken(const LibraryTopology &topology);

/// Positions lie on their spheres, edges on their circles with the left face on the axis's side, and end where their
/// angle says; added points of a free circle lie in the upright plane through its balls' centres.
std::string geometry_broken(const LibraryTopology &topology, const oracle::Balls &balls);

/// Shells, components and cells: sums, kinds, Euler characteristics, genera, the nesting's tree, scans, measures.
std::string shells_broken(const LibraryTopology &topology, const oracle::Balls &balls);

/// Every simple face is a disc of an area between nothing and its sphere, by the theorem of Gauss and Bonnet from the
/// edges on its loop; those of a maximal face add up to it. For sets without ties: edges without length have no
/// direction.
std::string face_areas_disagree(const LibraryTopology &topology, const oracle::Balls &balls);

/// Of the simple faces of a component's highest ball the start of its outer shell is the one around the highest point,
/// or one of those beside it if an extra edge runs through it. For sets without ties.
std::string start_faces_disagree(const LibraryTopology &topology, const oracle::Balls &balls);

/// All that come before the areas, and hsp_topology_check.
std::string laws_broken_by(const LibraryTopology &topology, const oracle::Balls &balls);
std::string topology_laws_broken(const oracle::Balls &balls);

#endif
