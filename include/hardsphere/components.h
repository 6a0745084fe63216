/* hardsphere/components.h: which components the library has beside the stable tier, each 1 or 0.
 *
 * A build of the library may leave out components (building.md). The package that it installs has zeros here for these
 * components, and lacks their headers. Programs within the same CMake project get the zeros as definitions. */
#ifndef HARDSPHERE_COMPONENTS_H
#define HARDSPHERE_COMPONENTS_H

#ifndef HSP_HAS_RESIDUES
#define HSP_HAS_RESIDUES 1 /**< residue.h */
#endif
#ifndef HSP_HAS_CURVATURE
#define HSP_HAS_CURVATURE 1 /**< curvature.h */
#endif
#ifndef HSP_HAS_MOTION
#define HSP_HAS_MOTION 1 /**< pose.h, moving.h */
#endif
#ifndef HSP_HAS_BRICKS
#define HSP_HAS_BRICKS 1 /**< bricks.h */
#endif
#ifndef HSP_HAS_BOXES
#define HSP_HAS_BOXES 1 /**< periodic.h, periodic_boundary.h; with it curvature */
#endif
#ifndef HSP_HAS_SMOOTH
#define HSP_HAS_SMOOTH 1 /**< surface.h, mesh.h */
#endif
#ifndef HSP_HAS_SPACE
#define HSP_HAS_SPACE 1 /**< cells.h, paths.h, pores.h, pockets.h; with it boxes */
#endif
#ifndef HSP_HAS_SIGHT
#define HSP_HAS_SIGHT 1 /**< view.h, map.h, sticks.h, picture.h */
#endif

#endif
