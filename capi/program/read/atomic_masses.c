#include "read/atomic_masses.h"

#include <stddef.h>
#include <stdint.h>

/* Standard atomic weights, abridged to five digits, in ten-thousandths: T. Prohaska et al., Pure Appl. Chem. 94 (2022)
 * 573, Table 3. 0: there is no isotope that one finds on Earth, and no weight. */
static const uint32_t weights[] = {
    10080,   40026,                                                                           /* H He */
    69400,   90122,   108100,  120110,  140070,  159990,  189980,  201800,                    /* Li to Ne */
    229900,  243050,  269820,  280850,  309740,  320600,  354500,  399500,                    /* Na to Ar */
    390980,  400780,                                                                          /* K Ca */
    449560,  478670,  509420,  519960,  549380,  558450,  589330,  586930,  635460,  653800,  /* Sc to Zn */
    697230,  726300,  749220,  789710,  799040,  837980,                                      /* Ga to Kr */
    854680,  876200,                                                                          /* Rb Sr */
    889060,  912240,  929060,  959500,  0,       1010700, 1029100, 1064200, 1078700, 1124100, /* Y to Cd */
    1148200, 1187100, 1217600, 1276000, 1269000, 1312900,                                     /* In to Xe */
    1329100, 1373300,                                                                         /* Cs Ba */
    1389100, 1401200, 1409100, 1442400, 0,       1503600, 1519600, 1572500, 1589300, 1625000, /* La to Dy */
    1649300, 1672600, 1689300, 1730500, 1749700,                                              /* Ho to Lu */
    1784900, 1809500, 1838400, 1862100, 1902300, 1922200, 1950800, 1969700, 2005900,          /* Hf to Hg */
    2043800, 2072000, 2089800, 0,       0,       0,                                           /* Tl to Rn */
    0,       0,       0,       2320400, 2310400, 2380300,                                     /* Fr to U */
};

double element_mass(struct element_symbol symbol) {
  const uint32_t number = element_atomic_number(symbol);
  const size_t count = sizeof weights / sizeof weights[0];
  return number == 0 || number > count ? 0.0 : weights[number - 1] / 10000.0;
}
