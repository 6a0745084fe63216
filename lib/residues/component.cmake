# Radii by the names of residues and atoms: tables, which no room of lib knows.
hsp_part(residues
  STANDS_ON ground
  HEADERS residue
  SHIMS_APART residue_radii hsp_residue
  LEVELS shims -O2)
