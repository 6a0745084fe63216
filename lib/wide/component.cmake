# Numbers beyond those of the core: integers and floats of many limbs, doubles with bounds.
hsp_part(wide
  STANDS_ON ground)
