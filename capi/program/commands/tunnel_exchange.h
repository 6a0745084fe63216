/* Tunnels in the format in which programs exchange them: the categories sb_ncbr_channel of mmcif_tunnels.dic 1.0. */
#pragma once

#include <stdbool.h>

#include "commands/pores_found.h"
#include "read/failure.h"
#include "read/molecule.h"

/* Write the atoms of the molecule and the tunnels: the radius along the length, and layers. A layer is a stretch along
 * which the same residues are nearest; the last one may be the mouth alone. A residue near by with atoms of its
 * backbone and with others has two rows. free_radius is the radius of the largest probe that overlaps no backbone atom
 * of amino acids, "?" if there are none. Charges and the mean hydropathy by Kyte and Doolittle count each residue once;
 * other scales are "?". */
bool tunnel_exchange_write(const struct pores_found *found, const struct molecule *molecule, const char *path,
                           struct failure *failure);
