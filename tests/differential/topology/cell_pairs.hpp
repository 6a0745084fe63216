// Cells by two numberings.
#pragma once

#include <cstdint>
#include <map>

// Cells of the library and of an oracle, paired one to one; cell 0 is the outer one for both.
class CellPairs {
 public:
  CellPairs() { pair(0, 0); }

  // Whether this pair agrees with all before.
  bool pair(uint32_t library, uint32_t oracle) {
    return of_oracle_.try_emplace(oracle, library).first->second == library &&
           of_library_.try_emplace(library, oracle).first->second == oracle;
  }

 private:
  std::map<uint32_t, uint32_t> of_oracle_;
  std::map<uint32_t, uint32_t> of_library_;
};
