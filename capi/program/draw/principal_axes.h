/* How the atoms of a molecule are spread in space. */
#pragma once

struct molecule;

/* The principal axes of the atoms, all of equal weight, as someone looks at them: to the right the one along which they
 * spread most, upwards the next one, towards the viewer the one along which they spread least. Unit vectors,
 * right-handed. Water does not count unless there is nothing else, so that pictures with and without it agree.
 *   Signs    the viewer is on the side of the file's z axis, and the picture upright by its y axis; where z (or y) says
 *            little, the other coordinates decide. No direction of small whole numbers is near the border.
 *   Ties     variances within 2 in 100 of each other, or nearly none, count as equal, and the file decides: between
 *            two such axes y is upwards, or z where y is nearly along the third one; three such axes are the file's.
 * No rule for signs is continuous everywhere; this one does not change with noise where molecules are symmetric, flat
 * or along the file's axes. The same bits on every machine and for every order of the atoms. */
void principal_axes(const struct molecule *molecule, double axis[3][3]);
