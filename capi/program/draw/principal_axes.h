/* The directions in which the atoms of a molecule spread most and least. */
#pragma once

struct molecule;

/* The principal axes of the atoms, all of equal weight, as axes of a view: to the right the one along which they spread
 * most, upwards the next one, towards the viewer the one along which they spread least. They are unit vectors and
 * right-handed. Water counts only if there is nothing else, so that pictures with and without it agree.
 *   Signs    The viewer is on the side of the file's z axis, and the file's y axis points upwards. If the axis is
 *            nearly at a right angle to z (or y), the other coordinates decide. No direction of small whole numbers is
 *            near the border between two choices.
 *   Ties     Variances within 2 in 100 of each other, or nearly 0, count as equal, and the file's axes decide: of two
 *            equal axes y is upwards, or z if y is nearly along the third axis; three equal axes are the file's.
 * No rule for signs is continuous everywhere; with this one noise changes nothing in molecules that are symmetric, flat
 * or along the file's axes. The results are the same bits on every machine and for every order of the atoms. */
void principal_axes(const struct molecule *molecule, double axis[3][3]);
