/* Tunnels in the format that programs exchange them in: the categories sb_ncbr_channel of mmcif_tunnels.dic 1.0. */
#pragma once

#include <stdbool.h>

#include "commands/pores_found.h"
#include "read/failure.h"
#include "read/molecule.h"

/* Write the atoms of the molecule and the tunnels: the radius along the length, and layers, each a stretch with the
 * same residues nearest, the last one at times the mouth alone; a residue that is near with atoms of its backbone and
 * with others has two rows. free_radius is that of the largest probe that overlaps no atom of a backbone of amino
 * acids, "?" if there are none. Charges and hydropathy, the mean of Kyte and Doolittle's, count each residue once;
 * other scales are "?". */
bool tunnel_exchange_write(const struct pores_found *found, const struct molecule *molecule, const char *path,
                           struct failure *failure);
