# Numbers beyond those of the core: integers of many limbs, doubles with bounds.
hsp_part(wide
  STANDS_ON ground)
