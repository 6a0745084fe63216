// The symbols of the periodic table.
#pragma once

#include <cstdint>

namespace hsp {

// The symbol of an atomic number, as chemists write it; empty if no element has the number.
const char *element_symbol(uint32_t atomic_number);

// The atomic number of a symbol in any case of its letters, with blanks around it; 0 if no element has it. D is
// hydrogen.
uint32_t element_number(const char *symbol);

}  // namespace hsp
